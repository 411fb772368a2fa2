#include "engine/simulation/accepted_contacts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "engine/contact/bond_strength.h"
#include "engine/contact/contact_sharing.h"
#include "engine/contact/open_close.h"
#include "engine/contact/projected_stretch.h"
#include "engine/core/parallel.h"

namespace dda {
namespace {

bool slides(const InterfaceState& before, const InterfaceState& after) {
  return before.slip != after.slip || std::ranges::find(after.status, ContactStatus::sliding) != after.status.end();
}

// What the strength of one end lets it bear in shear, N per m of thickness.
double bearable(const EndStrength& strength, const InterfaceState& state, std::size_t end) {
  const double pressure = std::max(0.0, -state.force(static_cast<Eigen::Index>(2 * end)));
  return strength.cohesion_now(state.residual[end]) + strength.friction_now(state.residual[end]) * pressure;
}

// What both ends may bear at any moment of a step in which one of them slips.
double most_friction(const EndStrength& strength, const InterfaceState& before, const InterfaceState& after,
                     const InterfaceTrial& trial) {
  if (before.slip == after.slip) return 0;
  double most = 0;
  for (const std::size_t end : {std::size_t{0}, std::size_t{1}})
    most += std::max({trial.capacity[end], bearable(strength, before, end), bearable(strength, after, end)});
  return most;
}

// What the ends that slip in a step bear at its end, N per m of thickness.
double borne_at_end(const InterfaceState& before, const InterfaceState& after, const InterfaceTrial& trial) {
  double borne = 0;
  for (const std::size_t end : {std::size_t{0}, std::size_t{1}})
    if (before.slip[end] != after.slip[end]) borne += std::abs(trial.force(static_cast<Eigen::Index>(2 * end) + 1));
  return borne;
}

class Acceptance {
 public:
  Acceptance(const InterfaceTrials& trials, bool moves, BlockSystem& system)
      : trials_(trials),
        moves_(moves),
        elements_(system.contacts.elements.own()),
        strengths_(system.contacts.strengths),
        states_(system.contacts.states),
        held_(system.held),
        increment_(system.increment),
        weight_(system.coefficients.stiffness),
        settles_(system.plan.is_static),
        dashpot_delay_(system.coefficients.acts_at - 0.5),
        gaps_are_foreseen_(system.plan.finite_kinematics && system.coefficients.acts_at != 0.5) {}

  void accept(std::size_t k, ContactWork& work) const {
    const std::size_t i = trials_.place(k);
    const InterfaceElement& element = elements_[i];
    const InterfaceState before = states_[i];
    InterfaceState after = finish_trial(element, before, trials_[k]);
    if (strengths_[i].cohesion > 0) note_torn(element, after);
    after.dashpot = weight_ * dashpot_force(element, trials_[k]);
    book(element, strengths_[i], before, after, trials_[k], work);
    if (moves_) count_free_slip(element, trials_[k].gap, after);
    states_[i] = after;
  }

 private:
  void book(const InterfaceElement& element, const EndStrength& strength, const InterfaceState& before,
            const InterfaceState& after, const InterfaceTrial& trial, ContactWork& work) const {
    const Vec4 dropped = trial.force - after.force;
    const bool drops = trial.force != after.force;
    const Vec4 by_held = held_.empty() ? Vec4(Vec4::Zero()) : held_.gap_increment(element);
    if (drops) work.brought += weight_ * by_held.dot(dropped);  // the rest of their work is in audit_held_blocks
    const bool bends = gapes(element, before) || gapes(element, after);  // what it stores is no square of its gaps
    // Slip of ends that do not rise in the step is not counted (open_close.h), but takes energy.
    if (before.status != after.status || slides(before, after) || drops || gaps_are_foreseen_ || bends ||
        !before.dashpot.isZero(0))
      work.changed(element, before, after, {gap_increment(element, increment_), by_held},
                   working_forces(strength, before, after, trial));
  }

  [[nodiscard]] WorkingForces working_forces(const EndStrength& strength, const InterfaceState& before,
                                             const InterfaceState& after, const InterfaceTrial& trial) const {
    WorkingForces forces{weight_ * (trial.force - after.force), most_friction(strength, before, after, trial),
                         dashpot_delay_};
    if (settles_) forces.friction_at_end = borne_at_end(before, after, trial);
    return forces;
  }

  const InterfaceTrials& trials_;
  bool moves_;
  std::span<const InterfaceElement> elements_;
  std::span<const EndStrength> strengths_;
  std::span<InterfaceState> states_;
  const HeldUnknowns& held_;
  const Eigen::VectorXd& increment_;
  double weight_;
  bool settles_;
  double dashpot_delay_;
  bool gaps_are_foreseen_;  // and do no work
};

}  // namespace

double accept_contacts(const InterfaceTrials& trials, bool moves, BlockSystem& system) {
  const Acceptance acceptance(trials, moves, system);
  ContactWork work = system.audit.contact_work();
  const auto add = [](ContactWork& sum, const ContactWork& piece) { sum += piece; };
  parallel_accumulate(trials.size(), contacts_of_plain_sum, work, ContactWork{}, add,
                      [&](std::size_t first, std::size_t last, ContactWork& sum) {
                        for (std::size_t k = first; k < last; ++k) acceptance.accept(k, sum);
                      });
  system.audit.contacts_worked(work);
  return work.friction_beyond_end;
}

double taken_by_settling(const EnergyLedger& ledger) { return ledger.damping + ledger.numerical; }

void keep_friction_to_balance(double settling_before, double beyond_end, BlockSystem& system) {
  if (!system.plan.is_static) return;
  const double given = settling_before - taken_by_settling(system.audit.ledger());
  if (!(given > 0 && beyond_end > 0)) return;
  const double less = std::min(given, beyond_end);
  ContactWork work = system.audit.contact_work();
  work.friction -= less;
  work.numerical += less;
  system.audit.contacts_worked(work);
}

}  // namespace dda
