// Local passes: after a few passes most of a large scene is in balance, and only where contacts still change is there
// something to do. Such a pass moves the blocks that are out of balance and some rings of neighbours, as if all others
// were held; what that brings out of balance beside them belongs to the part of the next pass.
#include <algorithm>
#include <cstddef>

#include "engine/simulation/friction_newton.h"
#include "engine/simulation/simulation.h"

namespace dda {
namespace {

// Interfaces that may change in the matrix before it is factored again: an iteration more for each is cheaper.
constexpr int most_stale_interfaces = 8;

// Blocks belong to the part when they are out of balance by more than this share of what is negligible.
constexpr double share_of_negligible = 0.1;

// One ring makes a third more passes than two or three, on walls of 6,400 bricks; six save none.
constexpr int rings = 3;

// A part beyond this share of all blocks is not worth its factor.
constexpr double largest_part = 0.6;

}  // namespace

Status Simulation::prepare_pass(bool& changed) {
  FrictionNewton& n = newton_;
  const Status status = bring_matrix_up_to_date(false, changed);
  if (status != Status::ok) return status;
  if (!choose_part()) return prepare_whole_pass();
  const PhaseTimer timer(phase_times_.factorization);
  ++counters_.factorizations;
  ++counters_.local_passes;
  n.take_part();
  n.matrix_amended = true;  // the next step starts with matrix and factor of the whole
  return solver_->factorize(matrix_, n.part);
}

Status Simulation::prepare_whole_pass() {
  FrictionNewton& n = newton_;
  const bool is_stale = n.is_local || n.stale_interfaces > most_stale_interfaces;
  n.take_all();
  return is_stale ? factorize() : Status::ok;
}

// False where the pass is to take in all blocks.
bool Simulation::choose_part() {
  FrictionNewton& n = newton_;
  if (!solver_->takes_parts() || !bolts_.empty() || held_.move()) return false;
  const std::size_t blocks = terms_.area.size();
  const double small = share_of_negligible * negligible_imbalance();
  n.part.clear(static_cast<int>(blocks));
  for (std::size_t i = 0; i < blocks; ++i)
    if (largest_entry(n.residual, i) > small) n.part.add(static_cast<int>(i));
  for (const std::size_t k : n.taken) {  // those out of the last pass are on their pieces
    const FrictionNewton::LiveContact& contact = n.live[k];
    if (!contact.between) continue;
    if (!held_.holds(contact.block_a)) n.part.add(contact.block_a);
    if (!held_.holds(contact.block_b)) n.part.add(contact.block_b);
  }
  const double most = largest_part * static_cast<double>(blocks);
  for (int ring = 0; ring < rings && n.part.size() <= most; ++ring) add_neighbours();
  return n.part.size() <= most;
}

// Not those beyond a held block: nothing passes through it.
void Simulation::add_neighbours() {
  BlockPart& part = newton_.part;
  const int inside = part.size();
  const auto spreads_to = [&](int from, int to) { return part.among_first(inside, from) && !held_.holds(to); };
  for (int column = 0; column < matrix_.size(); ++column) {
    const auto at = static_cast<std::size_t>(column);
    for (int k = matrix_.column_starts()[at] + 1; k < matrix_.column_starts()[at + 1]; ++k) {
      const int row = matrix_.block_rows()[static_cast<std::size_t>(k)];
      if (spreads_to(column, row)) part.add(row);
      if (spreads_to(row, column)) part.add(column);
    }
  }
}

// The step's product with the matrix is off the residual already; what a contact answers beyond the rows in the matrix
// goes off it too.
void Simulation::follow_residual(const FrictionNewton::LiveContact& contact, const Vec4& moved,
                                 const Vec4& force_before) {
  const InterfaceTrial& trial = trial_[contact.interface];
  const Vec4 expected = matrix_rows_[contact.interface].cwiseProduct(contact.springs.stiffness).cwiseProduct(moved);
  const Vec4 beyond = trial.force - force_before - expected;
  newton_.largest_force = std::max(newton_.largest_force, trial.force.cwiseAbs().maxCoeff());
  if (!beyond.isZero(0)) FrictionNewton::add_force(contact, -coefficients_.stiffness * beyond, newton_.residual);
}

}  // namespace dda
