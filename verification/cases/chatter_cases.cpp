#include "verification/cases/chatter_cases.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "verification/cases/contact_rig.h"
#include "verification/exact/sliding_flutter.h"
#include "verification/suite/expect.h"

namespace verify {
namespace {

constexpr double density = 2600;
constexpr double young = 5e9;
constexpr double poisson = 0.2;
constexpr double spring = 10 * young;

// A cube of 1 m that friction just holds on an incline which, from the end of settling on, is drawn away under it at
// half a metre a second: it slides with little to set it off but that friction follows the pressure on each foot.
dda::Model drawn_away(double friction, double dt, double duration) {
  dda::Model model;
  model.materials = {{"rock", density, young, poisson, dda::PlaneState::stress}};
  model.joints = {dry_joint(std::atan(friction))};
  model.joints[0].normal_spring = spring;
  add_box(model, -1, -1, 3, 0);
  model.held_blocks = {{.block = 0,
                        .amplitude = {-0.5, 0},
                        .history = dda::PiecewiseLinear{{settling_time, settling_time + 1}, {0, 1}}}};
  add_box(model, 0, 0, 1, 1);
  const double slope = std::atan(0.999 * friction);
  model.gravity = standard_gravity * dda::Vec2(std::sin(slope), -std::cos(slope));
  model.stages = {settling_stage(), moving_stage(dda::trapezoidal_integrator(), dt, duration)};
  return model;
}

bool chatters(double friction, Outcome& outcome) {
  WatchedRun run(drawn_away(friction, 2e-5, 0.1));
  run.run_to(settling_time);
  bool lifted = false;
  while (!run.simulation().finished() && !lifted) {
    run.step();
    for (const dda::InterfaceState& foot : run.simulation().contacts().states)
      lifted = lifted || foot.status[0] == dda::ContactStatus::open;
  }
  outcome.counters += run.simulation().counters();
  return lifted;
}

// Largest friction without, and least with, found by halving.
template <typename Predicate>
double threshold(double without, double with, int halvings, const Predicate& predicate) {
  for (int i = 0; i < halvings; ++i) {
    const double middle = (without + with) / 2;
    (predicate(middle) ? with : without) = middle;
  }
  return (without + with) / 2;
}

Outcome chatter() {
  const exact::SlidingBlock block{1, 1, density, young, poisson, spring};
  const double expected =
      threshold(0.3, 0.9, 50, [&](double friction) { return exact::fastest_growth(block, friction).real() > 1; });
  Outcome outcome;
  const double found = threshold(0.3, 0.9, 8, [&](double friction) { return chatters(friction, outcome); });
  outcome.assertions.push_back(
      expect("friction from which a foot lifts", "-")
          .is(found)
          .against(expected, "first unstable eigenvalue of the sliding block (exact/sliding_flutter)")
          .within(0.01,
                  "halved to 0.002; within 1 % of the threshold vibration grows less than threefold in "
                  "0.1 s, or beats without growing"));
  return outcome;
}

}  // namespace

std::vector<Case> chatter_cases() {
  return {{"sliding-chatter", "Friction from which an elastic cube chatters", {9}, CaseLabel::fast, chatter}};
}

}  // namespace verify
