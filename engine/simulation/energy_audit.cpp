#include "engine/simulation/energy_audit.h"

#include <algorithm>
#include <cstddef>

#include "engine/contact/contact_sharing.h"
#include "engine/linear/block_vectors.h"
#include "engine/terms/elasticity.h"

namespace dda {
namespace {

Vec6 of_block(const Eigen::VectorXd& all, std::size_t i) { return all.segment<6>(static_cast<Eigen::Index>(6 * i)); }

}  // namespace

double kinetic_energy(const BlockTerms& terms, const State& state) {
  return parallel_sum(state.velocity.size(), blocks_of_plain_sum, [&](std::size_t first, std::size_t last) {
    double energy = 0;
    for (std::size_t i = first; i < last; ++i)
      energy += state.velocity[i].dot(momentum(terms.inertia[i], state.velocity[i])) / 2;
    return energy;
  });
}

double strain_energy(const BlockTerms& terms, const State& state) {
  return parallel_sum(state.stress.size(), blocks_of_plain_sum, [&](std::size_t first, std::size_t last) {
    double energy = 0;
    for (std::size_t i = first; i < last; ++i)
      energy += strain_energy(terms.area[i], state.stress[i], terms.compliance[i]);
    return energy;
  });
}

StoredEnergy stored_energy(const BlockTerms& terms, const State& state, const ContactSet& contacts,
                           const std::vector<SupportElement>& supports) {
  double contact = support_energy(supports);
  parallel_add(contacts.elements.size(), contacts_of_plain_sum, contact,
               [&](std::size_t first, std::size_t last, double& sum) {
                 for (std::size_t i = first; i < last; ++i)
                   sum += interface_energy(contacts.elements.but_for_blocks(i), contacts.states[i]);
               });
  return {kinetic_energy(terms, state), strain_energy(terms, state), contact - outline_energy(contacts, state.stress)};
}

double inertia_work(const StepCoefficients& step, const BlockTerms& terms, const State& state,
                    const Eigen::VectorXd& d) {
  return parallel_sum(state.velocity.size(), blocks_of_plain_sum, [&](std::size_t first, std::size_t last) {
    double work = 0;
    for (std::size_t i = first; i < last; ++i) {
      const Vec6 own = of_block(d, i);
      const Vec6 weighted = step.mass * own - step.mass_v * state.velocity[i] - step.mass_a * state.acceleration[i];
      work += own.dot(momentum(terms.inertia[i], weighted));
    }
    return work;
  });
}

void EnergyAudit::start(const StoredEnergy& stored) {
  ledger_ = {};
  ledger_.initial = stored;
  ledger_.store(stored);
}

void EnergyAudit::dashpots_worked(const StepCoefficients& step, const BlockDamping& damping, const State& state,
                                  const Eigen::VectorXd& d) {
  for (const auto& [block, c] : damping) {
    const auto i = static_cast<std::size_t>(block);
    const Vec6 own = of_block(d, i);
    const Vec6 weighted =
        step.damping * own + step.damping_v * state.velocity[i] + step.damping_a * state.acceleration[i];
    const Vec6 at_end = (weighted - step.load_old * state.velocity[i]) / (1 - step.load_old);
    const double work = own.dot(c * (state.velocity[i] + at_end)) / 2;
    ledger_.radiated += work;
    ledger_.numerical += own.dot(c * weighted) - work;
  }
}

void EnergyAudit::record(const StepCoefficients& step, double inertia_work, const StoredEnergy& stored,
                         const StepForces& forces, const Eigen::VectorXd& d) {
  const double work_old = dot(d, forces.load_old);
  const double work_new = dot(d, forces.load_new);
  const double weight = forces.weight.size() > 0 ? dot(d, forces.weight) : 0;
  const double off_centre = 0.5 - step.load_old;  // 1/2 - alpha_f
  double weighted = 0;
  if (off_centre != 0)
    weighted = off_centre * (dot(d, forces.internal_new) - dot(d, forces.internal_old) - (work_new - work_old));
  if (forces.jump.size() > 0) weighted -= step.load_old * dot(d, forces.jump);
  record({(work_old + work_new) / 2, weight, inertia_work, weighted}, stored);
}

void EnergyAudit::record(const StepWorks& works, const StoredEnergy& stored) {
  most_gained_ = most_gained();  // what the step before has booked after its record() is in it
  ledger_.external_work += works.loads;
  ledger_.gravity_work += works.weight;
  ledger_.numerical += works.inertia - (stored.kinetic - ledger_.kinetic);
  ledger_.numerical += works.weighting;
  ledger_.law_changes += replaced_;
  replaced_ = 0;
  ledger_.store(stored);
  ledger_.largest = ledger_.scale();
}

void EnergyAudit::geometry_followed(const StoredEnergy& stored, bool other_laws) {
  const double of_rock = ledger_.strain - stored.strain + ledger_.contact - stored.contact;
  const double of_all =
      of_rock + ledger_.kinetic - stored.kinetic + ledger_.bolts - stored.bolts + ledger_.linings - stored.linings;
  const double of_laws = other_laws ? of_rock : replaced_;  // of a step that is solved again it is in the difference
  ledger_.law_changes += of_laws;
  ledger_.numerical += of_all - of_laws;
  replaced_ = 0;
  ledger_.store(stored);
}

void EnergyAudit::blocks_removed(const StoredEnergy& before, const StoredEnergy& after) {
  const double kinetic = before.kinetic - after.kinetic;
  const double strain = before.strain - after.strain;
  const double contact = before.contact - after.contact;
  ledger_.kinetic -= kinetic;
  ledger_.strain -= strain;
  ledger_.contact -= contact;
  ledger_.removed += kinetic + strain + contact;
}

void EnergyAudit::support_moved(const SupportElement& before, const SupportElement& after) {
  const Vec2 mean_force = before.stiffness * (before.gap + after.gap) / 2;
  ledger_.external_work -= mean_force.dot(after.prescribed - before.prescribed);
  ledger_.numerical -= mean_force.dot(before.foreseen);
}

void EnergyAudit::velocities_damped(double factor) {
  const double left = factor * factor * ledger_.kinetic;
  ledger_.damping += ledger_.kinetic - left;
  ledger_.kinetic = left;
}

void EnergyAudit::has_taken_velocities() {
  const double taken = std::max(0.0, ledger_.damping - damping_before_);
  const double given = std::clamp(numerical_before_ - ledger_.numerical, 0.0, taken);
  ledger_.damping -= given;
  ledger_.numerical += given;
}

void EnergyAudit::has_settled() {
  ledger_.damping += ledger_.numerical - numerical_before_ + ledger_.law_changes - law_changes_before_;
  ledger_.numerical = numerical_before_;
  ledger_.law_changes = law_changes_before_;
}

}  // namespace dda
