#include "engine/keyblocks/bolt_force.h"

#include <algorithm>
#include <array>
#include <vector>

#include "engine/geometry/segment.h"
#include "engine/keyblocks/first_motion.h"

namespace dda {
namespace {

// The candidates lie on the border of what is safe, where round-off decides; this share of factor and force is given.
constexpr double round_off = 1e-9;

// A combination that bolts must hold: what acts on the body, and the factor that its joints are to have under it.
struct Combination {
  Vec2 force;
  double factor = 1;

  // A remainder within round-off is none, else its direction would decide what bolts that carry all are worth.
  [[nodiscard]] bool is_held(std::span<const JointFace> faces, const Vec2& total) const {
    if (total.norm() <= round_off * force.norm()) return true;
    return first_motion(faces, total).factor_of_safety >= factor * (1 - round_off);
  }
};

std::array<Combination, 2> combinations(const Vec2& force, double wanted) {
  return {Combination{force, wanted}, Combination{wanted * force, 1}};
}

// A way along a face that ends what is permitted, seen with that face pressed: in its frame a force is (along,
// pressing), and safe where wanted * along <= tan_friction * pressing + cohesion_force.
struct SlidingBorder {
  Vec2 along;
  Vec2 normal;
  double tan_friction = 0;
  double cohesion_force = 0;  // N per m of thickness
};
using Borders = std::vector<SlidingBorder>;

Borders sliding_borders(std::span<const JointFace> faces) {
  Borders borders;
  for (const JointFace& face : faces) {
    for (const double sign : {1.0, -1.0}) {
      const Vec2 way(-sign * face.outward.y(), sign * face.outward.x());
      if (!permits(faces, way)) continue;
      const Grip grip = grip_along(faces, way, face.outward);
      borders.push_back({way, face.outward, grip.tan_friction, grip.cohesion_force});
    }
  }
  return borders;
}

// Where start + s direction crosses the line {x: normal.x = offset}.
void append_crossing(const Vec2& start, const Vec2& direction, const Vec2& normal, double offset,
                     std::vector<double>& crossings) {
  const double rate = normal.dot(direction);
  if (rate == 0) return;
  const double at = (offset - normal.dot(start)) / rate;
  if (at > 0) crossings.push_back(at);
}

// The normal of the line on which a body that slides there has the factor; its offset is the cohesion.
Vec2 limit_of(const SlidingBorder& border, double factor) {
  return factor * border.along - border.tan_friction * border.normal;
}

std::optional<double> enough_for(const Combination& acting, std::span<const JointFace> faces, const Borders& borders,
                                 const Vec2& direction) {
  std::vector<double> amounts{0};
  for (const SlidingBorder& border : borders) {
    append_crossing(acting.force, direction, limit_of(border, acting.factor), border.cohesion_force, amounts);
    append_crossing(acting.force, direction, border.normal, 0, amounts);
  }
  append_crossing(acting.force, direction, direction, 0, amounts);  // all, where the bolt can carry it alone
  std::sort(amounts.begin(), amounts.end());
  const auto enough = std::find_if(amounts.begin(), amounts.end(), [&](double amount) {
    return acting.is_held(faces, acting.force + amount * direction);
  });
  return enough == amounts.end() ? std::nullopt : std::optional(*enough);
}

// Bolts that can pull with the larger force can pull with the smaller.
std::optional<double> enough_for_both(std::span<const JointFace> faces, const Borders& borders, const Vec2& force,
                                      const Vec2& direction, double wanted) {
  double most = 0;
  for (const Combination& acting : combinations(force, wanted)) {
    const auto enough = enough_for(acting, faces, borders, direction);
    if (!enough) return std::nullopt;
    most = std::max(most, *enough);
  }
  return most;
}

// What bolts of a combination reach with the least force: the foot on the line where the body slides, the end of that
// line, the foot on the line where it loses the face, or that nothing is left.
void append_feet(const Combination& acting, const Borders& borders, std::vector<Vec2>& bolts) {
  for (const SlidingBorder& border : borders) {
    const Vec2 limit = limit_of(border, acting.factor);
    bolts.emplace_back(-(limit.dot(acting.force) - border.cohesion_force) / limit.squaredNorm() * limit);
    bolts.emplace_back(border.cohesion_force / acting.factor * border.along - acting.force);
    bolts.emplace_back(-border.normal.dot(acting.force) * border.normal);
  }
  bolts.emplace_back(-acting.force);
}

// A line of bolts that are just enough: {bolt: normal.bolt = offset}.
struct BoltLine {
  Vec2 normal;
  double offset = 0;
};

std::vector<BoltLine> lines_of(const Combination& acting, const Borders& borders) {
  std::vector<BoltLine> lines;
  for (const SlidingBorder& border : borders) {
    const Vec2 limit = limit_of(border, acting.factor);
    lines.push_back({limit, border.cohesion_force - limit.dot(acting.force)});
    lines.push_back({border.normal, -border.normal.dot(acting.force)});
  }
  return lines;
}

// Where one combination takes over from the other.
void append_changes(std::span<const BoltLine> first, std::span<const BoltLine> second, std::vector<Vec2>& bolts) {
  for (const BoltLine& a : first) {
    for (const BoltLine& b : second) {
      const double across = cross(a.normal, b.normal);
      if (across == 0) continue;
      bolts.emplace_back(
          Vec2(a.offset * b.normal.y() - b.offset * a.normal.y(), b.offset * a.normal.x() - a.offset * b.normal.x()) /
          across);
    }
  }
}

}  // namespace

std::optional<double> bolt_force(std::span<const JointFace> faces, const Vec2& force, const Vec2& direction,
                                 double wanted) {
  return enough_for_both(faces, sliding_borders(faces), force, direction, wanted);
}

Vec2 least_bolt_force(std::span<const JointFace> faces, const Vec2& force, double wanted) {
  const auto both = combinations(force, wanted);
  if (both[0].is_held(faces, force) && both[1].is_held(faces, wanted * force)) return Vec2::Zero();
  const Borders borders = sliding_borders(faces);
  std::vector<Vec2> bolts;
  for (const Combination& acting : both) append_feet(acting, borders, bolts);
  append_changes(lines_of(both[0], borders), lines_of(both[1], borders), bolts);
  Vec2 best = -std::max(wanted, 1.0) * force;
  for (const Vec2& bolt : bolts) {
    if (bolt.norm() == 0) continue;
    const Vec2 direction = bolt.normalized();
    const auto enough = enough_for_both(faces, borders, force, direction, wanted);
    if (enough && *enough < best.norm()) best = *enough * direction;
  }
  return best;
}

}  // namespace dda
