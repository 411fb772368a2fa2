#include "engine/waves/mesh_correction.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/contact/cubic_law.h"
#include "engine/geometry/triangulate.h"

namespace dda {
namespace {

const Block& block_of(const Model& model, int index) { return model.blocks[static_cast<std::size_t>(index)]; }

// A distance that, times the length of each side, sums to twice the area of the block.
double mean_distance(const Block& block) { return 2 * block.moments.area / perimeter(block.shape); }

double distance_of(const Block& block, const Interface& interface) {
  return std::abs(interface.normal.dot(interface.from - block.moments.centroid));
}

double width(const Model& model, const Interface& interface) {
  return 2 * std::min(distance_of(block_of(model, interface.block_a), interface),
                      distance_of(block_of(model, interface.block_b), interface));
}

// Distances times lengths sum, over the sides of a convex block, to twice its area, and of other blocks to more, which
// would take more inertia than they have: there a side counts with the mean distance at most.
double width_of_inertia(const Model& model, const Interface& interface) {
  double least = width(model, interface);
  for (const int index : {interface.block_a, interface.block_b}) {
    const Block& block = block_of(model, index);
    const double mean = 2 * mean_distance(block);
    if (least > mean && !is_convex(block.shape)) least = mean;
  }
  return least;
}

// Rows (n, t, nt) of the strains (xx, yy, xy) in the axes of an interface.
Mat3 strains_along(const Vec2& n) {
  const double xx = n.x() * n.x();
  const double yy = n.y() * n.y();
  const double xy = n.x() * n.y();
  return (Mat3() << xx, yy, xy, yy, xx, -xy, -2 * xy, 2 * xy, xx - yy).finished();
}

// Q, Pa.
Mat3 jump_modulus(const Material& material, double stabilisation) {
  const Mat3 elasticity = elasticity_matrix(material);
  const double g = elasticity(2, 2);
  const double p = std::min(elasticity(0, 0), mesh::most_compression * g);
  Mat3 modulus = Mat3::Zero();
  modulus(0, 0) = p / 12;
  modulus(0, 1) = modulus(1, 0) = -g / 12;
  modulus(1, 1) = std::min(stabilisation * p / 2, mesh::most_stabilisation * g) - p / 12 - g / 6;
  modulus(2, 2) = g / 12;
  return modulus;
}

// tau of an interface, 1/Pa.
double step_softening(const Model& model, const Interface& interface, const JumpSoftening& softening) {
  const Material& material = model.material_of(interface.block_a);
  const double across = width(model, interface);
  const double wanted = softening.for_steps / (material.density * across * across);
  return std::min(wanted, mesh::most_step_softening / elasticity_matrix(material)(0, 0));
}

// tau times the isotropic modulus of D^2 and G^2, Pa.
Mat3 step_modulus(const Material& material, double tau) {
  const Mat3 elasticity = elasticity_matrix(material);
  const double p = tau * elasticity(0, 0) * elasticity(0, 0);
  const double g = tau * elasticity(2, 2) * elasticity(2, 2);
  return (Mat3() << p, p - 2 * g, 0, p - 2 * g, p, 0, 0, 0, g).finished();
}

bool can_jump(const Model& model, const Interface& interface) {
  const Block& a = block_of(model, interface.block_a);
  const Block& b = block_of(model, interface.block_b);
  return a.material == b.material && is_convex(a.shape) && is_convex(b.shape);
}

// The density of the lighter block: the bound then holds for both.
double density(const Model& model, const Interface& interface) {
  return std::min(model.material_of(interface.block_a).density, model.material_of(interface.block_b).density);
}

double shear_modulus(const Model& model, const Interface& interface) {
  return std::min(elasticity_matrix(model.material_of(interface.block_a))(2, 2),
                  elasticity_matrix(model.material_of(interface.block_b))(2, 2));
}

// (c dt/d)^2 of S waves.
double squared_courant_number(const Model& model, const Interface& interface, double dt) {
  const double across = width(model, interface);
  return shear_modulus(model, interface) * dt * dt / (density(model, interface) * across * across);
}

double inertia_share(const Model& model, const Interface& interface, double period_error, double dt) {
  return std::min(period_error * squared_courant_number(model, interface, dt), mesh::most_correction);
}

// Over the density: the inertia that an extension e_nn has at least, whatever else a block does. A motion A r of its
// points r has the inertia of the rows of A, and the one with A_nn = 1 least where its other entry is -nt/tt: all of nn
// where the block lies straight along n, little in a sheared sliver.
double inertia_of_extension(const AreaMoments& moments, const Vec2& n) {
  const Mat2 second = (Mat2() << moments.xx, moments.xy, moments.xy, moments.yy).finished();
  const Vec2 t(-n.y(), n.x());
  return second.determinant() / t.dot(second * t);
}

}  // namespace

bool is_in_mesh(const std::vector<bool>& held, const InterfaceElement& element) {
  return element.law == InterfaceLaw::consistent && !held[static_cast<std::size_t>(element.block_a)] &&
         !held[static_cast<std::size_t>(element.block_b)];
}

InterfaceMatrices jump_stiffness(const Model& model, const Interface& interface, const JumpSoftening& softening) {
  InterfaceMatrices stiffness{Mat6::Zero(), Mat6::Zero(), Mat6::Zero()};
  if (!can_jump(model, interface)) return stiffness;
  const JointMaterial& joint = model.joints[static_cast<std::size_t>(interface.joint)];
  const Mat3 strains = strains_along(interface.normal);
  const Material& material = model.material_of(interface.block_a);
  Mat3 modulus = Mat3::Zero();
  if (softening.for_blocks) modulus = jump_modulus(material, stabilisation_of(joint));
  if (softening.for_steps > 0) modulus += step_modulus(material, step_softening(model, interface, softening));
  const Mat3 jump = interface.length * width(model, interface) * strains.transpose() * modulus * strains;
  stiffness.aa.bottomRightCorner<3, 3>() = -jump;
  stiffness.bb.bottomRightCorner<3, 3>() = -jump;
  stiffness.ba.bottomRightCorner<3, 3>() = jump;
  return stiffness;
}

double jump_share(const Model& model, const Interface& interface, const JumpSoftening& softening) {
  if (!can_jump(model, interface)) return 0;
  const double across = width(model, interface);
  return step_softening(model, interface, softening) * model.material_of(interface.block_a).density * across * across /
         softening.for_steps;
}

InterfaceMatrices mesh_inertia(const Model& model, const Interface& interface, double period_error, double dt) {
  const double mass = density(model, interface) * interface.length * width_of_inertia(model, interface);
  Mat6 inertia = Mat6::Zero();
  inertia.topLeftCorner<2, 2>() = -inertia_share(model, interface, period_error, dt) * mass * Mat2::Identity();
  return {inertia, inertia, -inertia};
}

Mat6 dilatation_reduction(const Model& model, int block, double strain_inertia, double period_error, double dt) {
  const Material& material = model.material_of(block);
  const Mat3 elasticity = elasticity_matrix(material);
  const AreaMoments& moments = block_of(model, block).moments;
  const double wanted = period_error * dt * dt * (elasticity(0, 0) - elasticity(2, 2)) * moments.area;
  // At most this multiple of [1, 1; 1, 1] can be taken from the inertia [xx, 0; 0, yy] (principal axes).
  const double whole = (moments.xx * moments.yy - moments.xy * moments.xy) / (moments.xx + moments.yy);
  Mat6 inertia = Mat6::Zero();
  inertia.block<2, 2>(3, 3).setConstant(
      std::min(wanted, mesh::most_strain_correction * strain_inertia * material.density * whole));
  return inertia;
}

Mat6 axial_reduction(const Model& model, int block, const Vec2& normal, double strain_inertia, double period_error,
                     double dt) {
  const Material& material = model.material_of(block);
  const AreaMoments& moments = block_of(model, block).moments;
  const double modulus = side_free_modulus(material) - elasticity_matrix(material)(2, 2);
  const double wanted = period_error * dt * dt * modulus * moments.area;
  const double whole = inertia_of_extension(moments, normal);
  const Vec6 strain = strain_along(normal);
  return std::min(wanted, mesh::most_strain_correction * strain_inertia * material.density * whole) * strain *
         strain.transpose();
}

double mesh_load_sharpening(const Model& model, const Interface& interface, double period_error, double dt) {
  return inertia_share(model, interface, period_error, dt) / squared_courant_number(model, interface, dt);
}

}  // namespace dda
