// What a quick pass takes in: the matrix brought up to date contact by contact, and the part of the blocks it moves.
#include <algorithm>

#include "engine/solve/friction_passes.h"
#include "engine/solve/largest_entry.h"

namespace dda {
namespace {

// Interfaces that may change in the matrix before it is factored again: an iteration more for each is cheaper.
constexpr int most_stale_interfaces = 8;

// Blocks belong to the part when they are out of balance by more than this share of what is negligible.
constexpr double share_of_negligible = 0.1;

// What a part takes in.
struct PartRule {
  double share_of_imbalance;  // blocks that are out of balance by more than this share of the block that is most
  int rings;                  // of neighbours
  double largest;             // share of all blocks beyond which it is not worth its factor
  std::size_t fewest;         // blocks in all: of fewer, no part is
};

// One ring makes a third more passes than two or three, on walls of 6,400 bricks; six save none.
constexpr PartRule beside_incomplete_factors{.share_of_imbalance = 0, .rings = 3, .largest = 0.6, .fewest = 0};

// A complete factor of all blocks takes ten times as long as the rest of a pass, so that a part begins with the blocks
// that are worst and takes in the others when it has come as near to the balance as they are. (In rock of 1,223 blocks,
// of which three splinters change contacts for most of the time, a part with two rings moves on twice as fast as one
// with three, and one with one ring half as fast; shares of 0.1 and 0.001 are as good. Rocks of 15 to 370 blocks take
// as long with parts as without.)
constexpr PartRule beside_complete_factors{.share_of_imbalance = 0.01, .rings = 2, .largest = 0.3, .fewest = 400};

}  // namespace

Status FrictionPasses::prepare_pass(Iterate& at, bool& changed) {
  const Status status = amend_matrix(at, changed);
  if (status != Status::ok) return status;
  if (!choose_part(at)) return prepare_whole_pass(at);
  ++at.costs.counters.local_passes;
  take_part();
  return at.matrix.factorize(part_);
}

// Contact by contact, and the factor stays behind. Not where bolts change, which are few, nor where held blocks move,
// which would need what was taken out of the matrix anew.
Status FrictionPasses::amend_matrix(Iterate& at, bool& changed) const {
  if (!at.matrix.is_current() || at.problem->held.move || at.bolts.rows_are_stale())
    return at.bring_matrix_up_to_date(changed);
  changed = false;
  for (const std::size_t k : taken_) {
    const std::size_t i = live_[k].trial;
    const ContactRows before = at.contacts.matrix_rows(i);
    if (!at.contacts.take_up_rows(i)) continue;
    at.matrix.amend(at.problem->factor, at.contacts.element(i), at.contacts.matrix_rows(i) - before, at.problem->held);
    ++at.costs.counters.contact_state_changes;
    changed = true;
  }
  return Status::ok;
}

Status FrictionPasses::prepare_whole_pass(Iterate& at) {
  const bool is_stale = is_local_ || at.matrix.amendments_since_factored() > most_stale_interfaces;
  take_all();
  return is_stale ? at.matrix.factorize() : Status::ok;
}

// False where the pass is to take in all blocks.
bool FrictionPasses::choose_part(const Iterate& at) {
  const HeldUnknowns& held = at.problem->held;
  if (!at.matrix.solver().takes_parts() || !at.bolts.empty() || held.move) return false;
  const PartRule& rule = at.matrix.solver().is_direct() ? beside_complete_factors : beside_incomplete_factors;
  const std::size_t blocks = at.problem->areas.size();
  if (blocks < rule.fewest) return false;
  const double small = std::max(share_of_negligible * negligible_imbalance(at), rule.share_of_imbalance * imbalance_);
  part_.clear(static_cast<int>(blocks));
  for (std::size_t i = 0; i < blocks; ++i)
    if (largest_entry(residual_, i, at.problem->areas[i]) > small) part_.add(static_cast<int>(i));
  for (const std::size_t k : taken_) {  // those out of the last pass are on their pieces
    const LiveContact& contact = live_[k];
    if (!contact.between) continue;
    if (!held.holds(contact.block_a)) part_.add(contact.block_a);
    if (!held.holds(contact.block_b)) part_.add(contact.block_b);
  }
  const double most = rule.largest * static_cast<double>(blocks);
  for (int ring = 0; ring < rule.rings && part_.size() <= most; ++ring) add_neighbours(at);
  return part_.size() <= most;
}

// Not those beyond a held block: nothing passes through it.
void FrictionPasses::add_neighbours(const Iterate& at) {
  const BlockMatrix& matrix = at.matrix.values();
  const int inside = part_.size();
  const auto spreads_to = [&](int from, int to) {
    return part_.among_first(inside, from) && !at.problem->held.holds(to);
  };
  for (int column = 0; column < matrix.size(); ++column) {
    const auto first = static_cast<std::size_t>(column);
    for (int k = matrix.column_starts()[first] + 1; k < matrix.column_starts()[first + 1]; ++k) {
      const int row = matrix.block_rows()[static_cast<std::size_t>(k)];
      if (spreads_to(column, row)) part_.add(row);
      if (spreads_to(row, column)) part_.add(column);
    }
  }
}

// The step's product with the matrix is off the residual already; what a contact answers beyond the rows in the matrix
// goes off it too.
void FrictionPasses::follow_residual(const Iterate& at, const LiveContact& contact, const Vec4& force_before) {
  const InterfaceTrial& trial = at.contacts[contact.trial];
  const Vec4 expected = at.contacts.force_in_matrix(contact.trial, contact.springs, contact.gap(step_));
  const Vec4 beyond = trial.force - force_before - expected;
  largest_force_ = std::max(largest_force_, trial.force.cwiseAbs().maxCoeff());
  if (!beyond.isZero(0)) contact.add_force(-at.problem->factor * beyond, residual_);
}

}  // namespace dda
