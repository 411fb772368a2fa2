#include "engine/simulation/support_set.h"

#include <cstddef>

#include "engine/contact/tied_sides.h"
#include "engine/geometry/rotation.h"

namespace dda {

namespace {

Mat2 stiffness_of(const PointSupport& support) {
  if (!support.direction.isZero(0)) return support.stiffness * support.direction * support.direction.transpose();
  const Vec2 held(support.holds_x ? 1 : 0, support.holds_y ? 1 : 0);
  return support.stiffness * Mat2(held.asDiagonal());
}

// Where these increments of its block take a point that lies at `offset` from the centroid, and what the rows of the
// block turned by `ahead` (rad) make of them instead; m.
Vec2 missed_by_rows(const Vec6& increments, double ahead, const Vec2& offset) {
  const Vec2 turned = rotation(ahead) * offset;
  return increments.head<2>() + deformation_increment(increments, ahead) * offset - offset -
         displacement_rows(turned) * increments;
}

Vec2 measured_gap(const Model& model, const State& state, std::size_t index, const SupportElement& support) {
  const PointSupport& prescription = model.supports[index];
  Vec2 gap = point_displacement(model, state, support.block, prescription.point) - support.prescribed - support.rest;
  if (!prescription.partner) return gap;
  gap -= point_displacement(model, state, support.block, *prescription.partner);
  if (const auto sides = tied_sides(model, prescription))
    gap += gap_by_stress(*sides, prescription) * state.stress[static_cast<std::size_t>(support.block)];
  return gap;
}

}  // namespace

Vec2 prescribed_displacement(const PointSupport& support, double time) {
  if (support.amplitude.isZero(0)) return Vec2::Zero();
  return motion_at(support.kind, support.history, time).displacement * support.amplitude;
}

Vec2 prescribed_velocity(const PointSupport& support, double time) {
  if (support.amplitude.isZero(0)) return Vec2::Zero();
  return motion_at(support.kind, support.history, time).velocity * support.amplitude;
}

std::vector<SupportElement> make_supports(const Model& model, const State& state) {
  std::vector<SupportElement> supports;
  for (const PointSupport& support : model.supports) {
    supports.push_back({support.block, Vec2::Zero(), Mat26::Zero(), stiffness_of(support)});
  }
  update_geometry(model, state, supports);
  for (std::size_t i = 0; i < supports.size(); ++i) measure_gap(model, state, i, supports[i]);
  return supports;
}

void update_geometry(const Model& model, const State& state, std::vector<SupportElement>& supports) {
  for (std::size_t i = 0; i < supports.size(); ++i) {
    const int block = supports[i].block;
    const Vec2 centroid = local_centroid(model, state, block);
    supports[i].offset = local_position(model, state, block, model.supports[i].point) - centroid;
    supports[i].rows = displacement_rows(supports[i].offset);
    const PointSupport& prescription = model.supports[i];
    if (!prescription.partner) continue;
    supports[i].rows -= displacement_rows(local_position(model, state, block, *prescription.partner) - centroid);
    if (const auto sides = tied_sides(model, prescription))
      supports[i].rows.rightCols<3>() +=
          gap_by_stress(*sides, prescription) * elasticity_matrix(model.material_of(block));
  }
}

void measure_gap(const Model& model, const State& state, std::size_t index, SupportElement& support) {
  support.prescribed = prescribed_displacement(model.supports[index], state.time);
  support.gap = measured_gap(model, state, index, support);
}

void measure_gaps(const Model& model, const State& state, const LoadTime& now, std::vector<SupportElement>& supports) {
  for (std::size_t i = 0; i < supports.size(); ++i)
    if (!model.supports[i].partner) {
      supports[i].prescribed = prescribed_displacement(model.supports[i], now);
      supports[i].gap = measured_gap(model, state, i, supports[i]);
    }
}

void foresee_gaps(const Model& model, const State& state, const std::vector<Vec6>& believed, double dt, double acts_at,
                  std::vector<SupportElement>& supports) {
  for (std::size_t i = 0; i < supports.size(); ++i) {
    const int block = supports[i].block;
    const auto b = static_cast<std::size_t>(block);
    Vec6 increments = Vec6::Zero();
    if (!believed[b].isZero(0)) increments = dt * state.velocity[b];
    const Vec2 centroid = local_centroid(model, state, block);
    const auto missed = [&](const Vec2& point) {
      return missed_by_rows(increments, acts_at * increments(2), local_position(model, state, block, point) - centroid);
    };
    supports[i].foreseen = missed(model.supports[i].point);
    if (const auto& partner = model.supports[i].partner)
      supports[i].foreseen += measured_gap(model, state, i, supports[i]) - supports[i].gap - missed(*partner);
  }
}

void foresee_nothing(std::vector<SupportElement>& supports) {
  for (SupportElement& support : supports) support.foreseen.setZero();
}

void advance_gap(const Vec2& prescribed, const Eigen::VectorXd& d, SupportElement& support) {
  support.gap += support.rows * d.segment<6>(6 * support.block) + support.foreseen - (prescribed - support.prescribed);
  support.prescribed = prescribed;
}

void add_support_force(const std::vector<SupportElement>& supports, Eigen::VectorXd& force) {
  for (const SupportElement& support : supports)
    force.segment<6>(6 * support.block) += support.rows.transpose() * (support.stiffness * support.gap);
}

double support_energy(const SupportElement& support) { return support.gap.dot(support.stiffness * support.gap) / 2; }

double support_energy(const std::vector<SupportElement>& supports) {
  double energy = 0;
  for (const SupportElement& support : supports) energy += support_energy(support);
  return energy;
}

}  // namespace dda
