// Materials of blocks and of joints.
#pragma once

#include <limits>
#include <optional>
#include <string>

#include "engine/core/types.h"

namespace dda {

enum class PlaneState { stress, strain };

// Isotropic linear elasticity of a block.
struct Material {
  std::string name;
  double density = 0;  // kg/m3
  double young = 0;    // Pa
  double poisson = 0;  // -
  PlaneState plane = PlaneState::stress;
};

// Stress = elasticity_matrix * (ex, ey, gxy), Pa; tension positive.
Mat3 elasticity_matrix(const Material& material);

double bar_wave_speed(const Material& material);  // m/s, free sides: sqrt(E/rho), in plane strain E/(1 - nu^2) for E
double p_wave_speed(const Material& material);    // m/s, of the plane state: thesis Eq. 11 is the plane-strain value
double s_wave_speed(const Material& material);    // m/s, sqrt(G/rho): thesis Eq. 12 lacks the factor 2

enum class InterfaceLaw {
  classical,   // Shi's vertex-edge springs, one at each end of a touching stretch
  consistent,  // Nitsche's method at mid-edge with end stabilisation, for bonded and locked edges
  cubic,       // consistent, plus cubic reconstruction along chains of bonded blocks; elsewhere the same as consistent
  projected,   // as consistent while a joint is closed and sticks, and it can slide, open, and open in part
};

// Whether closed joints of a law pass the stress of their blocks on, at no gap, and are linear until they break.
constexpr bool passes_stress(InterfaceLaw law) { return law == InterfaceLaw::consistent || law == InterfaceLaw::cubic; }

// Strength and stiffness of a joint. Stresses positive in tension; strengths are positive numbers.
struct JointMaterial {
  std::string name;
  InterfaceLaw law = InterfaceLaw::consistent;
  bool bonded = false;          // never opens or slides, whatever its strength
  double friction_angle = 0;    // rad
  double cohesion = 0;          // Pa
  double tensile_strength = 0;  // Pa

  // After failure in shear or tension; a joint without cohesion and tensile strength fails when it slides, projected
  // ones as a whole. Neither above the values before, and no tension any more.
  std::optional<double> residual_friction_angle = {};  // rad; none: friction_angle
  double residual_cohesion = 0;                        // Pa, where closed

  // Opening by tan(dilation_angle) for each metre slid away from where the joint began to slide, and closing on the way
  // back. Not above the residual friction angle: sliding would create energy.
  double dilation_angle = 0;                                            // rad
  double zero_dilation_slip = std::numeric_limits<double>::infinity();  // m, slip beyond which it opens no further

  // Classical law: normal stiffness of one spring in N/m (per m of thickness); 0 means spring_over_young * E of the
  // softer block (10 E: the thesis' g0), and 0 there what goes by the sizes of blocks (contact/joint_stiffness.h).
  double normal_spring = 0;
  double spring_over_young = 10;
  double shear_to_normal = 0.4;

  // Classical law, instead of springs: stiffness per area, of which each contact takes its share of the joint's length.
  // 0: not given; a shear stiffness of 0 then means shear_to_normal times the normal one.
  double normal_stiffness = 0;  // Pa/m
  double shear_stiffness = 0;   // Pa/m

  // Classical law, instead of either: normal stiffness chosen for each contact, see engine/contact/joint_stiffness.h.
  bool automatic_stiffness = false;

  // Damping of dry and broken contacts while they are closed: a dashpot 2 contact_damping sqrt(k m) beside each spring
  // k, m being the smaller mass of the two blocks. A block on one spring is critically damped by 1.
  double contact_damping = 0;

  // Consistent law: the next two are in units of (plane modulus * interface length / block size across the interface).
  double penalty = 4;  // must exceed 1 for stability
  // Resists the end-to-end difference of the gap, which the penalty at mid-edge leaves free. Where none is given it is
  // default_stabilisation; but for the normal gap in rows one block wide, where nothing else resists bending, it is
  // what a beam has (engine/contact/row_bending.h).
  std::optional<double> stabilisation = {};
};

inline constexpr double default_stabilisation = 0.1;

inline double stabilisation_of(const JointMaterial& joint) {
  return joint.stabilisation.value_or(default_stabilisation);
}

// True where friction alone holds the joint from the start.
inline bool is_dry(const JointMaterial& joint) {
  return !joint.bonded && joint.cohesion == 0 && joint.tensile_strength == 0;
}

// A dry joint has nothing to break.
inline bool can_break(const JointMaterial& joint) { return !joint.bonded && !is_dry(joint); }

}  // namespace dda
