// The structure of a DXF file: header, blocks (symbols that are drawn once and put in many places) and entities.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/types.h"
#include "engine/drawing/dxf_groups.h"

namespace dda {

// One entity with its groups in the order of the file. Numbers are those of the file, in its units.
class DxfEntity {
 public:
  DxfEntity(std::string_view type, std::string origin) : type_(type), origin_(std::move(origin)) {}
  void add(const DxfGroup& group) { groups_.push_back(group); }

  [[nodiscard]] std::string_view type() const { return type_; }
  [[nodiscard]] const std::string& origin() const { return origin_; }  // "plan.dxf line 214"
  [[nodiscard]] const std::vector<DxfGroup>& groups() const { return groups_; }

  [[nodiscard]] std::string text(int code, std::string_view otherwise = "") const;
  [[nodiscard]] double number(int code, double otherwise = 0) const;
  [[nodiscard]] int whole(int code, int otherwise = 0) const;
  [[nodiscard]] Vec2 point(int x_code) const;  // y has the code 10 further on
  // The same for what every entity of its type has: InputError where it is missing, as in a file that was cut short and
  // mended, or written by hand. (Zero would be a line to the origin, an arc of a whole turn.)
  [[nodiscard]] double needed_number(int code) const;
  [[nodiscard]] Vec2 needed_point(int x_code) const;
  [[nodiscard]] std::vector<double> numbers(int code) const;
  [[nodiscard]] double number_of(const DxfGroup& group) const;
  // What follows `key` in the extended data of our own; empty where there is none.
  [[nodiscard]] std::string extended(const std::string& key) const;

 private:
  [[nodiscard]] const DxfGroup* find(int code) const;
  std::string_view type_;
  std::string origin_;
  std::vector<DxfGroup> groups_;
};

struct DxfBlock {
  Vec2 base = Vec2::Zero();
  std::vector<DxfEntity> entities;
};

struct DxfFile {
  int unit = 0;  // $INSUNITS
  std::map<std::string, DxfBlock> blocks;
  std::vector<DxfEntity> entities;
};

// `text` must outlive the result. Throws InputError naming the line.
DxfFile parse_dxf(std::string_view text, const std::string& name);

}  // namespace dda
