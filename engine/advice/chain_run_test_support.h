// For tests: scenes of rows and layered meshes whose blocks differ, the stress that the rock alone would carry, and
// what a run makes of it. That stress is the one of layers whose travel times are whole numbers of one time (Goupillaud
// 1961): waves then only meet at those times, and are followed from one to the next without error.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <numbers>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "engine/advice/arrival.h"
#include "engine/core/types.h"
#include "engine/simulation/probes.h"
#include "engine/simulation/simulation.h"

namespace dda {

struct LayerRock {
  double density, young;
};

// A tone of two cycles under half a sine squared.
inline double swelling_tone(double share) {
  return std::pow(std::sin(std::numbers::pi * share), 2) * std::sin(4 * std::numbers::pi * share);
}

struct TestLayer {
  int rock;
  int units;  // of travel time
};

// What drives a row.
struct RowDrive {
  double frequency = 0;                                 // Hz
  double cycles = 2;                                    // that the load lasts
  double start = 0;                                     // s, of the load
  std::function<double(double)> shape = swelling_tone;  // of the load, by the share of its time that is over
  std::string drive = "force";                          // or "displacement", "velocity"
  bool on_base = false;  // what is moved is one held block below all columns, not the face

  [[nodiscard]] double load(double t) const {
    const double share = (t - start) * frequency / cycles;
    return share <= 0 || share >= 1 ? 0 : shape(share);
  }
};

// Layers one behind the other, each of `columns` blocks beside each other (in a running bond: every second layer is
// shifted by half a block), between sides that leave a plane wave its motion. One column of a bar has free sides.
struct Row : RowDrive {
  std::string name;
  std::vector<LayerRock> rocks = {{2400, 25e9}, {2700, 60e9}};
  double poisson = 0.2;  // of both
  bool plane_strain = false;
  std::vector<TestLayer> blocks;
  char wave = 'b';  // bar, p or s
  int columns = 1;
  double width = 1;  // m, of a block
  bool running_bond = false;
  bool free_sides = false;     // in place of what leaves a plane wave its motion
  double angle = 0;            // of the way against x
  double unit = 0;             // s
  double joint_stiffness = 0;  // Pa/m; 0: as the scheme has it
  std::string joint_law;       // JSON members of the joint: `, "law": ...`
  bool projected = false;      // joints of that law, stronger than any wave, in place of bonds
  std::string steps;           // JSON members of the stage, dt apart
  std::string scheme = "accurate";
  double dt = 0;
  int joint = 0;  // that is looked at
  double duration = 0;

  [[nodiscard]] double speed(int rock) const {
    return std::sqrt(modulus() * rock_of(rock).young / rock_of(rock).density);
  }
  // Over Young's.
  [[nodiscard]] double modulus() const {
    if (wave == 's') return 1 / (2 * (1 + poisson));
    if (wave == 'b') return 1 / (plane_strain ? 1 - poisson * poisson : 1);
    return plane_strain ? (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson)) : 1 / (1 - poisson * poisson);
  }
  [[nodiscard]] double impedance(int rock) const { return rock_of(rock).density * speed(rock); }
  [[nodiscard]] const LayerRock& rock_of(int rock) const { return rocks[static_cast<std::size_t>(rock)]; }
  [[nodiscard]] double length(std::size_t i) const { return blocks[i].units * unit * speed(blocks[i].rock); }
  [[nodiscard]] double height() const { return columns * width; }
  [[nodiscard]] double place() const {
    double x = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(joint); ++i) x += length(i);
    return x;
  }
  [[nodiscard]] int units_before() const {
    int sum = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(joint); ++i) sum += blocks[i].units;
    return sum;
  }
};

inline std::string history_of(const Row& row) {
  std::string table;
  const double end = row.cycles / row.frequency, pitch = end / 400;
  double integral = 0;
  for (int i = 0; i <= 400; ++i) {
    if (i > 0) integral += pitch * (row.load(row.start + i * pitch) + row.load(row.start + (i - 1) * pitch)) / 2;
    const double value = row.drive == "displacement" ? integral : row.load(row.start + i * pitch);
    table += fmt::format("{}[{:.9g}, {:.9g}]", i > 0 ? ", " : "", row.start + i * pitch, value);
  }
  return fmt::format(R"({{"table": [{}]}})", table);
}

