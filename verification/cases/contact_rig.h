// What the cases of sliding, impact and joint strength share: a block on a held base, stages, and a run that watches
// its energy balance.
#pragma once

#include <cmath>
#include <string>

#include "engine/model/model.h"
#include "engine/simulation/simulation.h"
#include "verification/suite/case.h"

namespace verify {

inline constexpr double standard_gravity = 9.81;  // m/s2

// Appends a rectangular block; returns its number.
int add_box(dda::Model& model, double left, double bottom, double right, double top);

// Classical law, no strength but friction.
dda::JointMaterial dry_joint(double friction_angle);

// Springs of 5e11 N/m at the four corners of a block, which follow displacement * history. Stiffer ones hold no better
// and cost digits: where a block is known to 1e-16 m, a spring of 5e13 N/m is off by 5 mN, at every step of the way.
void hold_corners(dda::Model& model, int block, const dda::Vec2& displacement = dda::Vec2::Zero(),
                  const dda::TimeFunction& history = dda::Constant{});

// A static stage of ten steps in which weight and loads come on while contacts stick: the block starts the next stage
// at rest, without its weight ringing on the contact springs.
dda::Stage settling_stage();
inline constexpr double settling_time = 0.1;  // s

dda::Stage moving_stage(const dda::Integrator& integrator, double dt, double duration);

// A history whose value at the end of every step of a stage from `start` on is f(t - start); 0 before.
template <typename Function>
dda::TimeFunction tabulated(double start, double dt, double duration, const Function& f) {
  dda::PiecewiseLinear table{{start - dt}, {0.0}};
  for (int i = 0; i * dt < duration + dt; ++i) {
    table.times.push_back(start + i * dt);
    table.values.push_back(f(i * dt));
  }
  return table;
}

// A simulation whose steps either succeed or throw std::runtime_error, and the largest energy residual of its steps.
class WatchedRun {
 public:
  explicit WatchedRun(dda::Model model);  // finishes the model

  void step();
  void run_to(double time);  // s
  void run_to_end();
  [[nodiscard]] const dda::Simulation& simulation() const { return simulation_; }
  [[nodiscard]] const dda::State& state() const { return simulation_.state(); }

  // Largest energy residual of any step so far over the largest term of the balance.
  [[nodiscard]] double energy_residual() const;

 private:
  dda::Simulation simulation_;
  double largest_residual_ = 0;  // J per m of thickness
};

// Root mean square of error(steps) over fifteen numbers of steps from `steps` to 28 % more. A block starts and stops
// somewhere within a step, and the error depends on where; the mean hardly does, so that its order can be seen.
template <typename Function>
double typical_error(int steps, const Function& error) {
  constexpr int samples = 15;
  double sum = 0;
  for (int i = 0; i < samples; ++i) sum += std::pow(error(static_cast<int>(std::lround(steps * (1 + 0.02 * i)))), 2);
  return std::sqrt(sum / samples);
}

// Order between `steps` and twice as many.
template <typename Function>
Order order_of(int steps, const Function& error, double expected) {
  return {std::log2(typical_error(steps, error) / typical_error(2 * steps, error)), expected, 0.2};
}

// The energy target of the project: 1e-8 of the work done.
Assertion energy_assertion(const std::string& run, double residual);

}  // namespace verify
