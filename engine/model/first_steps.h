// The first steps of a stage, which grow.
//
// Where something is let go at once every block beside it rings at its own frequency, and steps have to be short. What
// is still under way after a while is slower: no step is longer than a hundredth of the time since the stage began,
// until steps are as long as the stage's own. The first length serves for twice a hundred steps, its double, the double
// of that and so on for a hundred each.
#pragma once

#include <cmath>
#include <cstdint>

namespace dda {

struct FirstSteps {
  static constexpr std::int64_t steps_of_one_length = 100;

  double dt = 0;      // s, of the very first
  int doublings = 0;  // of dt, up to what the stage goes on with; 0: all steps are as long as the stage says

  friend bool operator==(const FirstSteps&, const FirstSteps&) = default;

  [[nodiscard]] bool grow() const { return doublings > 0; }
  [[nodiscard]] std::int64_t number() const { return grow() ? (doublings + 1) * steps_of_one_length : 0; }
  // s, of all of them.
  [[nodiscard]] double duration() const {
    return grow() ? std::ldexp(static_cast<double>(steps_of_one_length) * dt, doublings) : 0;
  }

  // The length of a step of the stage (counted from 0) that is one of them, and how long after the stage it begins, s.
  [[nodiscard]] double dt_of(std::int64_t step) const { return std::ldexp(dt, doublings_before(step)); }
  [[nodiscard]] double time_of(std::int64_t step) const {
    const int before = doublings_before(step);
    return std::ldexp(static_cast<double>(step - before * steps_of_one_length) * dt, before);
  }

 private:
  [[nodiscard]] static int doublings_before(std::int64_t step) {
    return step < 2 * steps_of_one_length ? 0 : static_cast<int>(step / steps_of_one_length) - 1;
  }
};

}  // namespace dda
