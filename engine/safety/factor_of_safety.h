// The factor by which the strength of all joints can be divided until the rock no longer stands.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/safety/standing.h"

namespace dda {

struct SafetyQuestion {
  double time = 0;       // s, at which loads and prescribed motions are taken
  double most = 64;      // the factor is looked for between 1/most and this
  double width = 0.005;  // of the interval in which it lies, as a share of the factor
  int jobs = 2;          // runs at once, each on a thread of its own
};

// One run of the search.
struct SafetyTrial {
  double factor = 1;
  bool stands = false;
  Status status = Status::ok;
  std::string reason;
  double largest_movement = 0;  // in sizes of the block
};

struct SafetyReport {
  double stands = 0;                // the greatest factor at which the rock was seen to stand; 0: none
  double fails = 0;                 // the least one above that at which it was not; 0: none up to `most`
  std::vector<SafetyTrial> trials;  // in the order of the search
  Standing failure;                 // of the rock at `fails`; at 1/most where it stands at none

  [[nodiscard]] bool is_bracketed() const { return stands > 0 && fails > 0; }
  // The middle of the interval, by ratio.
  [[nodiscard]] double factor() const;
};

// Doubles or halves the factor until it is bracketed, and then parts the interval in equal ratios again and again: in
// three by one or two jobs, which find the same to the last bit, in N + 1 by N. So the interval that is found depends
// on the number of jobs from three on, its width does not. Which runs are needed is known once those before them have
// ended: what several jobs have begun in vain is given up and not told. `progress` is called with every run that
// counts, in order.
[[nodiscard]] SafetyReport factor_of_safety(const Model& model, const SafetyQuestion& question,
                                            const std::function<void(const SafetyTrial&)>& progress = {});

// The same with joints that keep their cohesion and friction as they slide, where that is more than `lost`, the answer
// for joints that lose them. Where the first run, at just above that, fails, or joints have nothing to lose, it stands
// at no factor.
//
// Rock that loses strength fails when its first joint does, and what strains blocks can load a joint more than their
// equilibrium asks for: by what a block pushes as it swells sideways between its plane and a wall, say. Limit
// equilibrium knows of neither, so this is what to compare it with.
[[nodiscard]] SafetyReport factor_of_kept_strength(const Model& model, const SafetyQuestion& question,
                                                   const SafetyReport& lost,
                                                   const std::function<void(const SafetyTrial&)>& progress = {});

}  // namespace dda
