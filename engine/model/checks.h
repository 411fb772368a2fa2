// Small checks shared by what finish_model looks at; each throws InputError with the field's full name.
#pragma once

#include <string>
#include <string_view>

#include "engine/core/types.h"
#include "engine/model/model.h"

namespace dda::model_checks {

// An element of one of the model's vectors, for error sentences: blocks "bar 4", or loads[3] without a name.
class Item {
 public:
  Item(std::string_view list, std::size_t index, std::string_view name = "")
      : list_(list), index_(index), name_(name) {}

  void positive(std::string_view member, double value) const;
  void not_negative(std::string_view member, double value) const;
  void within(std::string_view member, double value, double lowest, double highest) const;
  void finite(std::string_view member, double value) const;
  void finite(std::string_view member, const Vec2& value) const;
  void finite(std::string_view member, const Vec3& value) const;
  void index(std::string_view member, int value, std::size_t count) const;
  [[noreturn]] void fail(std::string_view member, const std::string& value, const std::string& expected) const;

 private:
  std::string_view list_;
  std::size_t index_;
  std::string_view name_;
};

// That the numbers of a history are those of a function of time.
void check_history(const Item& item, const TimeFunction& history);

// That `point` is one of `block`, up to point_tolerance.
void check_point(const Model& model, const Item& item, int block, const Vec2& point);

}  // namespace dda::model_checks
