#include "engine/contact/projected_law.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/contact/block_across.h"
#include "engine/contact/cubic_law.h"
#include "engine/contact/joint_stiffness.h"

namespace dda {
namespace {

constexpr double unlike_sizes = 3, least_share_by_sizes = 1.0 / 30;

// w/(2 D) R^T R of the header in terms of stress, m/Pa for each m of outline: what a penalty of 1 takes.
Mat3 unit_compliance(const Model& model, int block, const Vec2& normal) {
  const double modulus = plane_modulus(model.material_of(block));
  return width_across(model, block, normal) / (2 * modulus) * traction_rows(normal).transpose() * traction_rows(normal);
}

void add_ring(const Model& model, int block, const Ring& ring, Mat3& sum) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 along = ring[(i + 1) % ring.size()] - ring[i];
    if (along.isZero(0)) continue;
    const Vec2 unit = along.normalized();
    sum += along.norm() * unit_compliance(model, block, {unit.y(), -unit.x()});
  }
}

// m, along the block's side: what is loaded over less gives way by less than the whole width.
double spreading_length(const Model& model, int block, const Interface& interface) {
  const Vec2 along(-interface.normal.y(), interface.normal.x());
  return spreading_share * width_across(model, block, along);
}

// m: below a closed part of this length the bed is stiffer than a column. The half of a slender block beside the joint
// is deeper than its side is long, and gives way under a part of that side by about the side's length, not all its
// depth.
double bed_spreading_length(const Model& model, int block, const Interface& interface) {
  const double depth = width_across(model, block, interface.normal) / 2;
  return std::max(spreading_length(model, block, interface), spreading_share * depth);
}

// What presses a small block goes by the size of the one beside it, S, which strains it, of size s, by S/s times as
// much as that one; and where its joints press unevenly they close by as much of its size. So where blocks differ by
// more than three times joints are stiffer in proportion, up to 30 times, as springs are there (joint_stiffness.h).
// Uniform stress passes exactly whatever the stiffness.
double share_by_sizes(const Model& model, const Interface& interface) {
  if (model.is_held(interface.block_a) || model.is_held(interface.block_b)) return 1;
  const double a = block_size(block_of(model, interface.block_a)), b = block_size(block_of(model, interface.block_b));
  return std::clamp(unlike_sizes * std::min(a, b) / std::max(a, b), least_share_by_sizes, 1.0);
}

// Width of the block as the joint sees it, m: across, or less where the stretch is a small share of its side.
double loaded_width(const Model& model, int block, const Interface& interface) {
  const double share = std::min(1.0, interface.length / spreading_length(model, block, interface));
  return share * share_by_sizes(model, interface) * width_across(model, block, interface.normal);
}

// 1/(2 gamma), m/Pa: the gap that a traction of the block makes.
double gap_by_traction(const Model& model, int block, const Interface& interface) {
  if (model.is_held(block)) return 0;
  const double modulus = plane_modulus(model.material_of(block));
  return loaded_width(model, block, interface) / (2 * projected_penalty(model, block) * modulus);
}

// The compliance of half of the block as a column, m/Pa.
double column_compliance(const Model& model, int block, const Interface& interface) {
  if (model.is_held(block)) return 0;
  return loaded_width(model, block, interface) / (2 * side_free_modulus(model.material_of(block)));
}

// The compliance of the joint's own material, normal and shear, m/Pa.
Vec2 joint_compliance(const Model& model, const Interface& interface) {
  const JointMaterial& joint = model.joints[static_cast<std::size_t>(interface.joint)];
  if (joint.normal_stiffness == 0) return Vec2::Zero();
  const double shear =
      joint.shear_stiffness > 0 ? joint.shear_stiffness : joint.shear_to_normal * joint.normal_stiffness;
  return {1 / joint.normal_stiffness, 1 / shear};
}

// The frame with its ends moved to the two points of the law.
InterfaceFrame shortened(InterfaceFrame frame, double lever) {
  const auto shorten = [lever](Vec2& from, Vec2& to) {
    const Vec2 middle = (from + to) / 2;
    const Vec2 half = lever * (to - from) / 2;
    from = middle - half;
    to = middle + half;
  };
  shorten(frame.from_a, frame.to_a);
  shorten(frame.from_b, frame.to_b);
  return frame;
}

// The normal and the tangential gap (rows) that a block's stress makes, m/Pa.
Mat23 shift_by_stress(double softness, const Vec2& normal) {
  return softness * local_axes(normal) * traction_rows(normal);
}

// The same by a block's strains, m.
Mat23 shift_rows(const Model& model, int block, double softness, const Vec2& normal) {
  return shift_by_stress(softness, normal) * elasticity_matrix(model.material_of(block));
}

}  // namespace

double largest_traction_share(const Model& model, int block) {
  const Block& shape = block_of(model, block);
  Mat3 sum = Mat3::Zero();
  add_ring(model, block, shape.shape.outer, sum);
  for (const Ring& hole : shape.shape.holes) add_ring(model, block, hole, sum);
  const Mat3 elasticity = elasticity_matrix(model.material_of(block));
  const Mat3 left = elasticity * sum * elasticity;
  const Mat3 right = shape.moments.area * elasticity;
  const Eigen::GeneralizedSelfAdjointEigenSolver<Mat3> shares(left, right, Eigen::EigenvaluesOnly);
  return shares.eigenvalues().maxCoeff();
}

