#include "engine/model/energy_release.h"

#include <algorithm>
#include <cmath>

namespace dda {
namespace {

double stored(const EnergyLedger& energy) { return energy.strain + energy.contact + energy.bolts + energy.linings; }

// The ledger as it was when the run began.
EnergyLedger start_of(const EnergyLedger& energy) {
  EnergyLedger start;
  start.kinetic = energy.initial_kinetic;
  start.strain = energy.initial_strain;
  start.contact = energy.initial_contact;
  start.bolts = energy.initial_bolts;
  start.linings = energy.initial_linings;
  return start;
}

}  // namespace

double EnergyRelease::relative_difference() const {
  double most = 0;
  for (const double entry : {work, strain, potential, joints, plastic, kinetic, damping, radiated, removed})
    most = std::max(most, std::abs(entry));
  const double difference = by_work() - by_fate();
  return difference == 0 ? 0 : difference / most;
}

EnergyRelease energy_release(const EnergyLedger& after) { return energy_release(start_of(after), after); }

EnergyRelease energy_release(const EnergyLedger& before, const EnergyLedger& after) {
  EnergyRelease release;
  release.work = after.external_work - before.external_work;
  release.strain = stored(after) - stored(before);
  release.potential = before.gravity_work - after.gravity_work;
  release.joints = after.friction - before.friction;
  release.plastic = after.plastic - before.plastic;
  release.kinetic = after.kinetic - before.kinetic;
  release.damping =
      (after.damping - before.damping) + (after.dashpot - before.dashpot) + (after.numerical - before.numerical);
  release.radiated = after.radiated - before.radiated;
  release.removed = after.removed - before.removed;
  return release;
}

}  // namespace dda
