// Writes memory as bytes, and reads it back. What has memory says itself what of it is to be kept:
//
//   template <typename Self, typename Archive>
//   static void visit(Self& self, Archive& archive) {
//     auto& [kept, scratch] = self;  // every member is named here: one more, and this no longer compiles
//     archive(kept);
//   }
//
// with Self constant or not. An archive takes numbers, enumerations (archived_enumerations.h), Eigen's matrices, pairs,
// arrays and lists of these, and whatever visits itself. Numbers that stand for something else - a block, a joint, a
// vertex, a stage - are given to the verb of that name, and lists that follow the blocks to `of_blocks`: what is read
// is then checked against the scene, since a file can be damaged and its checksum be right. What has to fit in other
// ways is said with `expect`. The size in memory of what visits itself goes along, once for each kind: it tells a file
// that a program with other members has written.
#pragma once

#include <fmt/format.h>

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <type_traits>
#include <unordered_set>
#include <utility>
#include <vector>

#include "engine/core/error.h"
#include "engine/simulation/archived_enumerations.h"

namespace dda {

class Simulation;

// How many there are of what numbers in a snapshot stand for.
struct ArchivedCounts {
  std::size_t blocks = 0, joints = 0, vertices = 0, stages = 0;
};

// Its place in memory stands for a type.
template <typename Kind>
inline const char place_of_kind = 0;

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

  // Numbers of blocks, joints, vertices of all outlines, and stages.
  template <typename... Numbers>
  void blocks(Numbers&... numbers) {
    (number_below(numbers, &ArchivedCounts::blocks), ...);
  }
  template <typename... Numbers>
  void blocks_or_none(Numbers&... numbers) {  // -1: none
    (number_below(numbers, &ArchivedCounts::blocks, -1), ...);
  }
  template <typename Number>
  void joints(Number& number) {
    number_below(number, &ArchivedCounts::joints);
  }
  template <typename... Numbers>
  void vertices(Numbers&... numbers) {
    (number_below(numbers, &ArchivedCounts::vertices), ...);
  }
  template <typename Number>
  void stages(Number& number) {
    number_below(number, &ArchivedCounts::stages);
  }
  template <typename Pairs>
  void pairs_of_blocks(Pairs& pairs) {
    self().length_of(pairs);
    for (auto& [first, second] : pairs) blocks(first, second);
  }

  template <typename List>
  void lists_blocks(List& list) {
    self().length_of(list);
    for (auto& block : list) blocks(block);
  }

  // A list with so many entries for each block of the scene, or with none at all.
  template <typename List>
  void of_blocks(List& list, std::size_t entries = 1) {
    one(list);
    self().fits_blocks(static_cast<std::size_t>(list.size()), entries);
  }

 private:
  [[nodiscard]] Derived& self() { return static_cast<Derived&>(*this); }

  template <typename Number>
  void number_below(Number& number, std::size_t ArchivedCounts::*count, int least = 0) {
    one(number);
    self().is_below(static_cast<std::int64_t>(number), count, least);
  }

  template <typename Part>
  void one(Part& part) {
    using Value = std::remove_const_t<Part>;
    if constexpr (std::is_same_v<Value, bool> || std::is_enum_v<Value>) {
      self().choice(part);
    } else if constexpr (std::is_arithmetic_v<Value>) {
      self().raw(&part, sizeof part);
    } else if constexpr (requires { Value::SizeAtCompileTime; }) {
      matrix(part);
    } else if constexpr (requires { Value::visit(part, self()); }) {
      if (kinds_.insert(&place_of_kind<Value>).second) self().same_layout(sizeof(Value));
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

  std::unordered_set<const char*> kinds_;  // that have been met
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
  template <typename Choice>
  void choice(const Choice& value) {
    raw(&value, sizeof value);
  }
  void same_layout(std::size_t bytes) { number(bytes); }
  void is_below(std::int64_t /*number*/, std::size_t ArchivedCounts::* /*count*/, int /*least*/) {}
  void fits_blocks(std::size_t /*size*/, std::size_t /*entries*/) {}
  void expect(bool /*fits*/) {}
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
  // Numbers are checked against the counts of this scene from now on.
  void check_against(const ArchivedCounts& counts) { counts_ = counts; }

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
  template <typename Choice>
  void choice(Choice& value) {
    std::conditional_t<sizeof(Choice) == 1, std::uint8_t, std::int32_t> bits = 0;
    static_assert(sizeof bits == sizeof value);
    raw(&bits, sizeof bits);
    expect(bits >= 0 && bits <= static_cast<int>(last_of(Choice{})));
    value = static_cast<Choice>(bits);
  }
  void same_layout(std::size_t bytes) {
    if (number() != bytes)
      throw InputError("", "checkpoint", "of another version of this program, or damaged", "one of this program");
  }
  void is_below(std::int64_t number, std::size_t ArchivedCounts::*count, int least) {
    expect(!counts_ || (number >= least && number < static_cast<std::int64_t>(*counts_.*count)));
  }
  void fits_blocks(std::size_t size, std::size_t entries) {
    expect(!counts_ || size == 0 || size == entries * counts_->blocks);
  }
  void expect(bool fits) {
    if (!fits) throw InputError("", "checkpoint", "damaged (its numbers do not fit)", "an intact file");
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
  std::optional<ArchivedCounts> counts_;
};

}  // namespace dda
