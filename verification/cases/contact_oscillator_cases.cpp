// With v the velocity of the blocks' centroids and e their strain, the energies give two unknowns (u, e) and two modes
// in closed form.
#include "verification/cases/contact_oscillator_cases.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <string>

#include "engine/simulation/simulation.h"
#include "engine/simulation/snapshot.h"
#include "verification/cases/bar_case.h"
#include "verification/exact/time_scheme.h"
#include "verification/exact/wave_speeds.h"
#include "verification/harness/recorded_run.h"
#include "verification/suite/expect.h"

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

// At 2.3 periods of the slower mode, which is no multiple of either period.
double end_time() { return 2.3 * 2 * std::numbers::pi / modes().omega(0); }

// Distance from the exact motion at the end, of the velocity at the start; halfway the run is saved and taken up by
// another simulation.
double error_with(const dda::Integrator& integrator, int steps, dda::Counters& counters) {
  const dda::Model model = oscillator(integrator, end_time() / steps, steps);
  dda::Simulation first(model);
  advance(first, steps / 2);
  dda::Simulation second(model);
  dda::restore(second, first.state(), dda::save(first));
  advance_to_end(second);
  counters += second.counters();  // goes on counting where the first has stopped
  return (motion_of(second.state()) - exact_motion(end_time())).norm() / modes().start_velocity.norm();
}

// The same for two oscillators under the scheme's own amplification matrix.
double expected_error(const exact::TimeScheme& scheme, int steps) {
  const Modes given = modes();
  const double dt = end_time() / steps;
  Eigen::Vector4d motion;
  for (int mode = 0; mode < 2; ++mode) {
    const double theta = given.omega(mode) * dt;
    const Eigen::Matrix3d step = exact::amplification_matrix(scheme, theta);
    Eigen::Vector3d state(0, dt * given.start_velocity(mode), 0);  // u, dt v, dt^2 a
    for (int i = 0; i < steps; ++i) state = step * state;
    motion(mode) = given.omega(mode) * state(0);
    motion(mode + 2) = state(1) / dt;
  }
  return (motion - exact_motion(end_time())).norm() / given.start_velocity.norm();
}

Assertion order_of(const dda::Integrator& integrator, const exact::TimeScheme& scheme, double expected_order,
                   Outcome& outcome) {
  // The faster mode is eight times faster: omega t = 115. Its decay omega^2 dt t/4 under Eq. 5 must be small.
  const int steps = expected_order == 1 ? 64000 : 4000;
  const double coarse = error_with(integrator, steps, outcome.counters);
  const double fine = error_with(integrator, 2 * steps, outcome.counters);
  const double expected = expected_error(scheme, 2 * steps);
  Assertion assertion =
      expect("distance from the exact motion, of the start velocity, " + integrator.name, "")
          .is(fine)
          .against(expected, "powers of the scheme's amplification matrix for each mode")
          .within(1e-8,
                  "rounding of up to 128,000 steps over the distance, 5e-10 measured; the order is off by the next "
                  "terms, omega dt = 0.03 at most and a decay of 0.05");
  assertion.order = Order{order(coarse, fine), expected_order, 0.05};
  return assertion;
}

Outcome orders() {
  Outcome outcome;
  outcome.assertions = {order_of(dda::thesis_integrator(), exact::thesis_scheme(), 1, outcome),
                        order_of(dda::trapezoidal_integrator(), exact::trapezoidal(), 2, outcome),
                        order_of(dda::hht_integrator(0.1), exact::hht(0.1), 2, outcome),
                        order_of(dda::generalized_alpha_integrator(0.8), exact::generalized_alpha(0.8), 2, outcome)};
  return outcome;
}

// Amplitude of a mode after `steps` steps of omega dt = 0.05 in the slower one, over that at the start.
constexpr double theta = 0.05;
Eigen::Vector2d amplitudes_after(int steps, const dda::Integrator& integrator, Outcome& outcome) {
  const Modes given = modes();
  dda::Simulation simulation(oscillator(integrator, theta / given.omega(0), steps));
  advance(simulation, steps);
  outcome.counters += simulation.counters();
  const Eigen::Vector4d motion = motion_of(simulation.state());
  Eigen::Vector2d amplitudes;
  for (int mode = 0; mode < 2; ++mode)
    amplitudes(mode) = std::hypot(motion(mode), motion(mode + 2)) / std::abs(given.start_velocity(mode));
  return amplitudes;
}

Outcome decay_of_thesis() {
  constexpr int steps = 1500;
  Outcome outcome;
  const double amplitude = amplitudes_after(steps, dda::thesis_integrator(), outcome)(0);
  const double of_scheme = std::pow(exact::thesis_step_factor(theta), steps);
  const double dt = theta / modes().omega(0);
  const double of_limit = exact::thesis_decay(modes().omega(0), dt, steps * dt);  // 0.39
  const std::string lag = "velocity lags by half a step, which moves the measure of amplitude by theta/4 over a cycle";
  outcome.assertions = {
      {"amplitude of the slower mode after 1500 steps of theta = 0.05", "", amplitude, of_scheme,
       "(1 + theta^2/2)^(-n/2), the eigenvalue of Eq. 5", relative_error(amplitude, of_scheme), theta / 2, lag},
      {"the same against the limit of small steps", "", amplitude, of_limit, "exp(-omega^2 dt t/4)",
       relative_error(amplitude, of_limit), theta / 2 + steps * std::pow(theta, 4) / 16,
       lag + "; the limit's exponent is short by n theta^4/16"}};
  return outcome;
}

Outcome no_decay() {
  Outcome outcome;
  const Eigen::Vector2d amplitudes = amplitudes_after(3000, dda::trapezoidal_integrator(), outcome);
  for (int mode = 0; mode < 2; ++mode)
    outcome.assertions.push_back(
        expect(std::string("amplitude of the ") + (mode == 0 ? "slower" : "faster") + " mode after 3000 steps", "")
            .is(amplitudes(mode))
            .against(1, "the rule conserves the energy of every mode")
            .absolutely()
            .within(1e-10, "3000 steps of round-off and of solves of condition 1e3"));
  return outcome;
}

}  // namespace

std::vector<Case> contact_oscillator_cases() {
  return {
      {"contact-oscillator-order", "Two blocks on springs, saved and restored halfway", {4}, CaseLabel::fast, orders},
      {"contact-oscillator-thesis-decay",
       "Decay of two blocks on springs under Eq. 5",
       {4},
       CaseLabel::fast,
       decay_of_thesis},
      {"contact-oscillator-no-decay", "No decay under the trapezoidal rule", {4}, CaseLabel::fast, no_decay}};
}

}  // namespace verify
