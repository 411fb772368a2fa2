// Which terms and phases a scene needs: a step runs these and no others.
#pragma once

#include <string>
#include <vector>

#include "engine/contact/contact_set.h"
#include "engine/linear/solver_choice.h"
#include "engine/model/model.h"

namespace dda {

// Says for what waves are corrected.
struct CorrectedWaves {
  bool for_blocks = false;  // their size
  bool for_steps = false;
};

// Says which of these are there in the stage.
struct PlannedReinforcement {
  bool bolts = false;  // which can yield, break or go slack
  bool linings = false;
  bool linings_yield = false;  // some have a strength
};

struct StepPlan {
  bool loads = false;
  bool gravity = false;
  bool supports = false;
  bool moving_supports = false;
  bool held_blocks = false;
  bool viscous_edges = false;
  bool free_field = false;
  bool contacts = false;
  bool contacts_judged = false;  // some joint can open, slide or break
  PlannedReinforcement reinforcement;
  bool contacts_can_change = false;  // one of these: runs the open-close iteration
  bool dilation = false;             // some joint opens as it slides
  bool finite_kinematics = false;    // geometry and matrix are rebuilt every step
  bool linear = false;               // nothing can change: forces are one product with a constant matrix
  bool explicit_steps = false;       // and no system is solved
  CorrectedWaves waves;
  bool velocity_damping = false;
  bool is_static = false;
  StiffnessNumbers chi;
  SolverKind solver = SolverKind::cholesky;

  // One line a term or phase, for people.
  [[nodiscard]] std::vector<std::string> describe() const;
};

// Plans the steps of a stage of the model, counted from 0.
StepPlan make_plan(const Model& model, std::size_t stage_index, const ContactSet& contacts, int couplings,
                   const StiffnessNumbers& chi);

}  // namespace dda
