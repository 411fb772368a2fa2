#include "verification/exact/arch_thrust.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace exact {
namespace {

// A joint of the right half of the arch, with what hangs between it and the crown.
struct Joint {
  double angle = 0;         // from the vertical
  double weight = 0;        // of the part
  double first_moment = 0;  // sum of weight times distance from the arch's axis of symmetry
};

// Distance of a voussoir's centroid from the centre of the arch.
double centroid_radius(const Arch& arch) {
  const double inner = 1 - arch.thickness / 2;
  const double outer = 1 + arch.thickness / 2;
  const double half_angle = std::numbers::pi / (2 * arch.voussoirs);
  return std::cos(half_angle) * 2 / 3 * (std::pow(outer, 3) - std::pow(inner, 3)) / (outer * outer - inner * inner);
}

// x of the centroid of the right half of a keystone that is cut at the crown.
double half_keystone_centroid(const Arch& arch) {
  const double half_angle = std::numbers::pi / (2 * arch.voussoirs);
  // Widths at the levels of the two arcs are in proportion to the radius: the integral of x over the half is that of
  // (r tan b)^2/2, its area that of r tan b.
  const double inner = 1 - arch.thickness / 2;
  const double outer = 1 + arch.thickness / 2;
  return std::sin(half_angle) / 3 * (std::pow(outer, 3) - std::pow(inner, 3)) / (outer * outer - inner * inner);
}

// From the crown to the springing. With an odd number the crown is in the middle of a voussoir.
std::vector<Joint> joints_of(const Arch& arch) {
  const double angle = std::numbers::pi / arch.voussoirs;
  const bool has_keystone = arch.voussoirs % 2 == 1;
  std::vector<Joint> joints;
  if (has_keystone) {
    joints.push_back({angle / 2, 0.5, half_keystone_centroid(arch) / 2});
  } else {
    joints.push_back({});
  }
  for (int i = 0; i < arch.voussoirs / 2; ++i) {
    const Joint& last = joints.back();
    const double x = centroid_radius(arch) * std::sin(last.angle + angle / 2);
    joints.push_back({last.angle + angle, last.weight + 1, last.first_moment + x});
  }
  return joints;
}

// Bound that a point of the joint at this radius sets to h.
double bound(const Joint& joint, double radius, double thrust) {
  return thrust * radius * std::cos(joint.angle) + joint.weight * radius * std::sin(joint.angle) - joint.first_moment;
}

double margin_at(const std::vector<Joint>& joints, double thickness, double thrust) {
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (const Joint& joint : joints) {
    least = std::min(least, bound(joint, 1 + thickness / 2, thrust));
    most = std::max(most, bound(joint, 1 - thickness / 2, thrust));
  }
  return least - most;
}

// The maximum of a concave function, by golden section.
double best_thrust(const std::vector<Joint>& joints, double thickness) {
  const double golden = (std::sqrt(5.0) - 1) / 2;
  double low = 0;
  double high = 2 * joints.back().weight;
  double a = high - golden * (high - low);
  double b = low + golden * (high - low);
  double at_a = margin_at(joints, thickness, a);
  double at_b = margin_at(joints, thickness, b);
  for (int i = 0; i < 80; ++i) {
    if (at_a < at_b) {
      low = std::exchange(a, b);
      at_a = at_b;
      b = low + golden * (high - low);
      at_b = margin_at(joints, thickness, b);
    } else {
      high = std::exchange(b, a);
      at_b = at_a;
      a = high - golden * (high - low);
      at_a = margin_at(joints, thickness, a);
    }
  }
  return (low + high) / 2;
}

}  // namespace

double thrust_margin(const Arch& arch) {
  const std::vector<Joint> joints = joints_of(arch);
  return margin_at(joints, arch.thickness, best_thrust(joints, arch.thickness));
}

double least_thickness(int voussoirs) {
  double falls = 0;
  double stands = 1;
  for (int i = 0; i < 45; ++i) {
    const double middle = (falls + stands) / 2;
    (thrust_margin({voussoirs, middle}) < 0 ? falls : stands) = middle;
  }
  return stands;
}

double needed_friction(const Arch& arch) {
  const std::vector<Joint> joints = joints_of(arch);
  const double thrust = best_thrust(joints, arch.thickness);
  double needed = 0;
  for (const Joint& joint : joints) {
    const double normal = thrust * std::cos(joint.angle) + joint.weight * std::sin(joint.angle);
    const double shear = joint.weight * std::cos(joint.angle) - thrust * std::sin(joint.angle);
    needed = std::max(needed, std::abs(shear) / normal);
  }
  return needed;
}

}  // namespace exact
