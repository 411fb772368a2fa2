// Catalogue 4: two equal blocks joined by springs swing against each other. With v the velocity of their centroids and
// e their strain, the blocks' energies give two unknowns (u, e) and two modes in closed form.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "dda/simulation/simulation.h"
#include "dda/simulation/snapshot.h"
#include "verification/cases/bar_case.h"
#include "verification/exact/wave_speeds.h"

namespace verify {
namespace {

constexpr double young = 2e9;
constexpr double density = 2000;
constexpr double length = 1;
constexpr double height = 0.5;
constexpr double velocity = 0.02;  // m/s, of each block towards the other

struct Modes {
  Eigen::Matrix2d shapes;          // columns, M-orthonormal
  Eigen::Vector2d omega;           // rad/s
  Eigen::Vector2d start_velocity;  // modal
};

// u, e of the right block; the left one mirrors it. Stretching of both blocks and of two springs of 10 E.
Modes modes() {
  const double spring = 2 * 10 * young;
  const double mass = density * length * height;
  const Eigen::Matrix2d m = Eigen::Vector2d(2 * mass, 2 * mass * length * length / 12).asDiagonal();
  const Eigen::Vector2d gap(2, -length);
  Eigen::Matrix2d k = spring * gap * gap.transpose();
  k(1, 1) += 2 * young * length * height;
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix2d> solver(k, m);
  return {solver.eigenvectors(), solver.eigenvalues().cwiseSqrt(),
          solver.eigenvectors().transpose() * m * Eigen::Vector2d(-velocity, 0)};
}

// Amplitudes of the modes: displacement times omega, and velocity (m/s kg^1/2).
Eigen::Vector4d exact_motion(double t) {
  const Modes given = modes();
  const Eigen::Array2d phase = given.omega.array() * t;
  Eigen::Vector4d motion;
  motion << (given.start_velocity.array() * phase.sin()).matrix(),
      (given.start_velocity.array() * phase.cos()).matrix();
  return motion;
}

dda::Model oscillator(const dda::Integrator& integrator, double dt, int steps) {
  BarCase bar = bonded_bar(dda::InterfaceLaw::classical, integrator, dt, steps);
  bar.blocks = 2;
  bar.block_length = length;
  bar.height = height;
  bar.rock = {"rock", density, young, 0, dda::PlaneState::stress};
  bar.push = [](double) { return 0.0; };
  bar.probes = {};
  dda::Model model = model_of(bar);
  model.blocks[0].initial_velocity = {velocity, 0};
  model.blocks[1].initial_velocity = {-velocity, 0};
  dda::finish_model(model);
  return model;
}

Eigen::Vector4d motion_of(const dda::State& state) {
  const Modes given = modes();
  const Eigen::Vector2d u(state.displacement[1](0), state.displacement[1](3));
  const Eigen::Vector2d v(state.velocity[1](0), state.velocity[1](3));
  Eigen::Vector4d motion;
  const Eigen::Matrix2d to_modes = given.shapes.inverse();
  motion << ((to_modes * u).array() * given.omega.array()).matrix(), to_modes * v;
  return motion;
}

void run(dda::Simulation& simulation, int steps) {
  for (int i = 0; i < steps; ++i) ASSERT_EQ(simulation.step(), dda::Status::ok);
}

// At 2.3 periods of the slower mode, which is no multiple of either period; halfway the run is saved and taken up by
// another simulation.
double error_with(const dda::Integrator& integrator, int steps) {
  const double end = 2.3 * 2 * std::numbers::pi / modes().omega(0);
  const dda::Model model = oscillator(integrator, end / steps, steps);
  dda::Simulation first(model);
  run(first, steps / 2);
  dda::Simulation second(model);
  dda::restore(second, first.state(), dda::save(first));
  run(second, steps - steps / 2);
  EXPECT_TRUE(second.finished());
  return (motion_of(second.state()) - exact_motion(end)).norm();
}

struct OrderCase {
  const char* name;
  dda::Integrator integrator;
  double order;
};

class Catalogue04 : public testing::TestWithParam<OrderCase> {};
INSTANTIATE_TEST_SUITE_P(ContactOscillator, Catalogue04,
                         testing::Values(OrderCase{"thesis", dda::thesis_integrator(), 1},
                                         OrderCase{"trapezoidal", dda::trapezoidal_integrator(), 2},
                                         OrderCase{"hht", dda::hht_integrator(0.1), 2},
                                         OrderCase{"generalized_alpha", dda::generalized_alpha_integrator(0.8), 2}),
                         [](const auto& each) { return each.param.name; });

TEST_P(Catalogue04, OrderAcrossSaveAndRestore) {
  // The faster mode is eight times faster: omega t = 115. Its decay omega^2 dt t/4 under Eq. 5 must be small.
  const int steps = GetParam().order == 1 ? 64000 : 4000;
  const double coarse = error_with(GetParam().integrator, steps);
  const double fine = error_with(GetParam().integrator, 2 * steps);
  // omega dt = 0.03 at most, and the decay 0.05: about that far the next terms move the slope.
  EXPECT_NEAR(order(coarse, fine), GetParam().order, 0.05);
}

TEST(Catalogue04Decay, Thesis) {
  const Modes given = modes();
  constexpr double theta = 0.05;
  const double dt = theta / given.omega(0);
  constexpr int steps = 1500;
  dda::Simulation simulation(oscillator(dda::thesis_integrator(), dt, steps));
  run(simulation, steps);
  const Eigen::Vector4d motion = motion_of(simulation.state());
  const double amplitude = std::hypot(motion(0), motion(2)) / std::abs(given.start_velocity(0));
  // Velocity lags by half a step, so that the two measures of amplitude differ by up to theta/4 over a cycle.
  EXPECT_NEAR(amplitude / std::pow(exact::thesis_step_factor(theta), steps), 1, theta / 2);
  const double decay = exact::thesis_decay(given.omega(0), dt, steps * dt);  // 0.39
  EXPECT_NEAR(amplitude / decay, 1, theta / 2 + steps * std::pow(theta, 4) / 16);
}

TEST(Catalogue04Decay, NoneUnderTheTrapezoidalRule) {
  const Modes given = modes();
  constexpr int steps = 3000;
  dda::Simulation simulation(oscillator(dda::trapezoidal_integrator(), 0.05 / given.omega(0), steps));
  run(simulation, steps);
  const Eigen::Vector4d motion = motion_of(simulation.state());
  // The rule conserves the energy of every mode.
  for (int mode = 0; mode < 2; ++mode)
    EXPECT_NEAR(std::hypot(motion(mode), motion(mode + 2)) / std::abs(given.start_velocity(mode)), 1, 1e-10);
}

}  // namespace
}  // namespace verify
