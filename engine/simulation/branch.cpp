#include "engine/simulation/branch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "engine/core/error.h"
#include "engine/simulation/archive.h"
#include "engine/simulation/block_system.h"
#include "engine/simulation/branch_rule.h"
#include "engine/simulation/excavation.h"
#include "engine/simulation/explicit_step.h"
#include "engine/simulation/free_field.h"
#include "engine/simulation/general_step.h"
#include "engine/simulation/held_blocks.h"
#include "engine/simulation/linear_step.h"
#include "engine/simulation/prescribed_motion.h"
#include "engine/simulation/rock_of_stage.h"
#include "engine/simulation/run_so_far.h"

namespace dda {
namespace {

// What a snapshot keeps of one part, for the same part of another simulation.
template <typename Part>
void carry(const Part& from, Part& to) {
  MemoryWriter writer;
  writer(from);
  const std::vector<std::byte> bytes = writer.take();
  MemoryReader reader(bytes);
  reader(to);
}

bool is_same_spring(const PointSupport& a, const PointSupport& b) {
  return a.block == b.block && a.point == b.point && a.holds_x == b.holds_x && a.holds_y == b.holds_y &&
         a.stiffness == b.stiffness && a.direction == b.direction && a.partner == b.partner;
}

// For every support of the new scene the same spring in the one before; each of those is given once.
std::vector<std::optional<std::size_t>> same_springs(const std::vector<PointSupport>& before,
                                                     const std::vector<PointSupport>& now) {
  std::vector<bool> taken(before.size(), false);
  std::vector<std::optional<std::size_t>> same(now.size());
  for (std::size_t i = 0; i < now.size(); ++i) {
    const std::size_t first = before.size() == now.size() && !taken[i] && is_same_spring(before[i], now[i]) ? i : 0;
    for (std::size_t j = first; j < before.size() && !same[i]; ++j)
      if (!taken[j] && is_same_spring(before[j], now[i])) same[i] = j;
    if (same[i]) taken[*same[i]] = true;
  }
  return same;
}

bool has_ended(const PointSupport& support, std::size_t stages_done) {
  return support.last_stage >= 0 && static_cast<std::size_t>(support.last_stage) < stages_done;
}

// A spring goes on with its force: only how its motion goes on counts, not where the new scene says it has got to.
void go_on(const PointSupport& then, const PointSupport& now, double time, SupportElement& support) {
  const Vec2 jump = prescribed_displacement(now, time) - prescribed_displacement(then, time);
  if (jump.isZero(0)) return;
  support.prescribed += jump;
  support.rest -= jump;
}

void put_in(const Model& model, const State& state, std::size_t index, SupportElement& support) {
  measure_gap(model, state, index, support);
  support.rest = support.gap;
  support.gap.setZero();
}

void take_over_supports(const BlockSystem& before, const State& geometry, BlockSystem& s) {
  update_geometry(s.model, geometry, s.supports);
  const auto same = same_springs(before.model.supports, s.model.supports);
  for (std::size_t i = 0; i < s.supports.size(); ++i) {
    const PointSupport& prescription = s.model.supports[i];
    const bool is_gone = same[i] && has_ended(before.model.supports[*same[i]], s.clock.stage);
    const bool ends = has_ended(prescription, s.clock.stage);
    if (same[i] && (!is_gone || ends)) {
      s.supports[i] = before.supports[*same[i]];
      go_on(before.model.supports[*same[i]], prescription, s.state.time, s.supports[i]);
      if (is_gone && leaves_force(prescription))
        s.external.keep_reaction(i, s.supports[i].offset, before.external.reaction(*same[i]));
    } else {
      put_in(s.model, s.state, i, s.supports[i]);
      if (ends) s.supports[i].stiffness.setZero();
    }
  }
}

// Forces of springs, bolts and linings, 6 entries a block.
Eigen::VectorXd forces_of_what_holds(const BlockSystem& s) {
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(s.forces.internal_old.size());
  add_support_force(s.supports, forces);
  s.reinforcement.bolts.add_force(forces);
  s.reinforcement.linings.add_force(forces);
  return forces;
}

void let_go_of_ended_supports(BlockSystem& s) {
  for (std::size_t i = 0; i < s.supports.size(); ++i)
    if (has_ended(s.model.supports[i], s.clock.stage) && !s.supports[i].stiffness.isZero(0)) let_go_of_support(i, s);
}

void take_over_what_holds(const BlockSystem& before, const State& geometry, BlockSystem& s) {
  take_over_supports(before, geometry, s);
  s.reinforcement.bolts.go_on_from(before.model, before.reinforcement.bolts, s.model, s.clock.stage, s.state, geometry);
  s.reinforcement.linings.go_on_from(before.model, before.reinforcement.linings, s.model, s.clock.stage, s.state,
                                     geometry);
  s.forces.internal_old = before.forces.internal_old;
  const Eigen::VectorXd change = forces_of_what_holds(s) - forces_of_what_holds(before);
  if (!change.isZero(0)) s.forces.internal_old += change;
  s.audit.supports_exchanged(support_energy(s.supports) - support_energy(before.supports),
                             s.reinforcement.bolts.stored_energy() - before.reinforcement.bolts.stored_energy(),
                             s.reinforcement.linings.stored_energy() - before.reinforcement.linings.stored_energy());
  let_go_of_ended_supports(s);
}

// Loads that are the same at this moment are those of the step before to the last bit.
void take_over_loads(const BlockSystem& before, const State& geometry, BlockSystem& s) {
  if (s.geometry_moves()) s.external.update_geometry(s.model, geometry);
  Eigen::VectorXd then = Eigen::VectorXd::Zero(s.forces.load_old.size());
  before.loads_at(s.state.time, then);
  s.loads_at(s.state.time, s.forces.load_old);
  if (s.forces.load_old == then) s.forces.load_old = before.forces.load_old;
}

void take_over_viscous_edges(const BlockSystem& before, const State& geometry, BlockSystem& s) {
  if (have_same_viscous_edges(before.model, s.model)) {
    s.damping = before.damping;
  } else {
    update_geometry(s.model, geometry, s.clock.in_force(), s.damping);
  }
}

// Held blocks go where they are told to go within the next step, however far that is.
void expect_held_blocks_in_place(const BlockSystem& s) {
  for_each_held_block(s.model, [&](const HeldMotions& motions) {
    const auto block = static_cast<std::size_t>(motions[0].block);
    const Vec3 off =
        prescribed_displacement(s.model, motions, s.state.time).head<3>() - s.state.displacement[block].head<3>();
    if (off.head<2>().norm() > s.model.length_tolerance || std::abs(off(2)) > 1e-9)
      throw InputError("", fmt::format("the held block \"{}\"", s.model.blocks[block].name),
                       fmt::format("{:.3g} m and {:.3g} rad from where its motion has it at {:.6g} s",
                                   off.head<2>().norm(), std::abs(off(2)), s.state.time),
                       "a motion that goes on from where the block is");
  });
}

void take_over_blocks(const BlockSystem& before, BlockSystem& s) {
  s.state = before.state;
  s.contacts = before.contacts;
  static_cast<void>(s.contacts.elements.edit());  // here they may change, where before they could not
  set_strain_inertia(s.stage_in_force(), s.terms);
  if (s.geometry_moves()) carry(before.terms, s.terms);
  s.excavated.released = before.excavated.released;
  s.audit = before.audit;
  s.increment = before.increment;
  s.drag = before.drag;
  s.plan = make_plan(s.model, s.clock.in_force(), s.contacts, 0, before.plan.chi);
  s.plan.solver = before.plan.solver;
  s.plan.linear = before.plan.linear;
  s.plan.explicit_steps = before.plan.explicit_steps;
}

}  // namespace

void Simulation::go_on_from(const Simulation& settled) {
  BlockSystem& s = *system_;
  const BlockSystem& before = settled.system();
  draw_all(s, general_);
  GeneralStep& general = *general_;
  s.clock = before.clock;
  leave_out_absent(s, general);
  take_over_blocks(before, s);
  take_rock_in_force(s);
  s.external.begin_stage(s.model, s.clock.in_force());
  s.costs.counters = settled.counters();
  carry(*settled.general_, general);
  carry(*settled.linear_, *linear_);
  carry(*settled.explicit_, *explicit_);
  renew_strengths(general.follows_contacts(), s);
  if (s.free_field) s.free_field->go_on_from(*before.free_field);
  const State geometry = s.geometry_moves() ? general.acting() : initial_state(s.model);
  take_over_what_holds(before, geometry, s);
  if (s.model.gravity != before.model.gravity) s.audit.rock_changed(0, 0, renew_weights(s));
  take_over_loads(before, geometry, s);
  take_over_viscous_edges(before, geometry, s);
  pace_ = settled.pace_;
  results_.go_on_from(settled.results_, s.clock.stage);
  stage_step().set_up(general.pattern());
  begin_stage();
}

void go_on_from(const Simulation& settled, Simulation& fresh) { fresh.go_on_from(settled); }

void begin_from(const Simulation& settled, Simulation& fresh) {
  if (settled.system().clock.begun)
    throw InputError("", "the state to go on from", "within a stage", "one between two stages");
  expect_same_past(settled.model(), fresh.model(), stages_done(settled));
  if (settled.follows_contacts() != fresh.follows_contacts())
    throw InputError("", "steps", fresh.follows_contacts() ? "with blocks that move against each other" : "as drawn",
                     settled.follows_contacts() ? "stages of which one is in finite kinematics"
                                                : "small kinematics throughout, as in the run to go on from");
  if (!fresh.model().free_field_sides.empty() && !settled.finished())
    throw InputError("", "viscous_boundaries", "with free-field sides",
                     "none where the state to go on from is not the end of its run");
  go_on_from(settled, fresh);
  expect_held_blocks_in_place(fresh.system());
}

}  // namespace dda
