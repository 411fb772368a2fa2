// Plans of rock cut by a lattice of joints, with openings whose outlines are drawn from node to node of the lattice:
// they run along joints, but for round-off and for an error that is asked for.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/cutting/cutting_test_support.h"

namespace dda {

struct LatticePlan {
  RockPlan plan;
  double diagonal = 0;           // m, of the box of the boundary
  std::optional<int> blocks;     // that it has to be cut into, where that is known beforehand
  bool has_own_slivers = false;  // a crossing lies near the boundary by accident
};

// Parallel lines, numbered from the one through the middle of the rock on.
class LatticeFamily {
 public:
  LatticeFamily(Lots& lots, double angle) : angle_(angle), spacing_(lots.between(0.8, 1.2)) {
    const double most = lots.whole(0, 1) == 0 ? 0 : 0.3;
    for (double& shift : shifts_) shift = lots.between(-most, most);
  }

  static constexpr int farthest = 16;  // number of a line

  [[nodiscard]] double angle() const { return angle_; }
  [[nodiscard]] Vec2 along() const { return {std::cos(angle_), std::sin(angle_)}; }
  [[nodiscard]] Vec2 normal() const { return {-std::sin(angle_), std::cos(angle_)}; }

  // Distance of a line from the middle, m; of a place between two lines for a number that is not whole.
  [[nodiscard]] double offset(double number) const {
    const double below = std::floor(number);
    const double share = number - below;
    return spacing_ * (number + (1 - share) * shift(below) + share * shift(below + 1));
  }

 private:
  [[nodiscard]] double shift(double number) const { return shifts_[static_cast<std::size_t>(number + farthest + 1)]; }

  double angle_, spacing_;
  std::vector<double> shifts_ = std::vector<double>(2 * farthest + 4);  // of each line, as a share of the spacing
};

class LatticePlanMaker {
 public:
  // `error`: of each coordinate of outlines, as a share of the size of the rock.
  LatticePlanMaker(unsigned seed, double error) : lots_(seed), error_(error) {
    if (!one_in(3)) turn_ = lots_.between(0, 2 * std::numbers::pi);
    if (!one_in(3)) shift_ = (one_in(2) ? 10 : 1000) * lots_.point(-1, 1);
  }

  LatticePlan make() {
    const bool bounded_by_joints = one_in(2);
    made_.plan.boundary_origin = "boundary";
    made_.plan.boundary = bounded_by_joints ? lattice_boundary() : square_boundary();
    const Box box = bounding_box(made_.plan.boundary);
    made_.diagonal = (box.upper - box.lower).norm();
    add_openings(bounded_by_joints ? 1 : -1);
    const int blocks = bounded_by_joints ? add_lines_between_nodes() : add_whole_lines();
    if (are_cells_) made_.blocks = blocks - cells_left_out_;
    if (one_in(3)) add_doubles();
    if (one_in(4)) add_other_lines();
    return made_;
  }

 private:
  static constexpr int half_width = 4;    // of a rock bounded by joints, in cells
  static constexpr double half_side = 8;  // of a square rock, m

  bool one_in(int count) { return lots_.whole(1, count) == 1; }

  [[nodiscard]] Vec2 moved(const Vec2& point) const {
    return shift_ + Vec2(std::cos(turn_) * point.x() - std::sin(turn_) * point.y(),
                         std::sin(turn_) * point.x() + std::cos(turn_) * point.y());
  }

  // Where lines i and j of the two families cross, in the frame of the lattice.
  [[nodiscard]] Vec2 node(double i, double j) const {
    return (first_.offset(i) * second_.along() - second_.offset(j) * first_.along()) /
           std::sin(second_.angle() - first_.angle());
  }

  Vec2 drawn(const Vec2& point) { return moved(point) + error_ * 2 * half_side * lots_.point(-1, 1); }

