// For tests: scenes of rows and layered meshes whose blocks differ, and the stress that the rock alone would carry:
// that of layers whose travel times are whole numbers of one time (Goupillaud 1961). Waves then only meet at those
// times, and are followed from one to the next without error.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "engine/core/types.h"

namespace dda {

// Poisson's ratio of both is 0.2.
struct LayerRock {
  double density, young;
};
inline constexpr LayerRock rocks[] = {{2400, 25e9}, {2700, 60e9}};

inline constexpr double cycles = 2;

// Dimensionless: a tone under half a sine squared.
inline double tone(double t, double frequency) {
  const double duration = cycles / frequency;
  if (t <= 0 || t >= duration) return 0;
  return std::pow(std::sin(std::numbers::pi * t / duration), 2) * std::sin(2 * std::numbers::pi * frequency * t);
}

struct TestLayer {
  int rock;
  int units;  // of travel time
};

// Layers one behind the other, each of `columns` blocks beside each other (in a running bond: every second layer is
// shifted by half a block), between sides that leave a plane wave its motion. One column of a bar has free sides.
struct Row {
  std::string name;
  std::vector<TestLayer> blocks;
  char wave = 'b';  // bar, p or s
  int columns = 1;
  double width = 1;  // m, of a block
  bool running_bond = false;
  double angle = 0;             // of the way against x
  double unit = 0;              // s
  double joint_stiffness = 0;   // Pa/m; 0: as the scheme has it
  double frequency = 0;         // Hz
  std::string drive = "force";  // or "displacement", "velocity"
  std::string steps;            // JSON members of the stage, dt apart
  std::string scheme = "accurate";
  double dt = 0;
  int joint = 0;  // that is looked at
  double duration = 0;

  [[nodiscard]] double speed(int rock) const {
    const double modulus = wave == 'b' ? 1 : (wave == 'p' ? 1 / 0.96 : 1 / 2.4);  // over Young's, plane stress
    return std::sqrt(modulus * rocks[rock].young / rocks[rock].density);
  }
  [[nodiscard]] double impedance(int rock) const { return rocks[rock].density * speed(rock); }
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
  const double end = cycles / row.frequency, pitch = end / 400;
  double integral = 0;
  for (int i = 0; i <= 400; ++i) {
    if (i > 0) integral += pitch * (tone(i * pitch, row.frequency) + tone((i - 1) * pitch, row.frequency)) / 2;
    const double value = row.drive == "displacement" ? integral : tone(i * pitch, row.frequency);
    table += fmt::format("{}[{:.9g}, {:.9g}]", i > 0 ? ", " : "", i * pitch, value);
  }
  return fmt::format(R"({{"table": [{}]}})", table);
}

// Turns and writes points and vectors as JSON.
class Drawing {
 public:
  explicit Drawing(double angle) : cos_(std::cos(angle)), sin_(std::sin(angle)) {}
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

inline std::string blocks_of(const Row& row, const Drawing& drawing) {
  std::string blocks;
  double x = 0;
  for (std::size_t i = 0; i < row.blocks.size(); ++i) {
    const bool shifted = row.running_bond && i % 2 == 1;
    for (int k = 0; k < row.columns + (shifted ? 1 : 0); ++k) {
      const double low = std::max(0.0, (k - (shifted ? 0.5 : 0.0)) * row.width);
      const double high = std::min(row.height(), (k + (shifted ? 0.5 : 1.0)) * row.width);
      blocks += fmt::format(R"({}{{"polygon": {{"name": "b{}.{}", "material": "{}", "vertices": {}}}}})",
                            blocks.empty() ? "" : ", ", i, k, row.blocks[i].rock == 0 ? "a" : "b",
                            drawing.box(x, x + row.length(i), low, high));
    }
    x += row.length(i);
  }
  return blocks;
}

// Sides that hold what a plane wave does not move: what is across its particles.
inline std::string sides_of(const Row& row, const Drawing& drawing, double end) {
  if (row.wave == 'b') return "";
  const char* hold = row.wave == 'p' ? R"("normal")" : (std::abs(std::sin(row.angle)) < 0.5 ? R"("x")" : R"("y")");
  std::string sides;
  for (const double y : {0.0, row.height()})
    sides +=
        fmt::format(R"({}{{"edge": {}, "hold": {}}})", sides.empty() ? "" : ", ", drawing.edge(0, y, end, y), hold);
  return sides;
}

inline std::string scene_of(const Row& row) {
  const Drawing drawing(row.angle);
  double end = 0;
  for (std::size_t i = 0; i < row.blocks.size(); ++i) end += row.length(i);
  const std::string face = drawing.edge(0, 0, 0, row.height());
  const std::string motion = row.wave == 's' ? drawing.point(0, 1) : drawing.point(1, 0);
  std::string supports = sides_of(row, drawing, end), loads;
  if (row.drive == "force") {
    loads = fmt::format(R"({{"edge": {}, "traction": {}, "history": {}}})", face, motion, history_of(row));
  } else {
    supports += fmt::format(R"({}{{"edge": {}, "hold": "normal", "{}": {}, "history": {}}})",
                            supports.empty() ? "" : ", ", face, row.drive, motion, history_of(row));
  }
  const double y = (std::floor(row.columns / 2.0) + 0.4) * row.width;
  return fmt::format(
      R"({{"dda": 1, "scheme": "{}",
 "materials": {{"a": {{"density": 2400, "young": 25e9, "poisson": 0.2}},
               "b": {{"density": 2700, "young": 60e9, "poisson": 0.2}}}},
 "joints": {{"default": {{"bonded": true{}}}}}, "blocks": [{}], "loads": [{}], "supports": [{}],
 "measurements": [{{"quantity": "traction_{}", "point": {}, "name": "s"}}],
 "steps": {{"dt": {:.9g}, "duration": {:.9g}, "kinematics": "small"{}}}}})",
      row.scheme, row.joint_stiffness > 0 ? fmt::format(R"(, "normal_stiffness": {:.9g})", row.joint_stiffness) : "",
      blocks_of(row, drawing), loads, supports, row.wave == 's' ? "shear" : "normal", drawing.point(row.place(), y),
      row.dt, row.duration, row.steps);
}

// Stress at the joint at 0, unit, 2 unit, ..., pressure positive, over the load or over velocity times impedance.
inline std::vector<double> exact_stress(const Row& row) {
  std::vector<double> impedance;
  for (const TestLayer& layer : row.blocks)
    impedance.insert(impedance.end(), static_cast<std::size_t>(layer.units), row.impedance(layer.rock));
  const std::size_t n = impedance.size(), place = static_cast<std::size_t>(row.units_before());
  std::vector<double> right(n, 0), left(n, 0);  // waves as they enter each piece
  std::vector<double> stress;
  const auto steps = static_cast<std::size_t>(row.duration / row.unit);
  for (std::size_t step = 0; step <= steps; ++step) {
    std::vector<double> next_right(n, 0), next_left(n, 0);
    const double drive = tone(static_cast<double>(step) * row.unit, row.frequency);
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

}  // namespace dda
