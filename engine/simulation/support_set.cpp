#include "dda/simulation/support_set.h"

#include <cstddef>

namespace dda {

Vec2 prescribed_displacement(const PointSupport& support, double time) {
  return support.displacement.isZero() ? support.displacement
                                       : Vec2(evaluate(support.history, time) * support.displacement);
}

std::vector<SupportElement> make_supports(const Model& model, const State& state) {
  std::vector<SupportElement> supports;
  for (const PointSupport& support : model.supports) {
    const Vec2 stiffness(support.holds_x ? support.stiffness : 0, support.holds_y ? support.stiffness : 0);
    supports.push_back({support.block, Vec2::Zero(), stiffness});
  }
  update_geometry(model, state, supports);
  for (std::size_t i = 0; i < supports.size(); ++i) measure_gap(model, state, i, supports[i]);
  return supports;
}

void update_geometry(const Model& model, const State& state, std::vector<SupportElement>& supports) {
  for (std::size_t i = 0; i < supports.size(); ++i) {
    const int block = supports[i].block;
    supports[i].offset =
        current_position(model, state, block, model.supports[i].point) - current_centroid(model, state, block);
  }
}

void measure_gap(const Model& model, const State& state, std::size_t index, SupportElement& support) {
  const PointSupport& prescription = model.supports[index];
  support.prescribed = prescribed_displacement(prescription, state.time);
  support.gap = point_displacement(model, state, support.block, prescription.point) - support.prescribed;
}

void advance_gap(const PointSupport& prescription, const Eigen::VectorXd& d, double time, SupportElement& support) {
  const Vec2 prescribed = prescribed_displacement(prescription, time);
  support.gap +=
      displacement_rows(support.offset) * d.segment<6>(6 * support.block) - (prescribed - support.prescribed);
  support.prescribed = prescribed;
}

void add_support_force(const std::vector<SupportElement>& supports, Eigen::VectorXd& force) {
  for (const SupportElement& support : supports)
    force.segment<6>(6 * support.block) +=
        displacement_rows(support.offset).transpose() * support.stiffness.cwiseProduct(support.gap);
}

double support_energy(const std::vector<SupportElement>& supports) {
  double energy = 0;
  for (const SupportElement& support : supports)
    energy += support.gap.dot(support.stiffness.cwiseProduct(support.gap)) / 2;
  return energy;
}

}  // namespace dda
