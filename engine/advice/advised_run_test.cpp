// What is predicted happens: runs of the scenes that the advice is about. Bars in full: verification/sweep.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dda/advice/lattice_test_support.h"
#include "dda/advice/wave_errors.h"
#include "dda/simulation/simulation.h"

namespace dda {
namespace {

constexpr int blocks = 80;
constexpr int joint_number = 12;
constexpr double cycles = 3;

double tone(double t, double frequency) {
  const double duration = cycles / frequency;
  if (t <= 0 || t >= duration) return 0;
  return std::pow(std::sin(std::numbers::pi * t / duration), 2) * std::sin(2 * std::numbers::pi * frequency * t);
}

// A course of squares between rollers: what every course of a mesh is in a P wave along it. By symmetry the middle of
// the joint between two courses stands still: half of each of its springs, twice as stiff, or as good as none of its
// own.
Model course_between_rollers(const JointMaterial& joint, const Integrator& integrator, double dt, double frequency) {
  Model model;
  model.materials = {rock()};
  model.joints = {joint};
  for (int i = 0; i < blocks; ++i) {
    model.blocks.emplace_back().shape.outer = box_ring(i, 0, i + 1, 1);
    for (const double x : {i + 0.0, i + 1.0})
      for (const double y : {0.0, 1.0}) {
        PointSupport roller;
        roller.block = i;
        roller.point = {x, y};
        roller.holds_x = false;
        roller.stiffness =
            (joint.law == InterfaceLaw::classical ? 2 * joint.spring_over_young : 1e6) * model.materials[0].young;
        model.supports.push_back(roller);
      }
  }
  PiecewiseLinear history;
  for (int i = 0; i * dt < 2 * cycles / frequency; ++i) {
    history.times.push_back(i * dt);
    history.values.push_back(tone(i * dt, frequency));
  }
  model.edge_loads.push_back({0, {0, 1}, {0, 0}, {1, 0}, history});
  model.stages = {steps(integrator, dt)};
  model.stages[0].duration = 1;
  finish_model(model);
  return model;
}

// Pressure at the joint, over the load's.
std::vector<double> run(const Model& model, std::size_t samples) {
  Simulation simulation(model);
  std::vector<double> trace{0};
  const ContactSet& contacts = simulation.contacts();
  while (trace.size() < samples) {
    EXPECT_EQ(simulation.step(), Status::ok) << simulation.message();
    for (std::size_t i = 0; i < contacts.interfaces.size(); ++i)
      if (contacts.interfaces[i].block_a == joint_number - 1 && contacts.interfaces[i].block_b == joint_number)
        trace.push_back(
            -mean_traction(model, contacts.interfaces[i], contacts.elements[i], simulation.interface_state(i)).x());
  }
  return trace;
}

TEST(AdvisedRun, PWaveAlongTheCoursesOfAMesh) {
  for (const InterfaceLaw law : {InterfaceLaw::consistent, InterfaceLaw::classical}) {
    for (const Integrator& integrator : {thesis_integrator(), generalized_alpha_integrator(0.8)}) {
      const Lattice lattice = lattice_of(courses(bonded(law), 0));
      const double speed = continuum_speed(lattice.material, WaveKind::p);
      const double frequency = speed / 12;
      const double dt = 0.3 / speed;
      const WaveQuestion question{lattice, steps(integrator, dt), WaveKind::p, {1, 0}, joint_number};
      const double window = 2 * joint_number / speed + 2 * cycles / frequency;
      const LoadHistory load{[&](double t) { return tone(t, frequency); }, cycles / frequency, 1 / frequency, window};
      const PredictedTrace predicted = predict_trace(question, load);
      ASSERT_TRUE(predicted.with_end);
      ASSERT_EQ(predicted.interval, dt);
      const std::vector<double> measured =
          run(course_between_rollers(bonded(law), integrator, dt, frequency), predicted.values.size());
      for (std::size_t i = 0; i < measured.size(); ++i)
        EXPECT_NEAR(measured[i], predicted.values[i], 1e-4) << i;  // rollers yield by 1e-6, 3e-5 is left out
    }
  }
}

}  // namespace
}  // namespace dda
