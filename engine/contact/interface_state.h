// What an interface remembers between steps, and the strength of its joint.
//
// The two ends of a classical interface open, slide and stick separately. Strength (Mohr-Coulomb, tension positive):
// an unbroken end carries normal force up to `tension` and shear up to cohesion - friction * normal force; when it
// exceeds either it breaks for good. From then on it carries no tension, and while closed shear up to
// residual_cohesion - residual friction * normal force. An end without cohesion and tension has nothing to break: it
// keeps its friction until it slides.
//
// Seat: springs of an end that carried a force before there were springs (in-situ stress, or a joint that passed its
// blocks' stress on until it broke) are pressed by that force where the blocks lie, without a gap. They are as if the
// end closed at a distance of force over stiffness, until it opens for the first time.
//
// Dilation: an end that has slipped by s rides up by dilation * min(|s|, dilation_slip), which shifts the gap at which
// it closes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "engine/contact/interface_element.h"
#include "engine/core/types.h"
#include "engine/model/model.h"

namespace dda {

enum class ContactStatus : std::uint8_t { locked, sliding, open };

struct InterfaceState {
  Vec4 gap = Vec4::Zero();    // m, elastic: the tangential part excludes slip, the normal part dilation
  Vec4 force = Vec4::Zero();  // N per m of thickness, conjugate to the gap
  std::array<ContactStatus, 2> status{ContactStatus::locked, ContactStatus::locked};
  std::array<bool, 2> broken{false, false};
  std::array<double, 2> slip{0, 0};  // m, along the tangent, since the start
  std::array<bool, 2> residual{false, false};
  std::array<double, 2> dilation{0, 0};  // m, normal, by the slip
  std::array<double, 2> seat{0, 0};      // m, normal, until it opens
  // What of a bond has gaped from either end, of the length (bond_strength.h). The first of a lone vertex is the share
  // of its residual cohesion that is lost (projected_stretch.h).
  std::array<double, 2> torn{0, 0};
  Vec4 dashpot = Vec4::Zero();  // N per m of thickness: what dashpots added to `force`, mean of the last step

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [gap, force, status, broken, slip, residual, dilation, seat, torn, dashpot] = self;
    archive(gap, force, status, broken, slip, residual, dilation, seat, torn, dashpot);
  }

  // The distance at which an end closes, m.
  [[nodiscard]] double held_open(std::size_t end) const { return dilation[end] + seat[end]; }
};

// Strength of one end of an interface, in forces per m of thickness.
struct EndStrength {
  double tension = 0;
  double cohesion = 0;
  double friction = 0;  // tangent of the friction angle
  double residual_cohesion = 0;
  double friction_drop = 0;                                        // friction less residual friction
  double dilation = 0;                                             // tangent of the dilation angle
  double dilation_slip = std::numeric_limits<double>::infinity();  // m

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [tension, cohesion, friction, residual_cohesion, friction_drop, dilation, dilation_slip] = self;
    archive(tension, cohesion, friction, residual_cohesion, friction_drop, dilation, dilation_slip);
  }

  [[nodiscard]] bool is_dry() const { return cohesion == 0 && tension == 0; }
  // Tangent of the friction angle before or after failure.
  [[nodiscard]] double friction_now(bool residual) const { return residual ? friction - friction_drop : friction; }
  [[nodiscard]] double cohesion_now(bool residual) const { return residual ? residual_cohesion : cohesion; }
  // Largest shear force of a broken end that carries `normal_force`.
  [[nodiscard]] double capacity(double normal_force, bool residual) const {
    if (normal_force >= 0) return 0;
    return residual ? residual_cohesion - (friction - friction_drop) * normal_force : -friction * normal_force;
  }
  // By how much the end has ridden up, m.
  [[nodiscard]] double lift(double slip) const { return dilation * std::min(std::abs(slip), dilation_slip); }
};

// Each end carries half of the length. Infinite strength for a bonded joint.
EndStrength end_strength(const JointMaterial& joint, double length);

// The strength of a contact without tension: dry from the start or failed. `length`: its share of the joint, m.
EndStrength unbonded_strength(const JointMaterial& joint, double length);

bool exceeds(const EndStrength& strength, double normal_force, double shear_force);

// Which ends of an interface with stress rows are loaded beyond the strength of their joint, each with its share of the
// normal force and of the moment, and half the shear force. When one is, it breaks, and the interface must go on as a
// classical one.
std::array<bool, 2> ends_beyond_strength(const EndStrength& strength, const Vec4& force);

// The gap at which a spring carries `force`; `unloaded` where it has no stiffness.
inline double elastic_gap(double force, double stiffness, double unloaded) {
  return stiffness > 0 ? force / stiffness : unloaded;
}

// Forces of the closed, stuck interface at this gap, and the traction part for these block stresses.
Vec4 elastic_force(const InterfaceElement& element, const Vec4& gap, const Vec3& stress_a, const Vec3& stress_b);

// The state of a consistent interface as the classical law sees it: the same forces and moment, shared by the two ends.
// (Cubic interfaces never break.)
InterfaceState as_classical(const InterfaceState& consistent, const Vec4& classical_stiffness);

}  // namespace dda
