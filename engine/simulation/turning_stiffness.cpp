#include "engine/simulation/turning_stiffness.h"

#include <algorithm>
#include <cstddef>

#include "engine/simulation/block_system.h"

namespace dda {
namespace {

bool acts(const StepPlan& plan) { return plan.is_static && plan.finite_kinematics; }

// N m: against the turn of a block.
double against_turn(const BlockSystem& system, std::size_t block) {
  const Vec3& stress = system.state.stress[block];
  return std::max(system.terms.area[block] * (stress(0) + stress(1)), 0.0);
}

// N/m: against what moves across a bolt. None where it turns with the blocks that it is grouted in.
double against_parting(const LinkElement& link) {
  if (link.carries_nothing() || link.span == 0) return 0;
  return std::max(link.state.force(0), 0.0) / link.span;
}

double work_against_parting(const LinkElement& link, const BlockSystem& system) {
  const double by_a = link.rows.a.row(1).dot(system.increment.segment<6>(6 * link.block_a));
  const double by_b = link.rows.b.row(1).dot(system.increment.segment<6>(6 * link.block_b));
  const double of_free = (system.held.holds(link.block_a) ? 0 : by_a) + (system.held.holds(link.block_b) ? 0 : by_b);
  return against_parting(link) * (by_a + by_b) * of_free;
}

}  // namespace

bool has_turning_stiffness(const BlockSystem& system) {
  if (!acts(system.plan)) return false;
  const auto pulls_back = [](const LinkElement& link) { return against_parting(link) > 0; };
  if (std::ranges::any_of(system.reinforcement.bolts.links(), pulls_back)) return true;
  for (std::size_t i = 0; i < system.terms.area.size(); ++i)
    if (against_turn(system, i) > 0) return true;
  return false;
}

bool add_turning_stiffness(const BlockSystem& system, BlockMatrix& matrix) {
  if (!has_turning_stiffness(system)) return false;
  for (std::size_t i = 0; i < system.terms.area.size(); ++i)
    matrix.diagonal(static_cast<int>(i))(2, 2) += against_turn(system, i);
  for (const LinkElement& link : system.reinforcement.bolts.links())
    if (const double stiffness = against_parting(link); stiffness > 0) add_link(link, {0, stiffness}, matrix);
  return true;
}

double turning_work(const BlockSystem& system) {
  if (!acts(system.plan)) return 0;
  double work = 0;
  for (std::size_t i = 0; i < system.terms.area.size(); ++i) {
    if (system.held.holds(static_cast<int>(i))) continue;
    const double turn = system.increment(static_cast<Eigen::Index>(6 * i + 2));
    work += against_turn(system, i) * turn * turn;
  }
  for (const LinkElement& link : system.reinforcement.bolts.links()) work += work_against_parting(link, system);
  return work;
}

}  // namespace dda
