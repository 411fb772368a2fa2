// The energy that an excavation releases, in both of Salamon's forms (M. D. G. Salamon 1984, Energy considerations in
// rock mechanics: fundamental results, J. S. Afr. Inst. Min. Metall. 84, 233-246), with the names of UDEC's manual:
//
//   by work:  W - (Uc + Ub + Wj + Wp)      what was brought and is neither stored nor lost in sliding and yielding
//   by fate:  Uk + Wk + Wv + Um            where it went: motion, damping, the surroundings, the rock taken out
//
// Each comes from entries of the ledger that the other does not use, so that their difference is the ledger's residual.
#pragma once

#include <cstdint>

#include "engine/model/energy.h"

namespace dda {

// All in J per m of thickness, changes and sums from one moment to another.
struct EnergyRelease {
  double work = 0;  // W: by loads and prescribed motions; supports put in or taken away count as such
  double strain =
      0;  // Uc: growth of what blocks, joints, supports, bolts and linings store; what is taken out leaves it
  double potential = 0;  // Ub: growth of the potential energy of weights, less gravity's work
  double joints = 0;     // Wj: dissipated by sliding
  double plastic = 0;    // Wp: dissipated by bolts and linings that yield
  double kinetic = 0;    // Uk: growth of kinetic energy
  double damping = 0;    // Wk: taken by damping, by dashpots of contacts and by the time integrator
  double radiated = 0;   // Wv: taken by viscous edges
  double removed = 0;    // Um: what removed blocks and the joints to them had stored
  double round_off = 0;  // what sums as large as the ledger's cannot tell from nothing

  [[nodiscard]] double by_work() const { return work - (strain + potential + joints + plastic); }
  [[nodiscard]] double by_fate() const { return kinetic + damping + radiated + removed; }
  // Returns by_work() less by_fate() over the largest entry by size, and zero where the two differ by no more than
  // round-off: rock at rest has entries that are nothing else, and their ratio would be any number. Where that entry is
  // 1e-4 of the largest energy or more, a difference of 1e-9 of it is seen in full up to 2,300 steps.
  [[nodiscard]] double relative_difference() const;
};

// Says what was released from the start of a run to the moment of `after`, `steps` steps later.
EnergyRelease energy_release(const EnergyLedger& after, std::int64_t steps = 0);

// Says what was released between two moments of a run, the later one after so many steps of it.
EnergyRelease energy_release(const EnergyLedger& before, const EnergyLedger& after, std::int64_t steps = 0);

}  // namespace dda