Vec2 traction_by_weight(const Model& model, int block, const Interface& interface) {
  const Vec2& gravity = model.gravity;
  if (model.is_held(block) || gravity.isZero(0)) return Vec2::Zero();
  const Block& own = block_of(model, block);
  const Vec2 way = (interface.from + interface.to) / 2 - own.moments.centroid;
  const double pull = -model.material_of(block).density * gravity.dot(way) / gravity.squaredNorm();
  return local_axes(interface.normal) * (pull * gravity.dot(interface.normal) * gravity);
}

void set_weights(const Model& model, const Interface& interface, InterfaceElement& element) {
  element.beside_stress_a = traction_by_weight(model, interface.block_a, interface);
  element.beside_stress_b = traction_by_weight(model, interface.block_b, interface);
}

Vec2 projected_softness(const Model& model, const Interface& interface) {
  return {gap_by_traction(model, interface.block_a, interface), gap_by_traction(model, interface.block_b, interface)};
}

double projected_penalty(const Model& model, int block) {
  return std::max(least_penalty, penalty_margin * largest_traction_share(model, block));
}

Vec4 projected_stiffness(const Model& model, const Interface& interface, const Vec2& softness) {
  const Vec2 compliance = Vec2::Constant(softness.sum()) + joint_compliance(model, interface);
  const Vec2 stiffness = (interface.length / 2 * compliance.cwiseInverse());
  return {stiffness(0), stiffness(1), stiffness(0), stiffness(1)};
}

// bed = 3 lever^2 is the share of the gap's compliance in that of the bed: the turn of the two points, stiffness
// K lever^2, is then that of the bed, K bed/3.
double projected_lever(const Model& model, const Interface& interface, const Vec2& softness) {
  const double own = joint_compliance(model, interface)(0);
  const double gap = softness.sum() + own;
  const double bed = column_compliance(model, interface.block_a, interface) +
                     column_compliance(model, interface.block_b, interface) + own;
  return std::sqrt(gap / bed / 3);
}

double projected_spread(const Model& model, const Interface& interface) {
  double spread = 0;
  double bed = joint_compliance(model, interface)(0);
  for (const int block : {interface.block_a, interface.block_b}) {
    const double column = column_compliance(model, block, interface);
    bed += column;
    spread += column * std::min(1.0, bed_spreading_length(model, block, interface) / interface.length);
  }
  return spread / bed;
}

void set_projected_springs(const Model& model, const Interface& interface, InterfaceElement& element) {
  element.softness = projected_softness(model, interface);
  element.stiffness = projected_stiffness(model, interface, element.softness);
  element.lever = projected_lever(model, interface, element.softness);
  element.spread = projected_spread(model, interface);
  set_weights(model, interface, element);
}

void set_projected_rows(const Model& model, const InterfaceFrame& frame, InterfaceElement& element) {
  const InterfaceFrame points = shortened(frame, element.lever);
  const Mat2 axes = local_axes(frame.normal);
  element.rows_a << -local_rows(axes, points.from_a - frame.centroid_a),
      -local_rows(axes, points.to_a - frame.centroid_a);
  element.rows_b << local_rows(axes, points.from_b - frame.centroid_b),
      local_rows(axes, points.to_b - frame.centroid_b);
  const Mat23 shift_a = shift_rows(model, element.block_a, element.softness(0), frame.normal);
  const Mat23 shift_b = shift_rows(model, element.block_b, element.softness(1), frame.normal);
  element.rows_a.rightCols<3>() += (Mat43() << shift_a, shift_a).finished();
  element.rows_b.rightCols<3>() += (Mat43() << shift_b, shift_b).finished();
}

Vec2 gap_by_stress(const Vec2& softness, const Vec2& normal, const Vec3& stress_a, const Vec3& stress_b) {
  return shift_by_stress(softness(0), normal) * stress_a + shift_by_stress(softness(1), normal) * stress_b;
}

double projected_depth(const InterfaceElement& element, const Vec4& gap, const Vec3& stress_a, const Vec3& stress_b) {
  return gap_by_stress(element.softness, normal_of(element), stress_a, stress_b)(0) - std::min(gap(0), gap(2));
}

std::array<Vec2, 2> forces_at_ends(const InterfaceSprings& springs, const Vec4& force) {
  const Vec2 sum = force.head<2>() + force.tail<2>();
  const Vec2 difference = springs.lever * (force.tail<2>() - force.head<2>());
  return {(sum - difference) / 2, (sum + difference) / 2};
}

TakenOff taken_off(const InterfaceElement& element, double softness, const Vec2& beside_stress) {
  const Mat23 rows = traction_rows(normal_of(element));
  const double share = element.length * softness;
  const Vec2 beside = local_axes(normal_of(element)).transpose() * beside_stress;
  return {share * rows.transpose() * rows, share * (rows.transpose() * beside), share * beside.squaredNorm() / 2};
}

}  // namespace dda