// Turns and writes points and vectors as JSON.
class TurnedRow {
 public:
  explicit TurnedRow(double angle) : cos_(std::cos(angle)), sin_(std::sin(angle)) {}
  [[nodiscard]] std::string point(double x, double y) const {
    return fmt::format("[{:.12g}, {:.12g}]", cos_ * x - sin_ * y, sin_ * x + cos_ * y);
  }
  [[nodiscard]] std::string edge(double x1, double y1, double x2, double y2) const {
    return fmt::format(R"({{"from": {}, "to": {}}})", point(x1, y1), point(x2, y2));
  }
  [[nodiscard]] std::string box(double left, double right, double low, double high) const {
    return fmt::format("[{}, {}, {}, {}]", point(left, low), point(right, low), point(right, high), point(left, high));
  }

 private:
  double cos_, sin_;
};

inline std::string blocks_of(const Row& row, const TurnedRow& drawing) {
  std::string blocks;
  if (row.on_base)
    blocks = fmt::format(R"({{"polygon": {{"name": "base", "material": "r0", "vertices": {}}}}})",
                         drawing.box(-1, 0, 0, row.height()));
  double x = 0;
  for (std::size_t i = 0; i < row.blocks.size(); ++i) {
    const bool shifted = row.running_bond && i % 2 == 1;
    for (int k = 0; k < row.columns + (shifted ? 1 : 0); ++k) {
      const double low = std::max(0.0, (k - (shifted ? 0.5 : 0.0)) * row.width);
      const double high = std::min(row.height(), (k + (shifted ? 0.5 : 1.0)) * row.width);
      blocks += fmt::format(R"({}{{"polygon": {{"name": "b{}.{}", "material": "r{}", "vertices": {}}}}})",
                            blocks.empty() ? "" : ", ", i, k, row.blocks[i].rock,
                            drawing.box(x, x + row.length(i), low, high));
    }
    x += row.length(i);
  }
  return blocks;
}

// Sides that hold what a plane wave does not move: what is across its particles.
inline std::string sides_of(const Row& row, const TurnedRow& drawing, double end) {
  if (row.wave == 'b' || row.free_sides) return "";
  const char* hold = row.wave == 'p' ? R"("normal")" : (std::abs(std::sin(row.angle)) < 0.5 ? R"("x")" : R"("y")");
  std::string sides;
  for (const double y : {0.0, row.height()})
    sides +=
        fmt::format(R"({}{{"edge": {}, "hold": {}}})", sides.empty() ? "" : ", ", drawing.edge(0, y, end, y), hold);
  return sides;
}

inline std::string materials_of(const Row& row) {
  std::string materials;
  for (std::size_t i = 0; i < row.rocks.size(); ++i)
    materials += fmt::format(R"({}"r{}": {{"density": {:.12g}, "young": {:.12g}, "poisson": {:.12g}}})",
                             i > 0 ? ", " : "", i, row.rocks[i].density, row.rocks[i].young, row.poisson);
  return materials;
}

inline std::string joint_of(const Row& row) {
  const char* const kind =
      row.projected ? R"("law": "projected", "friction_angle": 0.5, "cohesion": 1e9, "tensile_strength": 1e9)"
                    : R"("bonded": true)";
  std::string joint = kind + row.joint_law;
  if (row.joint_stiffness > 0) joint += fmt::format(R"(, "normal_stiffness": {:.9g})", row.joint_stiffness);
  return joint;
}

inline std::string scene_of(const Row& row) {
  const TurnedRow drawing(row.angle);
  double end = 0;
  for (std::size_t i = 0; i < row.blocks.size(); ++i) end += row.length(i);
  const std::string face = drawing.edge(0, 0, 0, row.height());
  const std::string motion = row.wave == 's' ? drawing.point(0, 1) : drawing.point(1, 0);
  std::string supports = sides_of(row, drawing, end), loads;
  if (row.drive == "force") {
    loads = fmt::format(R"({{"edge": {}, "traction": {}, "history": {}}})", face, motion, history_of(row));
  } else {
    const std::string place = row.on_base ? R"("block": "base")" : fmt::format(R"("edge": {}, "hold": "normal")", face);
    supports += fmt::format(R"({}{{{}, "{}": {}, "history": {}}})", supports.empty() ? "" : ", ", place, row.drive,
                            motion, history_of(row));
  }
  const double y = (std::floor(row.columns / 2.0) + 0.4) * row.width;
  return fmt::format(
      R"({{"dda": 1, "scheme": "{}", "plane": "{}",
 "materials": {{{}}}, "joints": {{"default": {{{}}}}}, "blocks": [{}], "loads": [{}], "supports": [{}],
 "measurements": [{{"quantity": "traction_{}", "point": {}, "name": "s"}}],
 "steps": {{"dt": {:.9g}, "duration": {:.9g}, "kinematics": "small"{}}}}})",
      row.scheme, row.plane_strain ? "strain" : "stress", materials_of(row), joint_of(row), blocks_of(row, drawing),
      loads, supports, row.wave == 's' ? "shear" : "normal", drawing.point(row.place(), y), row.dt, row.duration,
      row.steps);
}

