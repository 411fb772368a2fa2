// Bent lines and outlines that are drawn twice, the second time beside the first by an error: the rock is cut as by one
// of them. What is expected is found from the first alone, by brute force and Euler's formula.
#include <gtest/gtest.h>

#include "engine/cutting/cutting_test_support.h"

namespace dda {
namespace {

constexpr double size = 10;     // m, of the square rock
constexpr double near = 1e-4;   // m: beside what was drawn; outlines that touch themselves are parted by 3e-5
constexpr double clear = 1e-2;  // m: corners and crossings are farther apart, so that there is nothing to clean

struct Leg {
  Segment way;
  std::size_t line = 0;
};

class TwicePlan {
 public:
  TwicePlan(unsigned seed, double error, bool with_opening) : lots_(seed), error_(error) {
    for (int count = lots_.whole(1, 3); count > 0; --count) add(through_rock());
    if (with_opening) add_opening();
    for (std::size_t i = 0, drawn = lines_.size(); i < drawn; ++i) add_line(plan_, beside(lines_[i]), name(i));
    find_crossings();
  }

  [[nodiscard]] const RockPlan& plan() const { return plan_; }
  [[nodiscard]] const std::vector<Leg>& legs() const { return legs_; }
  [[nodiscard]] static std::string name(std::size_t line) { return "joint " + std::to_string(line); }

  // Corners, crossings and places on the boundary lie well apart.
  [[nodiscard]] bool is_clear() const {
    for (std::size_t i = 0; i < places_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if ((places_[i] - places_[j]).norm() < clear) return false;
      }
      for (const Leg& leg : legs_) {
        const double away = distance(leg.way, places_[i]);
        if (away > near && away < clear) return false;
      }
    }
    return true;
  }

  // A line through the rock parts a block, and so does every crossing; an outline that nothing crosses does too.
  [[nodiscard]] std::size_t blocks() const {
    const bool lonely_ring = has_ring_ && !is_ring_crossed_;
    return 1 + lines_.size() - (has_ring_ ? 1 : 0) + crossings_ + (lonely_ring ? 1 : 0);
  }

  [[nodiscard]] double length_in_rock() const {
    double length = 0;
    for (const Leg& leg : legs_) {
      const Vec2 along = leg.way.end - leg.way.start;
      double from = 0, to = 1;
      for (int axis = 0; axis < 2; ++axis) {
        if (along(axis) == 0) continue;
        const auto [enter, leave] =
            std::minmax({-leg.way.start(axis) / along(axis), (size - leg.way.start(axis)) / along(axis)});
        from = std::max(from, enter);
        to = std::min(to, leave);
      }
      length += std::max(to - from, 0.0) * along.norm();
    }
    return length;
  }

 private:
  // From one side to the one across, with up to two corners between.
  std::vector<Vec2> through_rock() {
    std::vector<Vec2> line{{-1, lots_.between(0, size)}};
    for (int corners = lots_.whole(0, 2); corners > 0; --corners) line.push_back(lots_.point(0.5, size - 0.5));
    line.emplace_back(size + 1, lots_.between(0, size));
    if (lots_.whole(0, 1) == 1) {
      for (Vec2& point : line) std::swap(point.x(), point.y());
    }
    return line;
  }

  void add(const std::vector<Vec2>& line) {
    for (std::size_t i = 1; i < line.size(); ++i) legs_.push_back({{line[i - 1], line[i]}, lines_.size()});
    lines_.push_back(line);
    add_line(plan_, line, name(lines_.size() - 1));
  }

  // Its wall is drawn as a joint, too, which counts.
  void add_opening() {
    const Vec2 middle = lots_.point(3, 7);
    const int corners = lots_.whole(3, 8);
    Ring ring;
    for (int i = 0; i < corners; ++i) {
      const double angle = 6.28 * (i + lots_.between(0.1, 0.9)) / corners;
      ring.push_back(middle + lots_.between(1, 2) * Vec2(std::cos(angle), std::sin(angle)));
    }
    plan_.openings.push_back({"opening", ring, "wall", false, "openings[0]"});
    ring.push_back(ring.front());
    for (std::size_t i = 1; i < ring.size(); ++i) legs_.push_back({{ring[i - 1], ring[i]}, lines_.size()});
    lines_.push_back(ring);
    has_ring_ = true;
  }

  std::vector<Vec2> beside(std::vector<Vec2> line) {
    const bool closed = line.front() == line.back();
    for (Vec2& point : line) point += error_ * lots_.point(-1, 1);
    if (closed) line.back() = line.front();
    return line;
  }

  void find_crossings() {
    for (const Leg& leg : legs_) add_place(leg.way.start);
    const Ring& corners = plan_.boundary;
    for (std::size_t i = 0; i < legs_.size(); ++i) {
      for (std::size_t j = 0; j < corners.size(); ++j) {
        const Segment side{corners[j], corners[(j + 1) % corners.size()]};
        if (const auto crossing = proper_intersection(legs_[i].way, side)) add_place(*crossing);
      }
      for (std::size_t j = 0; j < i; ++j) {
        const auto crossing = proper_intersection(legs_[i].way, legs_[j].way);
        if (!crossing || !add_place(*crossing)) continue;
        ++crossings_;
        is_ring_crossed_ |= has_ring_ && legs_[i].line == lines_.size() - 1;
      }
    }
    for (const Vec2& corner : corners) places_.push_back(corner);
  }

  bool add_place(const Vec2& place) {
    const bool in_rock = place.minCoeff() >= 0 && place.maxCoeff() <= size;
    if (in_rock) places_.push_back(place);
    return in_rock;
  }

  Lots lots_;
  double error_;
  RockPlan plan_ = square_plan(size);
  std::vector<std::vector<Vec2>> lines_;
  std::vector<Leg> legs_;
  std::vector<Vec2> places_;
  std::size_t crossings_ = 0;
  bool has_ring_ = false;
  bool is_ring_crossed_ = false;
};

bool lies_along(const TwicePlan& made, const Vec2& place, const std::string& joint) {
  return std::ranges::any_of(made.legs(), [&](const Leg& leg) {
    return distance(leg.way, place) < near && TwicePlan::name(leg.line) == joint;
  });
}

void expect_cut_as_drawn_once(const TwicePlan& made) {
  const CutRock rock = cut_rock(made.plan());
  expect_sound(rock, made.plan());
  EXPECT_EQ(rock.blocks.size(), made.blocks());
  double length = 0;
  for (const CutJoint& run : rock.joints) {
    length += (run.to - run.from).norm();
    for (const double share : {0.0, 0.5, 1.0})
      EXPECT_TRUE(lies_along(made, point_at({run.from, run.to}, share), run.joint)) << run.joint;
  }
  EXPECT_NEAR(length, made.length_in_rock(), 10 * near);
}

// Errors go from less than a step of the grid to nearly all that counts as round-off.
void check_plans(bool with_opening) {
  constexpr unsigned each = 40;
  unsigned looked_at = 0;
  for (int digits = 15; digits >= 8; --digits) {
    for (unsigned seed = 0; seed < each; ++seed) {
      SCOPED_TRACE("error 1e-" + std::to_string(digits) + ", plan " + std::to_string(seed));
      const TwicePlan made(seed, std::pow(10, -digits), with_opening);
      if (!made.is_clear()) continue;
      ++looked_at;
      expect_cut_as_drawn_once(made);
    }
  }
  EXPECT_GT(looked_at, 150U);
}

TEST(DrawnTwice, BentLines) { check_plans(false); }

TEST(DrawnTwice, WallsOfOpeningsAsJoints) { check_plans(true); }

}  // namespace
}  // namespace dda
