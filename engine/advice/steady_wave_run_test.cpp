// Steady waves in bars as run, against what is said of them before.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "engine/advice/advice.h"
#include "engine/advice/advise.h"
#include "engine/scene/scene.h"
#include "engine/simulation/probes.h"
#include "engine/simulation/simulation.h"

namespace dda {
namespace {

constexpr double frequency = 100;

std::string bar(double block, double dt, const std::string& choices) {
  return fmt::format(R"({{"dda": 1, {}
 "materials": {{"rock": {{"density": 2650, "young": "50 GPa", "poisson": 0.25}}}},
 "blocks": {{"bar": {{"length": 400, "height": 1, "block_length": {}}}}},
 "loads": [{{"edge": "left", "force": [1000, 0], "history": {{"sine": {{"frequency": "100 Hz"}}}}}}],
 "measurements": [{{"quantity": "stress_xx", "point": [{}, 0.5]}}, {{"quantity": "stress_xx", "point": [{}, 0.5]}}],
 "steps": {{"dt": {}, "duration": 0.12, "kinematics": "small"}}}})",
                     choices, block, 80 + block / 2, 120 + block / 2, dt);
}

struct Harmonic {
  double sine = 0;
  double cosine = 0;
  [[nodiscard]] double phase() const { return std::atan2(cosine, sine); }
  [[nodiscard]] double amplitude() const { return std::hypot(sine, cosine); }
};

// Speed of the steady wave between two measuring points, and the share of its amplitude that arrives at the second.
constexpr double way = 40;  // m
struct Measured {
  double speed;
  double left;
};

// Three whole periods, after the start of the wave has passed 122 m (28 ms) by six periods and more, as its highest
// frequencies lag behind, and before it comes back from the end at 400 m (156 ms).
Measured measured_wave(const Model& model, double dt) {
  Simulation simulation(model);
  const Probes probes(simulation);
  std::vector<double> values(2);
  Harmonic near;
  Harmonic far;
  while (!simulation.finished()) {
    EXPECT_EQ(simulation.step(), Status::ok);
    const double time = simulation.state().time;
    if (time < 0.09 - dt / 2) continue;
    probes.sample(simulation, values);
    const double angle = 2 * std::numbers::pi * frequency * time;
    const double weight = time < 0.09 + dt / 2 || time > 0.12 - dt / 2 ? 0.5 : 1;  // trapezoidal rule
    near.sine += weight * values[0] * std::sin(angle);
    near.cosine += weight * values[0] * std::cos(angle);
    far.sine += weight * values[1] * std::sin(angle);
    far.cosine += weight * values[1] * std::cos(angle);
  }
  double delay = near.phase() - far.phase();  // less than a wavelength of 43 m
  if (delay < 0) delay += 2 * std::numbers::pi;
  const double speed = 2 * std::numbers::pi * frequency * way / delay;
  return {speed, far.amplitude() / near.amplitude()};
}

// What is predicted happens. What stays open is the reading: three periods are fitted by a sine, and the front of the
// wave has left a trace in them.
void expect_as_predicted(double block, double dt, const std::string& choices) {
  SCOPED_TRACE(fmt::format("{} m, {} s, {}", block, dt, choices));
  const Model model = parse_scene(bar(block, dt, choices), "bar");
  AdviceQuestion question;
  question.frequency = frequency;
  question.limits = false;
  const Advice advice = advise(Simulation(model), question);
  ASSERT_EQ(advice.stages.at(0).waves.size(), 1U);
  const WaveAdvice& wave = advice.stages[0].waves[0];
  EXPECT_EQ(wave.kind, "bar");
  EXPECT_NEAR(wave.block_size, block, 1e-12 * 400);  // coordinates up to 400 m
  EXPECT_NEAR(wave.distance, wave.wavelength, 1e-12 * wave.wavelength);
  const Measured measured = measured_wave(model, dt);
  EXPECT_NEAR(wave.steady->speed.total(), measured.speed / wave.speed - 1, 1e-4);
  EXPECT_NEAR(wave.steady->amplitude.total(), std::pow(measured.left, wave.distance / way) - 1, 1e-4);
}

const std::string bonded = R"("joints": {"default": {"bonded": true}},)";
const std::string consistent = R"("joints": {"default": {"bonded": true, "law": "consistent"}},)";
const std::string thesis = R"("scheme": "thesis", "joints": {"default": {"bonded": true}},)";
const std::string soft = R"("scheme": "thesis", "joints": {"default": {"bonded": true, "spring_over_young": 5}},)";

TEST(SteadyWaveRun, ErrorsAreThosePredicted) {
  expect_as_predicted(2, 1e-5, thesis);
  expect_as_predicted(2, 1e-4, thesis);
  expect_as_predicted(2, 5e-5, soft);
  expect_as_predicted(4, 5e-5, consistent);
  expect_as_predicted(2, 2e-4, consistent);
  expect_as_predicted(2, 1e-4, bonded);
  expect_as_predicted(4, 2e-4, bonded);
}

}  // namespace
}  // namespace dda
