// One job: what it measures, and what the closed forms say.
#include "verification/sweep/job.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "verification/sweep/spec.h"
#include "verification/sweep/sweep_bar.h"

namespace verify {
namespace {

JobParameters parameters(const std::string& grid) { return parse_spec(R"({"grid": )" + grid + "}", "s").jobs.front(); }

TEST(Job, ReadsAWaveThatIsLateAndWeak) {
  const JobParameters job = parameters(R"({"block_length": [2], "dt": [5e-5]})");
  const ThesisBar bar = bar_of(job);
  for (const Pulse pulse : {Pulse::cycle, Pulse::tone}) {
    std::vector<double> history;
    const double on_time = bar.measuring_point / bar.wave_speed(), lag = 2e-4;
    for (double t = 0; t < pulse_window(bar, pulse) + 1e-3; t += job.dt)
      history.push_back(-0.9 * bar.incident_stress() * pulse_shape(pulse, bar.load_frequency, t - on_time - lag));
    const WaveReadings readings = read_wave(bar, pulse, history, job.dt);
    EXPECT_NEAR(readings.errors.velocity, 100 * (on_time / (on_time + lag) - 1), 1e-3);
    EXPECT_NEAR(readings.errors.amplitude, -10, 1e-3);
    EXPECT_NEAR(readings.half_range, -10, 0.01);  // between two samples the peak falls by (pi/200)^2/2 at most
    EXPECT_EQ(readings.onset_velocity.has_value(), pulse == Pulse::cycle);
  }
}

TEST(Job, IsTheClosedFormOfItsPulse) {
  for (
      const char* grid :
      {R"({"block_length": [5], "dt": [1e-4], "spring_over_young": [4], "strain_inertia": [2]})",
       R"({"eta": [0.13], "cfl": [0.2], "law": ["cubic"], "integrator": [{"generalized_alpha": 0.8}],
            "correct_time_dispersion": [true], "pulse": ["tone"]})",
       R"({"block_length": [5], "dt": [1e-4], "law": ["consistent"], "integrator": [{"hht": 0.2}], "poisson": [0.1]})"}) {
    const JobResult result = run_job(parameters(grid), true);
    EXPECT_LT(*result.largest_difference, 1e-9) << grid;  // the closed form is good to 1e-11
    EXPECT_NEAR(result.measured.errors.velocity, result.closed_form->velocity, 1e-5) << grid;
  }
}

TEST(Job, TheToneIsPredicted) {
  const JobResult springs = run_job(parameters(R"({"block_length": [1], "dt": [1e-4], "pulse": ["tone"]})"), false);
  EXPECT_FALSE(springs.closed_form);
  // Leading orders: -eta_s/2 = -1/40 and omega^2 dt x/(4 c), less what the stiffened sides give back; the pulse holds
  // frequencies beside its own.
  EXPECT_NEAR(springs.predicted->velocity, -2.3, 0.1);
  EXPECT_NEAR(springs.predicted->amplitude, -10.9, 0.3);
  EXPECT_TRUE(agree(springs.measured.errors.velocity, springs.predicted->velocity));
  EXPECT_TRUE(agree(springs.measured.errors.amplitude, springs.predicted->amplitude));
  EXPECT_GT(springs.counters.steps, 0);
}

TEST(Job, ASteadyWaveThatNothingDampsIsAsFastAsOneOfLittleDamping) {
  const auto steady = [](const char* integrator) {
    const char* bar = R"({{"block_length": [5], "dt": [1e-4], "law": ["consistent"], "integrator": [{}]}})";
    return run_job(parameters(fmt::format(fmt::runtime(bar), integrator)), false).steady;
  };
  const WaveErrors undamped = steady(R"("trapezoidal")"), damped = steady(R"({"generalized_alpha": 0.999})");
  EXPECT_NEAR(undamped.velocity, damped.velocity, 1e-3);
  EXPECT_NEAR(undamped.amplitude, damped.amplitude, 1e-3);
}

TEST(Job, TooFewStepsInAPeriodAreNotMeasurable) {
  EXPECT_THROW(static_cast<void>(run_job(parameters(R"({"block_length": [5], "dt": [3e-3]})"), false)), NotMeasurable);
}

TEST(Job, AgreementIsAFifthOrATwentiethOfAPoint) {
  EXPECT_TRUE(agree(1, 1.19));
  EXPECT_FALSE(agree(1, 1.21));
  EXPECT_TRUE(agree(0.01, -0.03));
  EXPECT_FALSE(agree(0.01, -0.05));
  EXPECT_FALSE(agree(-1, 1));
}

}  // namespace
}  // namespace verify
