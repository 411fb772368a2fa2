#include "engine/simulation/step_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "engine/simulation/support_set.h"

namespace dda {
namespace {

SolverKind solver_for(const Model& model, const Stage& stage, int couplings, const StepPlan& plan) {
  switch (stage.solver) {
    case SolverRequest::cholesky: return SolverKind::cholesky;
    case SolverRequest::pcg: return SolverKind::pcg;
    case SolverRequest::dense: return SolverKind::dense;
    case SolverRequest::petsc: return SolverKind::petsc;
    case SolverRequest::automatic: break;
  }
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const StiffnessNumbers chi = plan.is_static ? StiffnessNumbers{infinite, infinite} : plan.chi;
  return choose_solver({static_cast<int>(model.blocks.size()), couplings, chi, plan.finite_kinematics});
}

bool has_law(const ContactSet& contacts, InterfaceLaw law) {
  return std::ranges::any_of(contacts.elements.kinds(),
                             [&](const InterfaceElement& element) { return element.law == law; });
}

}  // namespace

StepPlan make_plan(const Model& model, std::size_t stage_index, const ContactSet& contacts, int couplings,
                   const StiffnessNumbers& chi) {
  const Stage& stage = model.stages[stage_index];
  StepPlan plan;
  const auto fades = [](const auto& each) { return each.withdrawal.relaxation.has_value(); };
  plan.free_field = !model.free_field_sides.empty();
  plan.loads =
      plan.free_field || !model.point_loads.empty() || !model.edge_loads.empty() ||
      std::any_of(model.supports.begin(), model.supports.end(), leaves_force) ||
      std::ranges::any_of(model.stages, [](const Stage& each) { return each.removal.relaxation.has_value(); }) ||
      std::ranges::any_of(model.bolts, fades) || std::ranges::any_of(model.linings, fades);
  plan.gravity = !model.gravity.isZero();
  plan.supports = !model.supports.empty();
  plan.moving_supports = std::any_of(model.supports.begin(), model.supports.end(),
                                     [](const PointSupport& support) { return !support.amplitude.isZero(0); });
  plan.held_blocks = !model.held_blocks.empty();
  plan.viscous_edges = !model.viscous_edges.empty();
  plan.contacts = !contacts.interfaces.empty();
  const auto is_there = [stage_index](const auto& each) {
    return static_cast<std::size_t>(each.first_stage) <= stage_index && !each.withdrawal.is_over_in(stage_index);
  };
  plan.reinforcement.bolts = std::ranges::any_of(model.bolts, is_there);
  plan.reinforcement.linings = std::ranges::any_of(model.linings, is_there);
  plan.reinforcement.linings_yield =
      std::ranges::any_of(model.linings, [&](const Lining& lining) { return is_there(lining) && lining.yields(); });
  plan.contacts_can_change = contacts.can_change || plan.reinforcement.bolts;
  plan.contacts_judged = contacts.can_change;
  plan.dilation = plan.contacts_can_change && std::any_of(model.joints.begin(), model.joints.end(),
                                                          [](const auto& joint) { return joint.dilation_angle > 0; });
  plan.finite_kinematics = stage.kinematics == Kinematics::finite;
  plan.linear = !plan.contacts_can_change && !plan.reinforcement.linings_yield && !plan.finite_kinematics;
  plan.explicit_steps = plan.linear && stage.integrator.is_explicit();
  const Stage acting = model.with_acting_corrections(stage);
  const bool in_mesh = has_law(contacts, InterfaceLaw::consistent);
  plan.waves.for_blocks = acting.correct_block_dispersion && in_mesh;
  plan.waves.for_steps = acting.correct_time_dispersion && (in_mesh || has_law(contacts, InterfaceLaw::cubic));
  plan.velocity_damping = stage.velocity_factor != 1 || stage.damping_rate != 0;
  plan.is_static = stage.integrator.is_static;
  plan.chi = chi;
  plan.solver = solver_for(model, stage, couplings, plan);
  return plan;
}

std::vector<std::string> StepPlan::describe() const {
  std::vector<std::string> lines{"inertia", "elasticity (carried stress)"};
  const auto add = [&](bool needed, const std::string& line) {
    if (needed) lines.push_back(line);
  };
  add(loads, "loads");
  add(gravity, "gravity");
  add(supports, moving_supports ? "supports, moving" : "supports");
  add(held_blocks, "held blocks: taken out of the system");
  add(reinforcement.bolts, "bolts: open-close iteration");
  add(reinforcement.linings,
      reinforcement.linings_yield ? "linings: beams on the wall, which can yield" : "linings: beams on the wall");
  add(viscous_edges, "viscous boundary");
  add(free_field, "free field: columns beside the sides, stepped first");
  add(contacts, contacts_judged ? "contacts: open-close iteration" : "contacts: bonded, never judged");
  add(dilation, "dilation of joints that slide");
  add(linear, "linear: forces by one constant matrix");
  add(waves.for_blocks, "waves: corrected for the size of blocks (stress in blocks at free faces: to first order)");
  add(waves.for_steps, "waves: corrected for the time steps");
  add(finite_kinematics, "geometry: updated, matrix rebuilt every step");
  add(!finite_kinematics, "geometry: as drawn, matrix built once");
  add(velocity_damping, "velocity damping");
  lines.push_back(explicit_steps ? "solve: explicit, accelerations block by block"
                                 : fmt::format("solve: {} ({})", to_string(solver), in_words(chi)));
  return lines;
}

}  // namespace dda