  Ring square_boundary() const {
    Ring ring;
    for (const auto& [x, y] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
      ring.push_back(moved(half_side * Vec2(x, y)));
    return ring;
  }

  Ring lattice_boundary() {
    Ring ring;
    for (const auto& [i, j] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
      ring.push_back(drawn(node(half_width * i, half_width * j)));
    return ring;
  }

  // Lines end at the boundary that runs along the outermost of them. Some are drawn in parts, from node to node.
  int add_lines_between_nodes() {
    for (int i = -half_width; i <= half_width; ++i) {
      for (const bool is_first : {true, false}) {
        const auto at = [&](int k) { return moved(is_first ? node(i, k) : node(k, i)); };
        const std::string name = is_first ? "first" : "second";
        const int between = one_in(2) ? half_width : lots_.whole(1 - half_width, half_width - 1);
        add_line(made_.plan, {at(between), at(-half_width)}, name);
        if (between < half_width) add_line(made_.plan, {at(between), at(half_width)}, name);
      }
    }
    return 4 * half_width * half_width;
  }

  // Lines through the whole of a square rock make one block, and one more for each line and each crossing inside.
  int add_whole_lines() {
    const auto is_inside = [&](const Vec2& point) { return point.cwiseAbs().maxCoeff() < half_side; };
    int blocks = 1;
    for (int i = -LatticeFamily::farthest; i <= LatticeFamily::farthest; ++i) {
      for (const LatticeFamily* family : {&first_, &second_}) {
        const Vec2 middle = family->offset(i) * family->normal();
        const Vec2 reach = 3 * half_side * family->along();
        if (std::abs(family->offset(i)) > half_side * family->normal().cwiseAbs().sum()) continue;
        ++blocks;
        add_line(made_.plan, {moved(middle - reach), moved(middle + reach)}, family == &first_ ? "first" : "second");
      }
      for (int j = -LatticeFamily::farthest; j <= LatticeFamily::farthest; ++j) {
        blocks += is_inside(node(i, j)) ? 1 : 0;
        if (std::abs(node(i, j).cwiseAbs().maxCoeff() - half_side) < 1e-3) made_.has_own_slivers = true;
      }
    }
    return blocks;
  }

  // Parts of lines drawn again; the later name counts.
  void add_doubles() {
    for (int count = lots_.whole(1, 4); count > 0; --count) {
      const double i = lots_.whole(-3, 3);
      const double j = lots_.whole(-3, 0);
      const double length = lots_.whole(1, 3);
      const Vec2 to = one_in(2) ? node(i, j + length) : node(i + length, j);
      add_line(made_.plan, {moved(node(i, j)), drawn(to)}, "double");
    }
  }

  // Lines that follow nothing.
  void add_other_lines() {
    made_.blocks.reset();
    for (int count = lots_.whole(1, 3); count > 0; --count) {
      const double angle = lots_.between(0, 2 * std::numbers::pi);
      const Vec2 reach = 3 * half_side * Vec2(std::cos(angle), std::sin(angle));
      const Vec2 middle = lots_.point(-5, 5);
      add_line(made_.plan, {moved(middle - reach), moved(middle + reach)}, "other");
    }
  }

  // In cells of the lattice, counter-clockwise.
  struct Shape {
    std::vector<std::pair<double, double>> corners;
    bool is_of_cells = true;  // all along lines of the lattice
  };

  static std::vector<Shape> shapes() {
    return {{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}},
            {{{0, 0}, {3, 0}, {3, 2}, {0, 2}}},
            {{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}},
            {{{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}},
            {{{1, 0}, {2, 0}, {2, 1}, {3, 1}, {3, 2}, {2, 2}, {2, 3}, {1, 3}, {1, 2}, {0, 2}, {0, 1}, {1, 1}}},
            {{{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 3}, {1, 3}, {1, 2}, {0, 2}}},
            {{{0, 0}, {2, 0}, {0, 2}}, false},
            {{{1, 0}, {3, 0}, {3, 2}, {2, 3}, {0, 3}, {0, 1}}, false},
            {{{0, 0}, {2.5, 0}, {2.5, 1}, {0, 1}}, false},
            {{{0.5, 0.5}, {2, 0.5}, {2, 2}, {1, 2}, {1, 1}, {0.5, 1}}, false}};
  }

  // Within the lattice that bounds the rock they may lie at the boundary; `last` is the last cell they start in.
  void add_openings(int last) {
    const std::vector<Shape> all = shapes();
    const Shape& shape = all[static_cast<std::size_t>(lots_.whole(0, static_cast<int>(all.size()) - 1))];
    const Vec2 start(lots_.whole(1 - half_width, last), lots_.whole(1 - half_width, last));
    const bool is_mirrored = one_in(2);
    const auto place = [&](double i, double j) {
      const Vec2 at = start + (is_mirrored ? Vec2(j, i) : Vec2(i, j));
      const Vec2 corner = node(at.x(), at.y());
      if (last < 0 && corner.cwiseAbs().maxCoeff() > half_side) are_cells_ = false;
      return drawn(corner);
    };
    Ring ring;
    for (const auto& [i, j] : with_nodes_between(shape.corners)) ring.push_back(place(i, j));
    add_opening(ring, shape);
    if (!one_in(4)) return;
    // Another beside it, whose outline runs along that of the first.
    const Shape& cell = all.front();
    Ring beside;
    for (const auto& [i, j] : cell.corners) beside.push_back(place(i - 1, j));
    add_opening(beside, cell);
  }

  void add_opening(const Ring& ring, const Shape& shape) {
    const std::string number = std::to_string(made_.plan.openings.size());
    const bool left_out = one_in(2);
    made_.plan.openings.push_back({"opening " + number, ring, "wall " + number, left_out, "openings[" + number + "]"});
    are_cells_ = are_cells_ && shape.is_of_cells;
    if (left_out && shape.is_of_cells) cells_left_out_ += cells_in(shape);
  }

  static int cells_in(const Shape& shape) {
    Ring ring;
    for (const auto& [i, j] : shape.corners) ring.emplace_back(i, j);
    return static_cast<int>(std::lround(signed_area(ring)));
  }

  // Every other time with the nodes that the outline passes on straight lines.
  std::vector<std::pair<double, double>> with_nodes_between(const std::vector<std::pair<double, double>>& corners) {
    if (one_in(2)) return corners;
    std::vector<std::pair<double, double>> all;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const auto& [i, j] = corners[k];
      const auto& [next_i, next_j] = corners[(k + 1) % corners.size()];
      const int parts = static_cast<int>(std::max(std::abs(next_i - i), std::abs(next_j - j)));
      for (int part = 0; part < std::max(parts, 1); ++part) {
        const double share = part / std::max<double>(parts, 1);
        all.emplace_back(i + share * (next_i - i), j + share * (next_j - j));
      }
    }
    return all;
  }

  Lots lots_;
  double error_;
  LatticeFamily first_{lots_, lots_.between(0, std::numbers::pi)};
  LatticeFamily second_{lots_, first_.angle() + lots_.between(0.28, 0.72) * std::numbers::pi};
  double turn_ = 0;
  Vec2 shift_ = Vec2::Zero();
  LatticePlan made_;
  bool are_cells_ = true;  // the openings are, all of them
  int cells_left_out_ = 0;
};

}  // namespace dda
