// Boxes that ride up on their joint, are drawn back and come down, where pressure lets go of the shear faster than the
// springs do: mu tan(psi) k_n > k_s (contact/rising_end.h).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "engine/simulation/lot.h"
#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

// A box on a held floor under a pressure that stays, both of its lower corners moved along the floor from stage to
// stage.
struct ShearBox {
  double length, height, pressure;           // m, m, Pa
  double friction, rise, end_of_rise;        // tangents; m, slip
  double normal_stiffness, shear_stiffness;  // Pa/m
  std::vector<double> path;                  // m, where the corners are at the ends of stages of one second
};

ShearBox random_box(Lot& lot) {
  ShearBox box;
  box.length = lot.between(0.5, 2);
  box.height = lot.between(0.1, 0.5) * box.length;
  box.pressure = lot.power(4, 6.5);
  box.friction = std::tan(lot.between(0.4, 0.9));
  box.rise = lot.between(0.2, 0.8) * box.friction;
  box.shear_stiffness = lot.power(9, 10);
  box.normal_stiffness = lot.between(1.05, 6) * box.shear_stiffness / (box.friction * box.rise);
  const double slips_at = box.friction * box.pressure / box.shear_stiffness;
  box.end_of_rise = lot.chance(0.5) ? slips_at * lot.between(0.5, 3) : std::numeric_limits<double>::infinity();
  double at = 0.9;
  box.path = {0.5 * slips_at, at * slips_at};
  for (int turn = lot.one_of(3, 6); turn > 0; --turn) {
    at += (lot.chance(0.5) ? 1 : -1) * lot.between(0.3, 3);
    box.path.push_back(at * slips_at);
  }
  return box;
}

Model model_of(const ShearBox& box, const Stage& first, const Stage& stage) {
  Model model;
  model.materials = {{"rock", 2500, 2e11, 0.2, PlaneState::strain}};
  JointMaterial joint;
  joint.law = InterfaceLaw::classical;
  joint.normal_stiffness = box.normal_stiffness;
  joint.shear_stiffness = box.shear_stiffness;
  joint.friction_angle = std::atan(box.friction);
  joint.dilation_angle = std::atan(box.rise);
  joint.zero_dilation_slip = box.end_of_rise;
  model.joints = {joint};
  model.blocks = {rectangle("floor", -box.length, -1, 3 * box.length, 1),
                  rectangle("box", 0, 0, box.length, box.height)};
  model.held_blocks.emplace_back().block = 0;
  model.edge_loads.push_back({1, {box.length, box.height}, {0, box.height}, {0, -box.pressure}, Constant{}});
  PiecewiseLinear along{{1}, {0}};
  model.stages = {first};
  for (const double place : box.path) {
    model.stages.push_back(stage);
    along.times.push_back(static_cast<double>(model.stages.size()));
    along.values.push_back(place);
  }
  for (const double x : {0.0, box.length}) model.supports.push_back({1, {x, 0}, true, false, 1e13, Vec2(1, 0), along});
  return model;
}

struct Answer {
  double shear = 0;   // N per m of thickness
  double height = 0;  // m, ridden up
};

// Under a pressure that stays a spring of stiffness k_s and a slider of mu p in line: on a straight way the slider goes
// once its spring has all it bears.
class ByHand {
 public:
  explicit ByHand(const ShearBox& box) : box_(box) {}

  Answer after(double place) {
    const double most = box_.friction * box_.pressure;
    const double shear = std::clamp(box_.shear_stiffness * (place - slip_), -most, most);
    slip_ = place - shear / box_.shear_stiffness;
    return {shear * box_.length, box_.rise * std::min(std::abs(slip_), box_.end_of_rise)};
  }

 private:
  const ShearBox& box_;
  double slip_ = 0;
};

Answer answer_of(const Simulation& simulation, double height_at_first) {
  const ContactSet& contacts = simulation.contacts();
  Answer answer;
  for (std::size_t i = 0; i < contacts.states.size(); ++i) {
    const InterfaceElement& element = contacts.elements.own()[i];
    const Vec2 along(element.rows_b(1, 0), element.rows_b(1, 1));
    const double side = element.block_b == 1 ? 1 : -1;
    answer.shear += side * along.x() * (contacts.states[i].force(1) + contacts.states[i].force(3));
  }
  answer.height = simulation.state().displacement[1](1) - height_at_first;
  return answer;
}

// Stages take one second each.
void run_stage(Simulation& simulation, std::size_t stage) {
  while (simulation.state().time < static_cast<double>(stage + 1) - 1e-9)
    ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
}

// Runs all stages; the tolerances are shares of the largest shear and of the largest height.
void expect_as_by_hand(const ShearBox& box, const Model& model, double of_shear, double of_height) {
  Simulation simulation = simulation_of(model);
  ASSERT_NO_FATAL_FAILURE(run_stage(simulation, 0));
  const double height_at_first = simulation.state().displacement[1](1);
  ByHand by_hand(box);
  double highest = 0;
  for (std::size_t stage = 1; stage <= box.path.size(); ++stage) {
    ASSERT_NO_FATAL_FAILURE(run_stage(simulation, stage));
    const Answer expected = by_hand.after(box.path[stage - 1]);
    const Answer answer = answer_of(simulation, height_at_first);
    highest = std::max(highest, expected.height);
    EXPECT_NEAR(answer.shear, expected.shear, of_shear * box.friction * box.pressure * box.length) << stage;
    EXPECT_NEAR(answer.height, expected.height, of_height * highest + 1e-3 * box.pressure / box.normal_stiffness)
        << stage;
  }
  EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-9);
}

// The block gives way a little itself, which is what the tolerances are for. Before ends kept their height for a step
// 13 of 60 were off, by up to all of it: one of the two ends had been lost on the way back.
TEST(ShearBoxDescent, BoxesAtRestComeDownByWhatTheySlideBack) {
  for (int seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    Lot lot(seed);
    const ShearBox box = random_box(lot);
    Stage stage = settling_stage(1e-9, 1);
    if (seed % 2 == 0) stage.kinematics = Kinematics::small;
    expect_as_by_hand(box, model_of(box, stage, stage), 2e-3, 2e-2);
  }
}

// In motion, moved slowly beside how fast it swings, and damped. What is left is inertia, the share of the last step in
// the height, and what the ends exchange as they settle.
TEST(ShearBoxDescent, BoxesInMotionComeDownInFewPasses) {
  for (int seed = 1; seed <= 12; ++seed)
    for (const Integrator& integrator : {generalized_alpha_integrator(0.0), energy_conserving_integrator()}) {
      SCOPED_TRACE(integrator.name + " " + std::to_string(seed));
      Lot lot(seed);
      const ShearBox box = random_box(lot);
      Stage stage = stage_of(integrator, 2e-3, 500, Kinematics::finite);
      stage.damping_rate = 20;
      expect_as_by_hand(box, model_of(box, settling_stage(1e-9, 1), stage), 2e-2, 5e-2);
    }
}

}  // namespace
}  // namespace dda
