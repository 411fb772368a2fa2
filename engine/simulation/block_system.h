// The block system in a run: the model, where its blocks are, and everything that acts on or between them. Both kinds
// of steps work on it; what only one of them needs it keeps itself.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/contact/contact_set.h"
#include "engine/linear/block_matrix.h"
#include "engine/model/model.h"
#include "engine/model/state.h"
#include "engine/simulation/block_terms.h"
#include "engine/simulation/bolt_set.h"
#include "engine/simulation/energy_audit.h"
#include "engine/simulation/excavated.h"
#include "engine/simulation/external_forces.h"
#include "engine/simulation/forces_of_parts.h"
#include "engine/simulation/kept_forces.h"
#include "engine/simulation/lining_set.h"
#include "engine/simulation/load_time.h"
#include "engine/simulation/settling_drag.h"
#include "engine/simulation/small_motion.h"
#include "engine/simulation/stage_clock.h"
#include "engine/simulation/step_coefficients.h"
#include "engine/simulation/step_plan.h"
#include "engine/simulation/support_set.h"
#include "engine/simulation/unsettled_steps.h"
#include "engine/solve/costs.h"
#include "engine/solve/held_unknowns.h"
#include "engine/waves/wave_corrections.h"

namespace dda {

class FreeField;

// Forces on the blocks' unknowns, 6 entries a block, without weight. `old`: at the state's time; `now`: at the end of
// the step under way.
struct BlockForces {
  Eigen::VectorXd load_old, load_new;
  Eigen::VectorXd internal_old, internal_new;
  Eigen::VectorXd by_faces;           // what loads on faces add to those of the start in the step under way
                                      // (face_loads.h); empty: nothing
  KeptForces kept;                    // of the start of the step under way
  std::vector<Vec6> measured;         // what measuring gaps anew made of forces on held.blocks since the last step
  double most_exchanged = 0;          // N per m of thickness, in the static stage under way (equilibrium.h)
  std::vector<double> asked_balance;  // the same unit, of each block, in the step under way; empty: not asked

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [load_old, load_new, internal_old, internal_new, by_faces, kept, measured, most_exchanged, asked_balance] =
        self;
    archive.of_blocks(load_old, 6);
    archive.of_blocks(internal_old, 6);
    archive(measured, most_exchanged);  // the others are written before they are read, or zero between steps
  }
};

// What is watched of a run while it goes on: its energies, how far blocks go in small kinematics, which steps were
// not settled as a whole, and what acted in those that were taken in parts.
struct RunAudit : EnergyAudit {
  SmallMotionWatch small_motion;
  UnsettledSteps unsettled;
  ForcesOfParts forces_of_parts;  // of the last step, which no part of a run begins with

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    using Energies = std::conditional_t<std::is_const_v<Self>, const EnergyAudit, EnergyAudit>;
    archive(static_cast<Energies&>(self), self.small_motion, self.unsettled);
  }
};

// What is put into the rock and onto it.
struct Reinforcement {
  Reinforcement(const Model& model, const State& state) : bolts(model, state), linings(model, state) {}

  BoltSet bolts;
  LiningSet linings;

  // Blocks that bolts and linings couple which have been put in.
  [[nodiscard]] std::vector<std::pair<int, int>> pairs() const;

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [bolts, linings] = self;
    archive(bolts, linings);
  }
};

struct BlockSystem {
  explicit BlockSystem(Model finished_model);
  ~BlockSystem();
  BlockSystem(const BlockSystem&) = delete;
  BlockSystem& operator=(const BlockSystem&) = delete;

  Model model;
  State state;
  ContactSet contacts;
  WaveCorrections waves;  // of the linear stage begun last; at first, of the first stage
  std::vector<SupportElement> supports;
  Reinforcement reinforcement;
  HeldUnknowns held;  // absent blocks among them
  BlockTerms terms;
  BlockDamping damping;
  ExternalForces external;
  Excavated excavated;
  std::unique_ptr<FreeField> free_field;  // only where a side has one
  RunAudit audit;
  Costs costs;

  StageClock clock;
  StepPlan plan;                  // of the stage
  StepCoefficients coefficients;  // of the step under way
  BlockForces forces;
  Eigen::VectorXd increment;  // of the last step tried, 6 entries a block
  SettlingDrag drag;          // in static stages

  [[nodiscard]] const Stage& stage() const { return model.stages[clock.stage]; }
  // The same; between stages, and after the last, the one that ended.
  [[nodiscard]] const Stage& stage_in_force() const;
  [[nodiscard]] double end_of_stage() const;
  [[nodiscard]] double end_of_step(double dt) const;
  // For which loads and prescribed motions are meant as they are, and at the end of a step of `dt` from now.
  [[nodiscard]] LoadTime load_time() const;
  [[nodiscard]] LoadTime load_time_after(double dt) const;
  // Passes of the open-close iteration in the step under way, those of attempts that did not settle among them.
  [[nodiscard]] std::int64_t passes_of_step() const {
    return costs.counters.open_close_iterations - clock.passes_before_step;
  }

  // Geometry of a scene whose blocks never left the drawing is that of the model.
  [[nodiscard]] bool geometry_moves() const;

  // Loads (without weight) at `time`, s.
  void loads_at(double time, Eigen::VectorXd& force) const;
  void loads_at(const LoadTime& time, Eigen::VectorXd& force) const;

  // Forces of stresses, interfaces, supports, bolts and linings, as they are.
  void sum_internal_forces(Eigen::VectorXd& force) const;
  [[nodiscard]] StoredEnergy stored_energy_now() const;

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [model, state, contacts, waves, supports, reinforcement, held, terms, damping, external, excavated,
           free_field, audit, costs, clock, plan, coefficients, forces, increment, drag] = self;
    const bool moves = self.geometry_moves();
    // Elsewhere their gaps follow from the state (linear_state).
    if (!model.stays_linear() || model.adds_blocks() || changes_springs(model)) archive(contacts);
    if (moves) archive(terms);
    archive.each(supports);
    archive(reinforcement, external, excavated, audit, forces, drag, plan.chi.largest, plan.chi.of_most, plan.solver);
    archive.of_blocks(increment, 6);
    for (auto& [block, matrix] : damping) archive(matrix);
    if (free_field) archive(*free_field);
    // State and clock are saved beside this; all else follows from the model.
  }

  // External less internal forces at the state's time: what is left of static equilibrium.
  [[nodiscard]] Eigen::VectorXd unbalanced_forces() const;
};

}  // namespace dda
