#include "engine/simulation/motion_on_carriers.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "engine/contact/pair_motion.h"
#include "engine/simulation/block_system.h"

namespace dda {
namespace {

std::size_t at(int block) { return static_cast<std::size_t>(block); }

using Pairs = std::vector<std::pair<int, int>>;

Pairs pressed_pairs(const ContactSet& contacts, const InterfaceTrials& trials, std::span<const int> bonded) {
  Pairs pressed;
  const auto add = [&](std::size_t place) {
    pressed.emplace_back(contacts.elements[place].block_a, contacts.elements[place].block_b);
  };
  for (std::size_t k = 0; k < trials.size(); ++k)
    if (std::min(trials[k].force(0), trials[k].force(2)) < 0) add(trials.place(k));
  for (const int place : bonded) add(at(place));
  return pressed;
}

class Carriers {
 public:
  Carriers(const BlockSystem& system, const Pairs& pressed)
      : system_(system), neighbours_(system.terms.area.size()), motion_(system.terms.area.size()) {
    for (const auto& [a, b] : pressed) {
      neighbours_[at(a)].push_back(b);
      neighbours_[at(b)].push_back(a);
    }
    for (int block = 0; block < static_cast<int>(motion_.size()); ++block) {
      motion_[at(block)] = motion_share(own(block), system.terms.area[at(block)]);
      if (system.held.holds(block) || rests(block)) resting_.push_back(block);
    }
  }

  // From block to block, beginning at those that rest by themselves.
  std::vector<double> follow() {
    while (!resting_.empty()) {
      const int carrier = resting_.back();
      resting_.pop_back();
      for (const int block : neighbours_[at(carrier)]) measure(block, carrier);
    }
    return std::move(motion_);
  }

 private:
  [[nodiscard]] Vec6 own(int block) const { return system_.increment.segment<6>(6 * block); }
  [[nodiscard]] Vec2 centroid(int block) const { return current_centroid(system_.model, system_.state, block); }

  // Blocks with drag move by little because of that.
  [[nodiscard]] bool rests(int block) const {
    return motion_[at(block)] <= SettlingDrag::most_motion && !system_.drag.drags(block);
  }

  void measure(int block, int carrier) {
    if (system_.held.holds(block)) return;
    const bool rested = rests(block);
    Vec6 against = own(block);
    against.head<2>() -= displacement_of(own(carrier), centroid(block) - centroid(carrier));
    against(2) -= own(carrier)(2);
    motion_[at(block)] = std::min(motion_[at(block)], motion_share(against, system_.terms.area[at(block)]));
    if (!rested && rests(block)) resting_.push_back(block);
  }

  const BlockSystem& system_;
  std::vector<std::vector<int>> neighbours_;
  std::vector<double> motion_;  // shares of each block's size
  std::vector<int> resting_;    // whose neighbours have yet to be measured
};

}  // namespace

std::vector<double> motion_on_carriers(const BlockSystem& system, const InterfaceTrials& trials,
                                       std::span<const int> bonded) {
  return Carriers(system, pressed_pairs(system.contacts, trials, bonded)).follow();
}

}  // namespace dda
