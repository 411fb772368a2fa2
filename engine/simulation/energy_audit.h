// Keeps the energy ledger, step by step.
//
// The work of a force over a step is taken by the trapezoidal rule, d . (F0 + F1)/2. The integrator balances weighted
// forces and accelerations instead; what that makes of the step, written out in increments, is its numerical
// dissipation:
//   d . M a_w - (change of kinetic energy) + (1/2 - alpha_f) d . (change of internal force)
//     - d . (F_w - (F0 + F1)/2)
// with F_w = (1 - alpha_f) F1 + alpha_f F0. Stored energies come from velocities, stresses and gaps, so the residual is
// a check on solver, forces and state update together, not an identity.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "engine/contact/contact_set.h"
#include "engine/model/energy.h"
#include "engine/model/state.h"
#include "engine/simulation/block_terms.h"
#include "engine/simulation/contact_work.h"
#include "engine/simulation/step_coefficients.h"
#include "engine/simulation/support_set.h"

namespace dda {

double kinetic_energy(const BlockTerms& terms, const State& state);
double strain_energy(const BlockTerms& terms, const State& state);
StoredEnergy stored_energy(const BlockTerms& terms, const State& state, const ContactSet& contacts,
                           const std::vector<SupportElement>& supports);

// Forces at both ends of a step, 6 entries a block; weight may be empty.
struct StepForces {
  const Eigen::VectorXd& load_old;
  const Eigen::VectorXd& load_new;
  const Eigen::VectorXd& weight;
  const Eigen::VectorXd& internal_old;
  const Eigen::VectorXd& internal_new;
  const Eigen::VectorXd& jump;  // how much of internal_old did not act (measured_anew.h); may be empty
};

// Work d . M a_w against the inertia of blocks that are not coupled by it; before the state moves.
double inertia_work(const StepCoefficients& step, const BlockTerms& terms, const State& state,
                    const Eigen::VectorXd& d);

// What the first steps of a stage make of its first accelerations and lose again, J per m of thickness
// (gain_at_start.h): what is there of it for a while tells nothing of the run.
struct MadeOfStart {
  double free_step = 0;  // kinetic energy that these accelerations would give in one step
  double left = 0;       // at most there of it at the end of the last step
};

class EnergyAudit {
 public:
  MadeOfStart of_start;

  void start(const StoredEnergy& stored);

  // Work against dashpots in the step by the mean of their forces, and what the integrator's weights make of it; before
  // the state moves, since it needs the old velocities and accelerations.
  void dashpots_worked(const StepCoefficients& step, const BlockDamping& damping, const State& state,
                       const Eigen::VectorXd& d);

  // Books a step. `inertia_work`: d . M a_w.
  void record(const StepCoefficients& step, double inertia_work, const StoredEnergy& stored, const StepForces& forces,
              const Eigen::VectorXd& d);
  // The same from sums, J per m of thickness: of loads, of weight, d . M a_w, and what the integrator's weights of
  // forces other than those of the trapezoidal rule make of a step.
  struct StepWorks {
    double loads, weight, inertia, weighting = 0;
  };
  void record(const StepWorks& works, const StoredEnergy& stored);

  // What contacts have taken and brought in so far, to go on from, and with a step more.
  [[nodiscard]] ContactWork contact_work() const {
    return {ledger_.external_work, ledger_.friction, ledger_.dashpot, ledger_.numerical};
  }
  void contacts_worked(const ContactWork& so_far) {
    ledger_.external_work = so_far.brought;
    ledger_.friction = so_far.friction;
    ledger_.dashpot = so_far.dashpot;
    ledger_.numerical = so_far.numerical;
  }

  // A bolt, or an element of a lining, in the step: what it dissipated, and what else of the work on it is not stored.
  void bolt_changed(double plastic, double numerical) {
    ledger_.plastic += plastic;
    ledger_.numerical += numerical;
  }

  // What Rayleigh damping took by the mean of its forces, and what of it is the integrator's doing, as the balance of
  // the step had others.
  void damping_worked(double work, double by_integrator) {
    ledger_.damping += work;
    ledger_.numerical += by_integrator;
  }

  // Dampers changed velocities at once, by which the kinetic energy grew, where what moves them brought in this much.
  // What they bring beyond that is of the loads that they were in balance with.
  void velocities_jumped(double brought, double kinetic) {
    const double lost = std::max(0.0, brought - kinetic);
    ledger_.kinetic += kinetic;
    ledger_.external_work += kinetic + lost;
    ledger_.damping += lost;
  }

  // Work against dashpots, and what damping in proportion to mass took, in a step that has summed these up itself.
  void dampers_worked(double radiated, double damping) {
    ledger_.radiated += radiated;
    ledger_.damping += damping;
  }

  // An interface went over to another law with this loss of stored energy (J per m of thickness).
  void interface_replaced(double loss) { replaced_ += loss; }

