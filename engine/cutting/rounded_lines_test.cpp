// Lines through and from common points, with coordinates rounded as drawings have them: they meet nearly in one point,
// by more than what counts as round-off and less than the tolerance. Each edge of a block lies along what was drawn,
// and has its joint. What is checked knows nothing of how it was cut.
#include <gtest/gtest.h>

#include "engine/cutting/cutting_test_support.h"

namespace dda {
namespace {

class RoundedPlan {
 public:
  RoundedPlan(unsigned seed, double half_side, int decimals)
      : lots_(seed), half_side_(half_side), unit_(std::pow(10, -decimals)) {
    plan_.boundary = {
        {-half_side, -half_side}, {half_side, -half_side}, {half_side, half_side}, {-half_side, half_side}};
    plan_.boundary_origin = "boundary";
    std::vector<Vec2> points;
    for (int count = lots_.whole(1, 4); count > 0; --count)
      points.push_back(lots_.point(-0.7 * half_side, 0.7 * half_side));
    for (const Vec2& point : points) add_star(point);
    for (std::size_t i = 1; i < points.size(); ++i) add(points[i - 1], points[i]);
  }

  [[nodiscard]] const RockPlan& plan() const { return plan_; }
  [[nodiscard]] double diagonal() const { return std::sqrt(8) * half_side_; }

 private:
  void add_star(const Vec2& point) {
    for (int count = lots_.whole(2, 4); count > 0; --count) {
      const double angle = lots_.between(0, 6.28);
      const Vec2 along(std::cos(angle), std::sin(angle));
      const double back = lots_.whole(0, 1) * lots_.between(0.2, 3) * half_side_;
      add(point - back * along, point + lots_.between(0.2, 3) * half_side_ * along);
    }
  }

  void add(const Vec2& from, const Vec2& to) {
    const auto rounded = [&](const Vec2& point) { return Vec2((point / unit_).array().round() * unit_); };
    add_line(plan_, {rounded(from), rounded(to)}, lots_.whole(0, 3) == 0 ? "b" : "a");
  }

  Lots lots_;
  double half_side_;
  double unit_;
  RockPlan plan_;
};

bool lies_along(const RockPlan& plan, const Vec2& place, const std::string& joint, double near) {
  return std::ranges::any_of(plan.lines, [&](const PlanLine& line) {
    return line.joint == joint && distance({line.points[0], line.points[1]}, place) < near;
  });
}

double distance_along(const CutJoint& run, const Segment& edge) {
  return std::max(distance({run.from, run.to}, edge.start), distance({run.from, run.to}, edge.end));
}

const CutJoint& nearest_run(const CutRock& rock, const Segment& edge) {
  return *std::ranges::min_element(rock.joints, {}, [&](const CutJoint& run) { return distance_along(run, edge); });
}

void check(const RoundedPlan& made) {
  const CutRock rock = cut_rock(made.plan());
  expect_sound(rock, made.plan());
  const double near = 2 * rock.tolerance;
  const double of_round_off = 2e-8 * made.diagonal();
  std::set<Place> corners;
  const Topology topology = topology_of(rock);
  for (const auto& [edge, times] : topology.edges) {
    const Segment way{{edge.first.first, edge.first.second}, {edge.second.first, edge.second.second}};
    corners.insert(edge.first);
    if (topology.edges.count({edge.second, edge.first}) == 0) continue;
    const CutJoint& run = nearest_run(rock, way);
    EXPECT_LT(distance_along(run, way), of_round_off) << way.start.transpose() << " to " << way.end.transpose();
    for (const double share : {0.0, 0.5, 1.0})
      EXPECT_TRUE(lies_along(made.plan(), point_at(way, share), run.joint, near)) << way.start.transpose();
  }
  for (const CutJoint& run : rock.joints)
    EXPECT_TRUE(corners.count(place(run.from)) + corners.count(place(run.to)) == 2) << run.from.transpose();
}

TEST(RoundedLines, EdgesLieAlongWhatWasDrawn) {
  for (const double half_side : {5.0, 20.0, 100.0}) {
    for (int decimals = 4; decimals <= 8; ++decimals) {
      for (unsigned seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE("plan " + std::to_string(seed) + " of " + std::to_string(half_side) + " m, " +
                     std::to_string(decimals) + " decimals");
        check({seed, half_side, decimals});
      }
    }
  }
}

}  // namespace
}  // namespace dda
