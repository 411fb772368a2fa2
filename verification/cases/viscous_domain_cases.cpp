#include "verification/cases/viscous_domain_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "engine/builder/generators.h"
#include "verification/cases/bar_case.h"
#include "verification/exact/viscous_reflection.h"
#include "verification/harness/histories.h"
#include "verification/harness/recorded_run.h"
#include "verification/suite/expect.h"

namespace verify {
namespace {

using dda::Vec2;
using exact::PlaneWave;

constexpr double pi = std::numbers::pi;
const dda::Material rock{"rock", 2650, 50e9, 0.25, dda::PlaneState::strain};

dda::Model grid(int columns, int rows, double block, const Vec2& origin) {
  dda::Model model;
  model.materials = {rock};
  dda::JointMaterial bond;
  bond.bonded = true;
  model.joints = {bond};
  dda::append_grid(model,
                   {.origin = origin, .columns = columns, .rows = rows, .block_width = block, .block_height = block});
  dda::finish_model(model);  // centroids
  return model;
}

dda::Stage steps_of(double dt, double duration) {
  dda::Stage stage;
  stage.kinematics = dda::Kinematics::small;
  stage.integrator = dda::generalized_alpha_integrator(0.8);
  stage.dt = dt;
  stage.duration = duration;
  return stage;
}

void absorb(int block, const Vec2& from, const Vec2& to, dda::Model& model) {
  model.viscous_edges.push_back(
      {block, from, to, rock.density * dda::p_wave_speed(rock), rock.density * dda::s_wave_speed(rock)});
}

// ---- A plane pulse at an angle, with what the edge makes of it, as exact initial state.

// One of the plane pulses: displacement amplitude d f(t - s.x).
struct Pulse {
  Vec2 slowness, direction;
  double amplitude;
};

// Incident wave and its reflections at the edge x = 0 of x < 0, for angles at which all of them travel.
std::vector<Pulse> pulses(PlaneWave incident, double angle) {
  const double p = dda::p_wave_speed(rock);
  const double s = dda::s_wave_speed(rock);
  const exact::Reflection reflected = exact::reflect({p, s}, incident, angle);
  const double along = std::sin(angle) / (incident == PlaneWave::p ? p : s);
  const auto pulse = [&](PlaneWave kind, double towards, double amplitude) -> Pulse {
    const double speed = kind == PlaneWave::p ? p : s;
    const Vec2 way(towards * std::sqrt(1 - std::pow(speed * along, 2)), speed * along);
    return {way / speed, kind == PlaneWave::p ? way : Vec2(-way.y(), way.x()), amplitude};
  };
  return {pulse(incident, 1, 1), pulse(PlaneWave::p, -1, reflected.p.real()),
          pulse(PlaneWave::s, -1, reflected.s.real())};
}

// Velocity f' of a pulse, and its rate.
struct Shape {
  double duration;  // s
  [[nodiscard]] double velocity(double t) const {
    return t <= 0 || t >= duration ? 0 : std::pow(std::sin(pi * t / duration), 4);
  }
  [[nodiscard]] double rate(double t) const {
    const double phase = pi * t / duration;
    return t <= 0 || t >= duration ? 0 : 4 * pi / duration * std::pow(std::sin(phase), 3) * std::cos(phase);
  }
};

Vec2 velocity_at(const std::vector<Pulse>& waves, const Shape& shape, const Vec2& x, double t) {
  Vec2 sum = Vec2::Zero();
  for (const Pulse& wave : waves) sum += wave.amplitude * shape.velocity(t - wave.slowness.dot(x)) * wave.direction;
  return sum;
}

void set_in_motion(const std::vector<Pulse>& waves, const Shape& shape, dda::Model& model) {
  const dda::Mat3 elasticity = dda::elasticity_matrix(rock);
  for (dda::Block& block : model.blocks) {
    const Vec2& x = block.moments.centroid;
    block.initial_velocity = velocity_at(waves, shape, x, 0);
    dda::Vec3 strain = dda::Vec3::Zero();
    for (const Pulse& wave : waves) {
      const Vec2& s = wave.slowness;
      const Vec2& d = wave.direction;
      const double amplitude = -wave.amplitude * shape.velocity(-s.dot(x));
      strain += amplitude * dda::Vec3(s.x() * d.x(), s.y() * d.y(), s.x() * d.y() + s.y() * d.x());
      block.initial_spin -= wave.amplitude * shape.rate(-s.dot(x)) * (s.x() * d.y() - s.y() * d.x()) / 2;
    }
    block.initial_stress = elasticity * strain;
  }
}

// Largest error of the velocity at the edge, of the incident peak, while only this edge can have been felt.
double pulse_error(PlaneWave incident, double degrees, double block, Outcome& outcome) {
  const double s_wave = 20;  // m: length of the pulse's S wave
  const Shape shape{s_wave / dda::s_wave_speed(rock)};
  // m; the shortest waves that blocks carry run ahead of P.
  const double reach = 1.5 * shape.duration * dda::p_wave_speed(rock);
  const int half = static_cast<int>(std::ceil(reach / block));
  dda::Model model = grid(half, 2 * half, block, {-half * block, -half * block});
  const std::vector<Pulse> waves = pulses(incident, degrees * pi / 180);
  set_in_motion(waves, shape, model);
  for (int row = 0; row < 2 * half; ++row) {
    const double y = (row - half) * block;
    absorb(row * half + half - 1, {0, y}, {0, y + block}, model);
  }
  const int probe = half * half + half - 1;
  const Vec2 at = model.blocks[static_cast<std::size_t>(probe)].moments.centroid;
  model.measurements = {{"x", dda::Quantity::velocity_x, probe, -1, at},
                        {"y", dda::Quantity::velocity_y, probe, -1, at}};
  const double dt = 0.5 * block / dda::p_wave_speed(rock);
  model.stages = {steps_of(dt, std::floor(shape.duration / dt) * dt)};
  dda::finish_model(model);
  const RecordedRun run = record_run(model);
  outcome.counters += run.counters;
  double error = 0;
  for (std::size_t i = 0; i < run.histories[0].size(); ++i) {
    const Vec2 exact = velocity_at(waves, shape, at, static_cast<double>(i) * dt);
    keep_largest(error, (Vec2(run.histories[0][i], run.histories[1][i]) - exact).norm());
  }
  return error;
}

Outcome plane_pulses() {
  Outcome outcome;
  for (const auto& [kind, degrees] :
       {std::pair{PlaneWave::p, 0.0}, {PlaneWave::p, 45.0}, {PlaneWave::p, 70.0}, {PlaneWave::s, 30.0}}) {
    const double error = pulse_error(kind, degrees, 1, outcome);
    const double finer = pulse_error(kind, degrees, 0.5, outcome);
    const bool is_p = kind == PlaneWave::p;
    outcome.assertions.push_back(
        expect(fmt::format("largest error of the velocity at the edge, {} pulse at {} deg, of the incident peak",
                           is_p ? "P" : "S", degrees),
               "-")
            .is(error)
            .against(0, "incident and both reflected pulses in closed form")
            .absolutely()
            .of_order({order(error, finer), 2, 0.15})
            .within(is_p ? 6e-3 : 1.2e-2,
                    "20 blocks of 1 m in the S wave of the pulse; measured with margin, and of order 2"));
  }
  return outcome;
}

// ---- A point source: a quarter of a square of blocks, pushed along x at its centre.

// Where the motion is recorded, in shares of the half width a, and what may come back there.
struct Receiver {
  double x, y;
  double most_at_20, most_at_40;  // of the peak there, for a = 20 m and 40 m
};
constexpr Receiver receivers[] = {{0.25, 0, 0.115, 0.052}, {0, 0.25, 0.095, 0.041},   {0.5, 0, 0.105, 0.112},
                                  {0, 0.5, 0.19, 0.067},   {0.5, 0.5, 0.16, 0.096},   {0.99, 0, 0.18, 0.137},
                                  {0, 0.99, 0.156, 0.08},  {0.99, 0.5, 0.336, 0.234}, {0.99, 0.99, 0.8, 0.8}};
constexpr std::size_t inner_receivers = 2;  // near the middle

struct Source {
  int size = 40;  // blocks of 1 m in half a side
  bool absorbs = true;
  int receivers_in = 40;    // blocks that the receivers' shares are of
  double duration = 0.045;  // s
};

constexpr double source_dt = 2e-4;
constexpr double source_pulse = 8e-3;  // s: 22 m of S, 38 m of P

void add_receiver(const Receiver& receiver, const Source& source, dda::Model& model) {
  const int column = static_cast<int>(receiver.x * source.receivers_in);
  const int row = static_cast<int>(receiver.y * source.receivers_in);
  const int block = row * source.size + column;
  const Vec2 at(column + 0.5, row + 0.5);
  const auto number = model.measurements.size();
  model.measurements.push_back({fmt::format("{} x", number), dda::Quantity::velocity_x, block, -1, at});
  model.measurements.push_back({fmt::format("{} y", number), dda::Quantity::velocity_y, block, -1, at});
}

// Symmetric about y = 0, antisymmetric about x = 0: nothing moves in y on either.
RecordedRun point_source(const Source& source) {
  const int size = source.size;
  dda::Model model = grid(size, size, 1, {0, 0});
  const auto hold = [&](int block, const Vec2& point) {
    model.supports.push_back({block, point, false, true, 1e3 * rock.young, Vec2::Zero(), {}});
  };
  for (int i = 0; i < size; ++i) {
    const double at = i;
    hold(i, {at, 0});
    hold(i, {at + 1, 0});
    hold(i * size, {0, at});
    hold(i * size, {0, at + 1});
    if (!source.absorbs) continue;
    const double end = size;
    absorb(i * size + size - 1, {end, at}, {end, at + 1}, model);
    absorb((size - 1) * size + i, {at, end}, {at + 1, end}, model);
  }
  dda::PiecewiseLinear push;
  const auto shape = smooth_push(1, source_pulse);
  for (int i = 0; i * source_dt < source.duration + source_dt; ++i) {
    push.times.push_back(i * source_dt);
    push.values.push_back(shape(i * source_dt));
  }
  model.edge_loads = {{0, {0, 1}, {0, 0}, {1e6, 0}, push}};
  for (const Receiver& receiver : receivers) add_receiver(receiver, source, model);
  model.stages = {steps_of(source_dt, source.duration)};
  dda::finish_model(model);
  return record_run(model);
}

// Largest difference of the velocity at a receiver from that in the large domain, of its peak there.
double echo(const RecordedRun& run, const RecordedRun& large, std::size_t receiver) {
  double peak = 0;
  double error = 0;
  for (std::size_t i = 0; i < large.histories[0].size(); ++i) {
    const auto at = [&](const RecordedRun& of) {
      return Vec2(of.histories[2 * receiver][i], of.histories[2 * receiver + 1][i]);
    };
    keep_largest(peak, at(large).norm());
    keep_largest(error, (at(run) - at(large)).norm());
  }
  return error / peak;
}

constexpr auto echo_reason =
    "measured with 30 %: the edges are 1 to 2 wavelengths away; plane waves on the same rays would leave 0.01 to 0.15 "
    "inside and 0.1 to 0.7 at the edges, where S waves meet them at up to 33 deg";
constexpr auto corner_reason =
    "measured with 10 %: S waves beyond 35 deg also make P motion that dies away from the edge, and two edges meet";

// What comes back to each receiver.
std::vector<double> assert_echoes(const Source& source, int large_size, Outcome& outcome) {
  const RecordedRun run = point_source(source);
  Source large = source;
  large.size = large_size;
  large.absorbs = false;
  const RecordedRun reference = point_source(large);
  outcome.counters += run.counters;
  outcome.counters += reference.counters;
  std::vector<double> echoes;
  for (const Receiver& receiver : receivers) {
    const double error = echo(run, reference, echoes.size());
    echoes.push_back(error);
    outcome.assertions.push_back(
        expect(fmt::format("what comes back to ({} a, {} a), half width a, {} x {} m, of the peak there", receiver.x,
                           receiver.y, 2 * source.size, 2 * source.size),
               "-")
            .is(error)
            .against(0, "the same in a domain whose edges are too far away to be felt")
            .absolutely()
            .within(source.size == 20 ? receiver.most_at_20 : receiver.most_at_40,
                    receiver.x * receiver.y > 0.9 ? corner_reason : echo_reason));
  }
  return echoes;
}

Outcome sources() {
  Outcome outcome;
  const auto near = assert_echoes({.size = 20, .receivers_in = 20, .duration = 0.03}, 85, outcome);
  const auto far = assert_echoes({.size = 40, .receivers_in = 40, .duration = 0.045}, 128, outcome);
  for (std::size_t i = 0; i < inner_receivers; ++i) {
    const double share = far[i] / near[i];
    outcome.assertions.push_back(
        expect(fmt::format("what comes back to ({} a, {} a) with edges twice as far away, over what did",
                           receivers[i].x, receivers[i].y),
               "-")
            .is(share)
            .against(0.5, "dashpots are exact for plane waves; what a wave's curvature adds falls as its radius")
            .absolutely()
            .within(0.1, "leading order alone, 1 to 2 wavelengths from the source"));
  }
  return outcome;
}

}  // namespace

std::vector<Case> viscous_domain_cases() {
  return {{"oblique-pulse", "Plane pulses that meet a viscous edge at an angle", {35}, CaseLabel::slow, plane_pulses},
          {"point-source", "A point source between viscous edges", {35}, CaseLabel::slow, sources}};
}

}  // namespace verify
