#include "engine/simulation/support_set.h"

#include <cstddef>

namespace dda {

namespace {

Mat2 stiffness_of(const PointSupport& support) {
  if (!support.direction.isZero(0)) return support.stiffness * support.direction * support.direction.transpose();
  const Vec2 held(support.holds_x ? 1 : 0, support.holds_y ? 1 : 0);
  return support.stiffness * Mat2(held.asDiagonal());
}

}  // namespace

Vec2 prescribed_displacement(const PointSupport& support, double time) {
  if (support.amplitude.isZero(0)) return Vec2::Zero();
  return motion_at(support.kind, support.history, time).displacement * support.amplitude;
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
    const Vec2 centroid = current_centroid(model, state, block);
    supports[i].offset = current_position(model, state, block, model.supports[i].point) - centroid;
    supports[i].rows = displacement_rows(supports[i].offset);
    if (const auto& partner = model.supports[i].partner)
      supports[i].rows -= displacement_rows(current_position(model, state, block, *partner) - centroid);
  }
}

void measure_gap(const Model& model, const State& state, std::size_t index, SupportElement& support) {
  const PointSupport& prescription = model.supports[index];
  support.prescribed = prescribed_displacement(prescription, state.time);
  support.gap = point_displacement(model, state, support.block, prescription.point) - support.prescribed - support.rest;
  if (prescription.partner) support.gap -= point_displacement(model, state, support.block, *prescription.partner);
}

void advance_gap(const PointSupport& prescription, const Eigen::VectorXd& d, double time, SupportElement& support) {
  const Vec2 prescribed = prescribed_displacement(prescription, time);
  support.gap += support.rows * d.segment<6>(6 * support.block) - (prescribed - support.prescribed);
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
