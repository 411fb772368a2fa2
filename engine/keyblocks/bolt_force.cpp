#include "engine/keyblocks/bolt_force.h"

#include <algorithm>
#include <vector>

#include "engine/keyblocks/first_motion.h"

namespace dda {
namespace {

// The candidates lie on the border of what is safe, where round-off decides; this share of the factor is given.
constexpr double round_off = 1e-9;

bool is_safe(std::span<const JointFace> faces, const Vec2& force, double wanted) {
  return first_motion(faces, force).factor_of_safety >= wanted * (1 - round_off);
}

// A way along a face that ends what is permitted, seen with that face pressed: in its frame a force is (along,
// pressing), and safe where wanted * along <= tan_friction * pressing + cohesion_force.
struct SlidingBorder {
  Vec2 along;
  Vec2 normal;
  double tan_friction = 0;
  double cohesion_force = 0;  // N per m of thickness
};

std::vector<SlidingBorder> sliding_borders(std::span<const JointFace> faces) {
  std::vector<SlidingBorder> borders;
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

}  // namespace

std::optional<double> bolt_force(std::span<const JointFace> faces, const Vec2& force, const Vec2& direction,
                                 double wanted) {
  std::vector<double> amounts{0};
  for (const SlidingBorder& border : sliding_borders(faces)) {
    const Vec2 limit = wanted * border.along - border.tan_friction * border.normal;
    append_crossing(force, direction, limit, border.cohesion_force, amounts);
    append_crossing(force, direction, border.normal, 0, amounts);
  }
  append_crossing(force, direction, direction, 0, amounts);  // all that acts, where the bolt can carry it alone
  std::sort(amounts.begin(), amounts.end());
  const auto enough = std::find_if(amounts.begin(), amounts.end(),
                                   [&](double amount) { return is_safe(faces, force + amount * direction, wanted); });
  return enough == amounts.end() ? std::nullopt : std::optional(*enough);
}

Vec2 least_bolt_force(std::span<const JointFace> faces, const Vec2& force, double wanted) {
  if (is_safe(faces, force, wanted)) return Vec2::Zero();
  Vec2 best = -force;
  const auto consider = [&](const Vec2& total) {
    if ((total - force).norm() < best.norm() && is_safe(faces, total, wanted)) best = total - force;
  };
  for (const SlidingBorder& border : sliding_borders(faces)) {
    const Vec2 limit = wanted * border.along - border.tan_friction * border.normal;
    consider(force - (limit.dot(force) - border.cohesion_force) / limit.squaredNorm() * limit);
    consider(border.cohesion_force / wanted * border.along);
    consider(border.along.dot(force) * border.along);
  }
  return best;
}

}  // namespace dda
