// Writes memory as bytes, and reads it back. What has memory says itself what of it is to be kept:
//
//   template <typename Self, typename Archive>
//   static void visit(Self& self, Archive& archive) {
//     auto& [kept, scratch] = self;  // every member is named here: one more, and this no longer compiles
//     archive(kept);
//   }
//
// with Self constant or not. An archive takes numbers, enumerations, Eigen's matrices, pairs, arrays and lists of
// these, and whatever visits itself.
#pragma once

#include <fmt/format.h>

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstring>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/core/error.h"

namespace dda {

class Simulation;

template <typename Derived>
class Archive {
 public:
  template <typename... Parts>
  void operator()(Parts&&... parts) {
    (one(parts), ...);
  }

  // The parts of a list whose length follows from the model.
  template <typename List>
  void each(List& list) {
    for (auto& part : list) one(part);
  }

 private:
  [[nodiscard]] Derived& self() { return static_cast<Derived&>(*this); }

  template <typename Part>
  void one(Part& part) {
    using Value = std::remove_const_t<Part>;
    if constexpr (std::is_arithmetic_v<Value> || std::is_enum_v<Value>) {
      self().raw(&part, sizeof part);
    } else if constexpr (requires { Value::SizeAtCompileTime; }) {
      matrix(part);
    } else if constexpr (requires { Value::visit(part, self()); }) {
      Value::visit(part, self());
    } else {
      container(part);
    }
  }

  template <typename Matrix>
  void matrix(Matrix& values) {
    if constexpr (std::remove_const_t<Matrix>::SizeAtCompileTime == Eigen::Dynamic) self().length_of(values);
    self().raw(values.data(), static_cast<std::size_t>(values.size()) * sizeof(double));
  }

  template <typename First, typename Second>
  void container(std::pair<First, Second>& pair) {
    one(pair.first);
    one(pair.second);
  }
  template <typename First, typename Second>
  void container(const std::pair<First, Second>& pair) {
    one(pair.first);
    one(pair.second);
  }
  template <typename Part, std::size_t size>
  void container(std::array<Part, size>& array) {
    each(array);
  }
  template <typename Part, std::size_t size>
  void container(const std::array<Part, size>& array) {
    each(array);
  }
  template <typename Part>
  void container(std::vector<Part>& list) {
    self().length_of(list);
    each(list);
  }
  template <typename Part>
  void container(const std::vector<Part>& list) {
    self().length_of(list);
    each(list);
  }
};

class MemoryWriter : public Archive<MemoryWriter> {
 public:
  void raw(const void* from, std::size_t count) {
    if (count == 0) return;
    const std::size_t end = bytes_.size();
    bytes_.resize(end + count);
    std::memcpy(bytes_.data() + end, from, count);
  }
  template <typename List>
  void length_of(const List& list) {
    number(static_cast<std::size_t>(list.size()));
  }
  // The number of things of one kind, which reading compares.
  void same(std::size_t count, const char* /*what*/) { number(count); }
  template <typename List>
  void same_size(const List& list, const char* what) {
    same(list.size(), what);
  }
  // A simulation within another.
  void run(const Simulation& simulation);
  [[nodiscard]] std::vector<std::byte> take() { return std::move(bytes_); }

 private:
  void number(std::size_t value) { raw(&value, sizeof value); }

  std::vector<std::byte> bytes_;
};

// Throws InputError (without a file) where the bytes do not fit.
class MemoryReader : public Archive<MemoryReader> {
 public:
  explicit MemoryReader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  void raw(void* to, std::size_t count) {
    if (count > bytes_.size()) throw InputError("", "checkpoint", "cut off", "the whole state of a simulation");
    if (count > 0) std::memcpy(to, bytes_.data(), count);
    bytes_ = bytes_.subspan(count);
  }
  template <typename List>
  void length_of(List& list) {
    const std::size_t size = number();
    if (size > bytes_.size()) throw InputError("", "checkpoint", "cut off", "the whole state of a simulation");
    if constexpr (requires { list.segment(0, 1); }) {
      list.resize(static_cast<Eigen::Index>(size));
    } else {
      list.resize(size);
    }
  }
  void same(std::size_t count, const char* what) {
    const std::size_t saved = number();
    if (saved != count)
      throw InputError("", "checkpoint", fmt::format("of a scene with {} {}", saved, what),
                       fmt::format("one with {} {} as this scene has", count, what));
  }
  template <typename List>
  void same_size(const List& list, const char* what) {
    same(list.size(), what);
  }
  void run(Simulation& simulation);
  void expect_end() const {
    if (!bytes_.empty()) throw InputError("", "checkpoint", "too long", "the state of one simulation");
  }

 private:
  [[nodiscard]] std::size_t number() {
    std::size_t value = 0;
    raw(&value, sizeof value);
    return value;
  }

  std::span<const std::byte> bytes_;
};

}  // namespace dda
