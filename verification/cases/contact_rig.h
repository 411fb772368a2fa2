// What the cases of sliding, impact and joint strength share: a block on a held base, stages, and a run that watches
// its energy balance.
#pragma once

#include <string>

#include "dda/model/model.h"
#include "dda/simulation/simulation.h"
#include "verification/suite/case.h"

namespace verify {

inline constexpr double standard_gravity = 9.81;  // m/s2

// Appends a rectangular block; returns its number.
int add_box(dda::Model& model, double left, double bottom, double right, double top);

// Classical law, no strength but friction.
dda::JointMaterial dry_joint(double friction_angle);

// Springs at the four corners of a block, so stiff (5e13 N/m each) that 1 MN moves it by 5 nm; they follow displacement
// * history.
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

// The energy target of the project: 1e-8 of the work done.
Assertion energy_assertion(const std::string& run, double residual);

}  // namespace verify
