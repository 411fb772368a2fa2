#include "engine/contact/interface_elements.h"

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <unordered_set>
#include <utility>

namespace dda {
namespace {

template <typename Value>
bool have_same_bits(const Value& one, const Value& other) {
  return std::memcmp(&one, &other, sizeof(Value)) == 0;
}

bool have_same_stress_rows(const InterfaceElement& a, const InterfaceElement& b) {
  return have_same_bits(a.stress_rows_a, b.stress_rows_a) && have_same_bits(a.stress_rows_b, b.stress_rows_b) &&
         have_same_bits(a.strain_rows_a, b.strain_rows_a) && have_same_bits(a.strain_rows_b, b.strain_rows_b);
}

// To the last bit, but for the blocks.
bool are_alike(const InterfaceElement& a, const InterfaceElement& b) {
  return a.law == b.law && have_same_bits(a.rows_a, b.rows_a) && have_same_bits(a.rows_b, b.rows_b) &&
         have_same_bits(a.stiffness, b.stiffness) && have_same_bits(a.dashpot, b.dashpot) &&
         have_same_bits(a.length, b.length) && have_same_bits(a.lever, b.lever) && have_same_bits(a.spread, b.spread) &&
         have_same_bits(a.softness, b.softness) && have_same_bits(a.beside_stress_a, b.beside_stress_a) &&
         have_same_bits(a.beside_stress_b, b.beside_stress_b) && have_same_bits(a.by_loads, b.by_loads) &&
         have_same_bits(a.gap_at_start, b.gap_at_start) && have_same_bits(a.force_at_start, b.force_at_start) &&
         (!has_stress_rows(a) || have_same_stress_rows(a, b));
}

// Hashes the first two rows, in which interfaces that differ mostly do.
struct Hash {
  const std::vector<InterfaceElement>& kept;
  std::size_t operator()(int number) const {
    const InterfaceElement& element = kept[static_cast<std::size_t>(number)];
    std::uint64_t hash = 0;
    for (const Mat46* rows : {&element.rows_a, &element.rows_b})
      for (Eigen::Index k = 0; k < 12; ++k) {
        std::uint64_t word = 0;
        std::memcpy(&word, rows->data() + k, sizeof word);
        hash = (hash ^ (word >> 17)) * 0x9e3779b97f4a7c15 + word;
      }
    return hash ^ (hash >> 32);
  }
};

struct Alike {
  const std::vector<InterfaceElement>& kept;
  bool operator()(int one, int other) const {
    return are_alike(kept[static_cast<std::size_t>(one)], kept[static_cast<std::size_t>(other)]);
  }
};

}  // namespace

InterfaceElement InterfaceElements::operator[](std::size_t i) const {
  InterfaceElement room;
  return read(i, room);
}

const InterfaceElement& InterfaceElements::fetched(std::size_t i, InterfaceElement& room) const {
  room = but_for_blocks(i);
  room.block_a = places_[i].block_a;
  room.block_b = places_[i].block_b;
  return room;
}

const std::vector<InterfaceElement>& InterfaceElements::own() const {
  if (!places_.empty()) throw std::logic_error("InterfaceElements: shared where each was to have its own");
  return kept_;
}

std::vector<InterfaceElement>& InterfaceElements::edit() {
  if (places_.empty()) return kept_;
  std::vector<InterfaceElement> all;
  all.reserve(places_.size());
  for (std::size_t i = 0; i < places_.size(); ++i) all.push_back((*this)[i]);
  kept_ = std::move(all);
  places_ = {};
  return kept_;
}

void InterfaceElements::share() {
  constexpr std::size_t trial = 4096;
  if (!places_.empty()) return;
  std::vector<InterfaceElement> kinds;
  std::vector<Place> places;
  places.reserve(kept_.size());
  std::unordered_set<int, Hash, Alike> numbers(0, Hash{kinds}, Alike{kinds});
  for (const InterfaceElement& element : kept_) {
    kinds.push_back(element);
    const auto [found, is_new] = numbers.insert(static_cast<int>(kinds.size()) - 1);
    if (!is_new) kinds.pop_back();
    places.push_back({element.block_a, element.block_b, *found});
    if (kinds.size() > trial && 2 * kinds.size() > places.size()) return;
  }
  if (2 * kinds.size() > places.size()) return;
  kinds.shrink_to_fit();
  kept_ = std::move(kinds);
  places_ = std::move(places);
}

}  // namespace dda
