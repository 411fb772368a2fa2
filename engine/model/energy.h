// Where the energy of a run is and where it went.
#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace dda {

// J per m of thickness.
struct StoredEnergy {
  double kinetic = 0, strain = 0, contact = 0, bolts = 0, linings = 0;

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [kinetic, strain, contact, bolts, linings] = self;
    archive(kinetic, strain, contact, bolts, linings);
  }

  [[nodiscard]] double sum() const { return kinetic + strain + contact + bolts + linings; }
};

// All in J per m of thickness. Work and losses are sums since the start of the run, positive when energy is brought in
// (work) or taken out (losses); kinetic, strain and contact are what is stored now.
struct EnergyLedger {
  double kinetic = 0;
  double strain = 0;
  double contact = 0;  // elastic energy in interfaces and supports
  double bolts = 0;    // elastic energy in rock bolts
  double linings = 0;  // elastic energy in linings
  double external_work = 0;
  double gravity_work = 0;
  double friction = 0;     // dissipated by sliding
  double plastic = 0;      // dissipated by bolts and linings that yield or break
  double radiated = 0;     // taken up by viscous edges
  double dashpot = 0;      // taken up by the dashpots of contacts
  double damping = 0;      // taken out by velocity_factor, damping_rate and Rayleigh damping
  double numerical = 0;    // dissipated by the time integrator
  double law_changes = 0;  // lost where joints that slide or break go over to springs, which store something else
  double removed = 0;      // what removed blocks and the joints to them had stored

  StoredEnergy initial;  // what was stored when the run began

  double largest = 0;  // what scale() was at most since the start of the run

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [kinetic, strain, contact, bolts, linings, external_work, gravity_work, friction, plastic, radiated, dashpot,
           damping, numerical, law_changes, removed, initial, largest] = self;
    archive(kinetic, strain, contact, bolts, linings, external_work, gravity_work, friction, plastic, radiated, dashpot,
            damping, numerical, law_changes, removed, initial, largest);
  }

  void store(const StoredEnergy& now) {
    kinetic = now.kinetic;
    strain = now.strain;
    contact = now.contact;
    bolts = now.bolts;
    linings = now.linings;
  }

  // What the balance does not explain: zero but for round-off when every term is right.
  [[nodiscard]] double residual() const {
    const double stored = (kinetic - initial.kinetic) + (strain - initial.strain) + (contact - initial.contact) +
                          (bolts - initial.bolts) + (linings - initial.linings);
    return external_work + gravity_work - stored - friction - plastic - radiated - dashpot - damping - numerical -
           law_changes - removed;
  }

  // The largest magnitude that any of the terms has had in the run, what a residual is compared with. (At a moment all
  // of them can be small, as after a load that came and went.)
  [[nodiscard]] double scale() const {
    double most = largest;
    for (const double term :
         {kinetic,  strain,          contact,        bolts,           linings,       external_work,  gravity_work,
          friction, plastic,         radiated,       dashpot,         damping,       numerical,      law_changes,
          removed,  initial.kinetic, initial.strain, initial.contact, initial.bolts, initial.linings}) {
      most = std::max(most, std::abs(term));
    }
    return most;
  }

  // What came from nowhere, less what went there: of time steps, and of joints that go over to springs.
  [[nodiscard]] double gained() const { return -numerical - law_changes; }
  // The share of scale() that this is; negative where energy was taken out.
  [[nodiscard]] double gain() const { return gained() == 0 ? 0 : gained() / scale(); }

  // residual()/scale(), zero also when nothing has happened; NaN when a term is.
  [[nodiscard]] double relative_residual() const { return residual() == 0 ? 0 : residual() / scale(); }
};

}  // namespace dda
