// Openings drawn along joints, but for round-off: one outline in the end, no spurs. What is checked is found by looking
// at all blocks, lines and joints anew, without anything that cutting uses.
#include <gtest/gtest.h>

#include "engine/cutting/cut_rock.h"
#include "engine/cutting/lattice_plans_test_support.h"

namespace dda {
namespace {

constexpr double near = 1e-7;  // of the diagonal: a tenth of the tolerance, a hundred times the largest error drawn

double length_of(const Segment& segment) { return (segment.end - segment.start).norm(); }
Vec2 middle_of(const Segment& segment) { return (segment.start + segment.end) / 2; }

std::vector<Segment> edges_of(const Ring& ring) {
  std::vector<Segment> edges;
  for (std::size_t i = 0; i < ring.size(); ++i) edges.push_back({ring[i], ring[(i + 1) % ring.size()]});
  return edges;
}

std::vector<Segment> edges_of(const Polygon& shape) {
  std::vector<Segment> edges = edges_of(shape.outer);
  for (const Ring& hole : shape.holes) {
    for (const Segment& edge : edges_of(hole)) edges.push_back(edge);
  }
  return edges;
}

// Sums up in long double, about a corner.
long double area_of(const Ring& ring) {
  long double twice = 0;
  for (const Segment& edge : edges_of(ring)) {
    const long double from_x = static_cast<long double>(edge.start.x()) - ring[0].x();
    const long double from_y = static_cast<long double>(edge.start.y()) - ring[0].y();
    const long double to_x = static_cast<long double>(edge.end.x()) - ring[0].x();
    const long double to_y = static_cast<long double>(edge.end.y()) - ring[0].y();
    twice += from_x * to_y - from_y * to_x;
  }
  return twice / 2;
}

class LatticeOracle {
 public:
  LatticeOracle(const LatticePlan& made, const CutRock& rock)
      : plan_(made.plan), made_(made), rock_(rock), near_(near * made.diagonal) {}

  void check() {
    check_areas();
    for (const CutBlock& block : rock_.blocks) check_outline(block);
    if (made_.blocks) {
      EXPECT_EQ(static_cast<int>(rock_.blocks.size()), *made_.blocks);
    }
    check_neighbours();
  }

 private:
  void check_areas() {
    long double blocks = 0;
    for (const CutBlock& block : rock_.blocks) {
      blocks += area_of(block.shape.outer);
      for (const Ring& hole : block.shape.holes) blocks += area_of(hole);
    }
    const auto boundary = static_cast<double>(std::abs(area_of(plan_.boundary)));
    const auto found = static_cast<double>(blocks);
    EXPECT_NEAR(found + rock_.left_out_area + rock_.dropped_area, boundary, 1e-12 * boundary);
    double left_out = 0;
    for (const PlanOpening& opening : plan_.openings) {
      if (opening.left_out) left_out += static_cast<double>(std::abs(area_of(opening.outline)));
    }
    EXPECT_NEAR(rock_.left_out_area, left_out, near_ * made_.diagonal);
  }

  // No corner lies at another corner or edge of its block, as repeated ones, those at the ends of spurs and those of
  // outlines that cross themselves would.
  void check_outline(const CutBlock& block) const {
    EXPECT_GT(area_of(block.shape.outer), 0);
    const std::vector<Segment> edges = edges_of(block.shape);
    for (const Segment& one : edges) {
      EXPECT_GT(length_of(one), near_);
      for (const Segment& other : edges) {
        if (one.start == other.start || one.start == other.end) continue;
        EXPECT_GT(distance(other, one.start), near_) << one.start.transpose();
        EXPECT_FALSE(proper_intersection(one, other).has_value());
      }
    }
  }

  // An edge has a block on its other side, or lies along the boundary or an opening that is left out.
  void check_neighbours() {
    double shared = 0;
    const Topology topology = topology_of(rock_);
    for (const auto& [edge, times] : topology.edges) {
      const Segment segment{{edge.first.first, edge.first.second}, {edge.second.first, edge.second.second}};
      if (topology.edges.count({edge.second, edge.first}) == 0) {
        EXPECT_TRUE(bounds_rock(middle_of(segment))) << middle_of(segment).transpose();
      } else if (edge.first < edge.second) {
        shared += length_of(segment);
        check_joint(middle_of(segment));
      }
    }
    double runs = 0;
    for (const CutJoint& run : rock_.joints) runs += (run.to - run.from).norm();
    EXPECT_NEAR(runs, shared, near_);
  }

  void check_joint(const Vec2& place) const {
    std::vector<std::string> names;
    for (const CutJoint& run : rock_.joints) {
      if (distance({run.from, run.to}, place) < near_) names.push_back(run.joint);
    }
    EXPECT_EQ(names, std::vector<std::string>{joint_drawn_at(place)}) << place.transpose();
  }

  // Where several lines were drawn the last counts; openings count where there is no line.
  [[nodiscard]] std::string joint_drawn_at(const Vec2& place) const {
    std::string name = "none";
    for (const PlanOpening& opening : plan_.openings) {
      if (lies_on(opening.outline, place)) name = opening.joint;
    }
    for (const PlanLine& line : plan_.lines) {
      if (distance({line.points[0], line.points[1]}, place) < near_) name = line.joint;
    }
    return name;
  }

  [[nodiscard]] bool bounds_rock(const Vec2& place) const {
    return lies_on(plan_.boundary, place) ||
           std::any_of(plan_.openings.begin(), plan_.openings.end(),
                       [&](const PlanOpening& opening) { return opening.left_out && lies_on(opening.outline, place); });
  }

  [[nodiscard]] bool lies_on(const Ring& ring, const Vec2& place) const {
    const std::vector<Segment> edges = edges_of(ring);
    return std::any_of(edges.begin(), edges.end(), [&](const Segment& edge) { return distance(edge, place) < near_; });
  }

  const RockPlan& plan_;
  const LatticePlan& made_;
  const CutRock& rock_;
  double near_;  // m
};

// Errors of drawing go from nothing over round-off to a thousandth of the tolerance.
double error_of(unsigned seed) {
  const unsigned size = seed % 9;
  return size == 0 ? 0 : std::pow(10, static_cast<double>(size) - 17);
}

void check_plans(unsigned first, unsigned last) {
  for (unsigned seed = first; seed < last; ++seed) {
    const LatticePlan made = LatticePlanMaker(seed, error_of(seed)).make();
    if (made.has_own_slivers) continue;
    SCOPED_TRACE("plan " + std::to_string(seed));
    try {
      const CutRock rock = cut_rock(made.plan);
      LatticeOracle(made, rock).check();
    } catch (const std::exception& error) {
      ADD_FAILURE() << error.what();
    }
  }
}

TEST(LatticeOpenings, AHundredPlans) { check_plans(0, 100); }

TEST(LatticeOpenings, DISABLED_AThousandPlans) { check_plans(100, 1300); }

}  // namespace
}  // namespace dda
