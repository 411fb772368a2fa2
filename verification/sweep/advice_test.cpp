// The engine's advice against the closed forms of this folder's neighbours, with which it shares no code, and against
// what jobs measure.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/advice/half_row.h"
#include "engine/advice/wave_errors.h"
#include "engine/contact/make_contacts.h"
#include "verification/exact/chain_modes.h"
#include "verification/exact/finite_chain.h"
#include "verification/exact/half_chain.h"
#include "verification/exact/sharpened_load.h"
#include "verification/lattice/bloch.h"
#include "verification/lattice/periodic_patch.h"
#include "verification/sweep/job.h"
#include "verification/sweep/spec.h"
#include "verification/sweep/sweep_bar.h"
#include "verification/thesis/closed_form.h"

namespace verify {
namespace {

// A chain and what the engine makes of it.
struct Problem {
  explicit Problem(const JobParameters& job)
      : parameters(job),
        bar(bar_of(job)),
        model(model_of(bar, job)),
        chain(chain_of(model)),
        scheme(time_scheme_of(job.stage.integrator)),
        lattice(dda::find_lattice(model, dda::make_contacts(model), 0).value()) {}

  [[nodiscard]] dda::TimeSteps time() const { return {parameters.stage.integrator, parameters.dt}; }
  [[nodiscard]] dda::WaveQuestion question() const {
    return {lattice, model.stages.front(), dda::WaveKind::bar, {1, 0}, bar.measuring_point};
  }

  JobParameters parameters;
  ThesisBar bar;
  dda::Model model;
  exact::BlockChain chain;
  exact::TimeScheme scheme;
  dda::Lattice lattice;
};

std::vector<Problem> problems() {
  std::vector<Problem> all;
  for (const char* grid :
       {R"({"block_length": [5], "dt": [1e-4], "spring_over_young": [4], "strain_inertia": [2]})",
        R"({"block_length": [2], "dt": [1e-5]})",
        R"({"block_length": [5], "dt": [2e-4], "law": ["consistent"], "integrator": [{"hht": 0.2}], "poisson": [0.1]})",
        R"({"eta": [0.13], "cfl": [0.5], "law": ["cubic"], "integrator": [{"generalized_alpha": 0.8}],
            "correct_time_dispersion": [true]})",
        R"({"eta": [0.2], "cfl": [0.1], "law": ["cubic"], "integrator": ["trapezoidal"], "lateral_inertia": [false]})"})
    all.emplace_back(parse_spec(std::string(R"({"grid": )") + grid + "}", "s").jobs.front());
  return all;
}

TEST(Advice, PhaseSpeedAndAttenuationAreThoseOfTheClosedForm) {
  for (const Problem& p : problems()) {
    for (const double frequency : {30.0, 100.0, 180.0}) {
      const double omega = 2 * std::numbers::pi * frequency;
      const auto wave =
          dda::WaveSolver(p.lattice, p.model.stages.front(), dda::WaveKind::bar, {1, 0}).steady(p.time(), omega);
      ASSERT_TRUE(wave.has_value());
      const exact::ChainWave closed = exact::chain_wave(p.chain, p.scheme, p.parameters.dt, omega);
      // Round-off of 6 x 6 problems whose entries span six digits.
      EXPECT_NEAR(omega / wave->wavenumber.real() / closed.speed, 1, 1e-9) << p.model.title << frequency;
      EXPECT_NEAR(-wave->wavenumber.imag(), closed.attenuation, 1e-9) << p.model.title << frequency;
    }
  }
}

// At the frequency that Bloch analysis of the whole cell gives a wave, the advice finds that wave: P and S, all ways.
TEST(Advice, WavesInMeshesAreThoseOfBlochAnalysis) {
  const dda::Material rock{"rock", 2650, 50e9, 0.25, dda::PlaneState::stress};
  for (const PeriodicMesh& mesh : {square_mesh(), brick_mesh(), sheared_mesh()}) {
    for (const dda::InterfaceLaw law : {dda::InterfaceLaw::consistent, dda::InterfaceLaw::classical}) {
      dda::JointMaterial joint;
      joint.law = law;
      joint.bonded = true;
      const dda::Model model = periodic_patch(mesh, 2, rock, joint);
      const dda::Lattice lattice = dda::find_lattice(model, dda::make_contacts(model), 0).value();
      ASSERT_NE(lattice.origin.find("everywhere"), std::string::npos);
      for (const double degrees : {0.0, 30.0, 45.0, 77.0, 135.0}) {
        const double angle = degrees * std::numbers::pi / 180;
        const dda::Vec2 direction(std::cos(angle), std::sin(angle));
        const double q = 2 * std::numbers::pi / (20 * mesh.longest_side());
        const PhaseSpeeds bloch = phase_speeds(mesh, rock, joint, q * direction);
        for (const dda::WaveKind kind : {dda::WaveKind::p, dda::WaveKind::s}) {
          const double speed = kind == dda::WaveKind::p ? bloch.p : bloch.s;
          const auto wave = dda::WaveSolver(lattice, model.stages[0], kind, direction).steady({}, speed * q);
          ASSERT_TRUE(wave.has_value());
          EXPECT_NEAR(wave->wavenumber.real() / q, 1, 1e-8) << degrees;  // square roots of eigenvalues of 1e-14
        }
      }
    }
  }
}