  // Areas, inertia and gaps were measured anew in the geometry reached: what that changed counts as numerical. Where
  // stretches also went over to springs (`other_laws`), what strains and contacts store now and did not is of these.
  void geometry_followed(const StoredEnergy& stored, bool other_laws = false);

  // From here on the kinetic energy is counted in another way, which gives this much: so is what there was at the
  // start, and no step has gained or lost the difference.
  void kinetic_counted_as(double kinetic) {
    ledger_.initial.kinetic += kinetic - ledger_.kinetic;
    ledger_.kinetic = kinetic;
  }

  // Work of a support's prescribed motion, and of what was foreseen of its gap.
  void support_moved(const SupportElement& before, const SupportElement& after);

  // The motion of held blocks: work (J per m of thickness) of the forces that moved them, by their values at the start
  // and at the end of the step. No integrator acts on these blocks: what record() took for its doing is taken back.
  // `by_measuring`: how much of those at the start came of gaps that were measured anew, and `by_jump` what of that the
  // balance did not have (measured_anew.h). It has of the rest as much as it has without that, alpha_f of the start and
  // what is left of the end, and their mean is off by what is taken off here; it counts as numerical, as measuring anew
  // itself does.
  void held_blocks_moved(const StepCoefficients& step, double by_old, double by_new, double by_measuring,
                         double by_jump) {
    const double off_centre = 0.5 - step.load_old;  // 1/2 - alpha_f
    ledger_.external_work += (by_old + by_new) / 2 - off_centre * by_measuring - step.load_old * by_jump;
    ledger_.numerical -= off_centre * (by_new - by_old + by_measuring);
  }
  // Work against forces that the balance had but no state keeps.
  void moved_against(double work) { ledger_.external_work += work; }

  // A support was let go that had stored this energy (J per m of thickness): whoever takes it away takes that as well.
  void support_let_go(double energy) {
    ledger_.external_work -= energy;
    ledger_.contact -= energy;
  }

  // Supports and bolts were put in and taken away, by which the stored energies grew: whoever does it works.
  void supports_exchanged(double contact, double bolts, double linings = 0) {
    ledger_.contact += contact;
    ledger_.bolts += bolts;
    ledger_.linings += linings;
    ledger_.external_work += contact + bolts + linings;
  }

  // Masses, moduli and springs changed, by which what velocities, stresses and forces store grew: whatever changes them
  // works.
  void rock_changed(double kinetic, double strain, double contact) {
    ledger_.kinetic += kinetic;
    ledger_.strain += strain;
    ledger_.contact += contact;
    ledger_.external_work += kinetic + strain + contact;
  }

  // Blocks were removed, by which the stored energies fell.
  void blocks_removed(const StoredEnergy& before, const StoredEnergy& after);

  // Velocities were multiplied by `factor`.
  void velocities_damped(double factor);

  // A stage begins. Nothing counts as gained for a while where blocks settle: static steps go from one guess at a
  // balance to the next and keep no velocity, so what contacts store on the way stays in the stage, whatever its dt.
  void begin_stage(bool settles) {
    numerical_before_ = ledger_.numerical;
    law_changes_before_ = ledger_.law_changes;
    damping_before_ = ledger_.damping;
    lost_before_ = settles ? -std::numeric_limits<double>::infinity() : lost();
  }
  // What a stage lost to time integration and to other laws was settling, as the velocities that static steps take out
  // are. (Counted as numerical it would hide what later stages gain.)
  void has_settled();
  // A stage is over whose steps took most of every velocity. They left the accelerations, and what these do in the next
  // step seems to come from the integrator: it is off what the steps took, as far as that goes.
  void has_taken_velocities();

  [[nodiscard]] const EnergyLedger& ledger() const { return ledger_; }

  // The most, at the end of any step of a stage in motion, that was stored beyond what the stage began with and what
  // was brought in it (J per m of thickness), less what the stage's first steps made of its start. What a run gains for
  // a while it can lose again, and its sums at the end tell nothing of it.
  [[nodiscard]] double most_gained() const { return std::max(most_gained_, lost_before_ - lost() - of_start.left); }

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [of_start, ledger, replaced, numerical_before, law_changes_before, damping_before, lost_before, most_gained] =
        self;
    archive(of_start.free_step, of_start.left, ledger, replaced, numerical_before, law_changes_before, damping_before,
            lost_before, most_gained);
  }

 private:
  // All that went elsewhere, whatever took it.
  [[nodiscard]] double lost() const {
    return ledger_.friction + ledger_.plastic + ledger_.radiated + ledger_.dashpot + ledger_.damping + ledger_.removed -
           ledger_.gained();
  }

  EnergyLedger ledger_;
  double replaced_ = 0;            // losses by interface_replaced in the step under way
  double numerical_before_ = 0;    // losses of the stages before, by time integration
  double law_changes_before_ = 0;  // the same, where joints went over to springs
  double damping_before_ = 0;      // and by damping
  double lost_before_ = 0;         // and all of them; -infinity in a stage in which nothing counts as gained
  double most_gained_ = 0;         // up to the start of the step under way
};

}  // namespace dda