// Stress at the joint at 0, unit, 2 unit, ..., pressure positive, over the load or over velocity times impedance. It
// goes on for a period after the run, as a wave that is early is compared with what comes then.
inline std::vector<double> exact_stress(const Row& row) {
  std::vector<double> impedance;
  for (const TestLayer& layer : row.blocks)
    impedance.insert(impedance.end(), static_cast<std::size_t>(layer.units), row.impedance(layer.rock));
  const std::size_t n = impedance.size(), place = static_cast<std::size_t>(row.units_before());
  std::vector<double> right(n, 0), left(n, 0);  // waves as they enter each piece
  std::vector<double> stress;
  const auto steps = static_cast<std::size_t>((row.duration + 1 / row.frequency) / row.unit);
  for (std::size_t step = 0; step <= steps; ++step) {
    std::vector<double> next_right(n, 0), next_left(n, 0);
    const double drive = row.load(static_cast<double>(step) * row.unit);
    next_right[0] = row.drive == "force" ? drive - left[0] : drive + left[0];
    for (std::size_t i = 0; i + 1 < n; ++i) {
      const double sum = impedance[i] + impedance[i + 1], turned = (impedance[i + 1] - impedance[i]) / sum;
      next_right[i + 1] = 2 * impedance[i + 1] / sum * right[i] - turned * left[i + 1];
      next_left[i] = turned * right[i] + 2 * impedance[i] / sum * left[i + 1];
    }
    stress.push_back(next_right[place] + left[place]);
    right = next_right;
    left = next_left;
  }
  return stress;
}

// What the run's stress at the joint is against that of the rock, by the best fit at any delay.
inline std::optional<ArrivalErrors> measured(const Row& row, const Model& model) {
  Simulation simulation(model);
  const Probes probes(simulation);
  std::vector<double> trace{0}, values(1);
  while (!simulation.finished()) {
    EXPECT_EQ(simulation.step(), Status::ok);
    probes.sample(simulation, values);
    trace.push_back(-values[0]);
  }
  const std::vector<double> wanted = exact_stress(row);
  const double unit = row.drive == "force" ? 1 : row.impedance(row.blocks[0].rock);
  const auto exact = [&](double t) {
    const double at = t / row.unit;
    if (at < 0 || at >= static_cast<double>(wanted.size() - 1)) return 0.0;
    const auto i = static_cast<std::size_t>(at);
    return unit * (wanted[i] + (at - static_cast<double>(i)) * (wanted[i + 1] - wanted[i]));
  };
  const double due = row.units_before() * row.unit;
  const Lags lags{0, std::max(row.duration - due - (row.cycles + 0.5) / row.frequency, 0.5 * due)};
  return read_arrival(trace, row.dt, exact, due, 1 / row.frequency, lags);
}

// 20 % or 0.05 points, of what is measured.
inline bool agree(double advised, double found) {
  const double difference = std::abs(advised - found);
  return difference <= 0.2 * std::abs(found) || difference <= 0.05e-2;
}

struct NamedReading {
  const char* name;
  double ArrivalErrors::*value;
};

// How many readings are not as advised; says which, or all of them where DDA_FIGURES is set.
inline int misses_of(const std::string& row, const ArrivalErrors& advised, const ArrivalErrors& found,
                     const std::vector<NamedReading>& readings) {
  int misses = 0;
  for (const auto& [name, value] : readings) {
    const bool good = agree(advised.*value, found.*value);
    if (!good) ++misses;
    if (!good || std::getenv("DDA_FIGURES") != nullptr)
      fmt::print("{}{}: {} {:+.3f} % advised, {:+.3f} % measured\n", good ? "" : "outside: ", row, name,
                 100 * (advised.*value), 100 * (found.*value));
  }
  return misses;
}

class Dice {
 public:
  explicit Dice(unsigned seed) : random_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(random_()) / 4294967296.0);
  }
  template <typename Options>
  auto one_of(const Options& options) {
    return options[static_cast<std::size_t>(between(0, static_cast<double>(std::size(options)) - 1e-9))];
  }

 private:
  std::mt19937 random_;
};

}  // namespace dda