// Integrators that damp, so that a steady wave fades: only then the engine's way to it converges.
TEST(Advice, WhatTheEndMakesOfALoadIsThatOfTheClosedForm) {
  for (const Problem& p : problems()) {
    if (p.parameters.integrator_name != "thesis") continue;
    for (const double frequency : {50.0, 200.0}) {
      const double omega = 2 * std::numbers::pi * frequency;
      const auto row = dda::HalfRow::make(p.lattice, p.model.stages.front(), dda::WaveKind::bar, {1, 0});
      ASSERT_TRUE(row.has_value());
      for (const int joint : {1, 10}) {
        const dda::Complex engine = row->traction(p.time().square({0, omega}), joint);
        const dda::Complex closed(exact::half_chain_force(p.chain, p.scheme, p.parameters.dt, omega, joint));
        EXPECT_LT(std::abs(engine - closed), 1e-8) << p.model.title;
      }
    }
  }
}

TEST(Advice, TheTraceOfALoadIsThatOfTheClosedForm) {
  for (Problem p : problems()) {
    p.chain.blocks *= 4;  // nothing comes back, also of the high frequencies that run faster than sqrt(E/rho)
    const double period = 1 / p.bar.load_frequency;
    const dda::LoadHistory load{[&](double t) { return pulse_shape(Pulse::cycle, p.bar.load_frequency, t); }, period,
                                period, pulse_window(p.bar, Pulse::cycle)};
    const dda::PredictedTrace trace = dda::predict_trace(p.question(), load);
    const std::vector<double> pushed =
        exact::sharpened(sampled_force(p.bar, p.parameters), exact::load_sharpening(p.chain, p.parameters.dt));
    const std::vector<double> exact =
        exact::finite_chain_response(p.chain, p.scheme, p.parameters.dt, pushed,
                                     {{exact::ChainQuantity::interface_stress, p.model.measurements.front().block - 1}})
            .front();
    const auto stride = static_cast<std::size_t>(std::lround(trace.interval / p.parameters.dt));
    EXPECT_NEAR(trace.place, p.bar.measuring_point, 1e-9);
    double worst = 0;
    for (std::size_t i = 0; i < trace.values.size() && i * stride < exact.size(); ++i)
      worst = std::max(worst, std::abs(trace.values[i] + exact[i * stride] / p.bar.incident_stress()));
    EXPECT_LT(worst, 3e-5) << p.model.title;  // frequencies of a share below that are left out
  }
}

// Every error of velocity and amplitude is predicted within 20 % or 0.05 percentage points. The whole grid, 336
// readings, is docs/examples/sweeps/eta.json; README.md has its figures.
TEST(Advice, ErrorsOfAThinnedSweepArePredicted) {
  for (const char* scheme :
       {R"("law": ["classical"], "integrator": ["thesis"])",
        R"("law": ["cubic"], "integrator": [{"generalized_alpha": 0.8}], "lateral_inertia": [false],
           "correct_time_dispersion": [true])"}) {
    const SweepSpec spec = parse_spec(R"({"grid": {"eta": [0.02, 0.08, 0.125, 0.2, 0.5], "cfl": [0.1, 0.3, 1, 3],
                                          "pulse": ["cycle", "tone"], )" +
                                          std::string(scheme) + "}}",
                                      "s");
    int readings = 0;
    for (const JobParameters& job : spec.jobs) {
      if (job.samples_per_period() < 4) continue;
      const JobResult result = run_job(job, false);
      const WaveErrors& measured = result.measured.errors;
      ASSERT_TRUE(result.predicted.has_value());
      const std::string which = to_json(job).dump();
      EXPECT_TRUE(agree(measured.velocity, result.predicted->velocity))
          << measured.velocity << " " << result.predicted->velocity << " " << which;
      EXPECT_TRUE(agree(measured.amplitude, result.predicted->amplitude))
          << measured.amplitude << " " << result.predicted->amplitude << " " << which;
      readings += 2;
    }
    EXPECT_EQ(readings, 64);
  }
}

}  // namespace
}  // namespace verify
