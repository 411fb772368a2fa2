#include "engine/simulation/excavation.h"

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "engine/contact/make_contacts.h"
#include "engine/simulation/block_system.h"
#include "engine/simulation/general_step.h"
#include "engine/simulation/held_blocks.h"
#include "engine/simulation/linear_states.h"
#include "engine/simulation/loads_in_joints.h"
#include "engine/simulation/shared_ground.h"

namespace dda {
namespace {

void lay_to_rest(int block, State& state) {
  const auto i = static_cast<std::size_t>(block);
  state.velocity[i].setZero();
  state.acceleration[i].setZero();
  state.stress[i].setZero();
}

// One that comes in, with all that steps keep of it.
void place_as_drawn(int block, BlockSystem& s) {
  const auto i = static_cast<std::size_t>(block);
  s.state.displacement[i].setZero();
  s.state.deformation[i].setIdentity();
  lay_to_rest(block, s.state);
  const AreaMoments& moments = s.model.blocks[i].moments;
  s.terms.inertia[i] = {s.model.mass_of(block), mean_squares(moments), s.terms.inertia[i].strain_inertia};
  s.terms.area[i] = moments.area;
  s.terms.directions[i] = 0;
  s.terms.centrifugal[i].setZero();
}

// What the removed blocks exerted on the others is what internal forces lack without them, and the water that was in
// the joints to them.
void keep_as_loads(const Eigen::VectorXd& internal_before, BlockSystem& s) {
  Eigen::VectorXd exerted = s.forces.internal_old - internal_before;
  s.external.add_edge_loads(loads_that_go_with_blocks(s.clock.stage, s.model), s.state.time, exerted);
  s.held.clear(exerted);
  const State geometry = s.geometry_moves() ? s.state : initial_state(s.model);
  s.excavated.released.keep(Released::blocks, s.clock.stage, s.clock.start, exerted, geometry.deformation);
  s.loads_at(s.state.time, s.forces.load_old);
}

// J per m of thickness: what the weight of blocks that come in makes of their own tractions at projected joints stores,
// less than nothing (projected_law.h). They have no stress yet.
double stored_by_weight(const std::vector<int>& added, const ContactSet& contacts) {
  double stored = 0;
  if (contacts.outline_constant.empty()) return stored;
  for (const int block : added) stored -= contacts.outline_constant[static_cast<std::size_t>(block)];
  return stored;
}

}  // namespace

void draw_all(BlockSystem& s, std::unique_ptr<GeneralStep>& general) {
  if (s.excavated.absent.empty()) return;
  s.excavated = {};
  s.state = initial_state(s.model);
  s.contacts = make_contacts(s.model);
  s.terms = make_block_terms(s.model);
  s.held = make_held_unknowns(s.model);
  s.external = ExternalForces(s.model, s.state, s.waves);
  general = std::make_unique<GeneralStep>(s);
}

void leave_out_absent(BlockSystem& s, GeneralStep& general) {
  const std::vector<bool>& absent = s.excavated.absent = s.model.absent_in(s.clock.in_force());
  if (absent.empty()) return;
  s.held = make_held_unknowns(s.model, absent);
  s.external.leave_out(s.model, absent);
  for (std::size_t i = 0; i < absent.size(); ++i)
    if (absent[i]) s.terms.inertia[i].mass = 0;
  general.set_blocks(absent);
}

void bring_in(BlockSystem& s, GeneralStep& general) {
  const std::vector<int>& added = s.stage().rock.added;
  if (added.empty()) return;
  s.excavated.absent = s.model.absent_in(s.clock.stage);
  std::vector<bool> absent = s.excavated.absent;
  absent.resize(s.model.blocks.size(), false);
  s.held = make_held_unknowns(s.model, absent);
  s.external.leave_out(s.model, absent);
  for (const int block : added) place_as_drawn(block, s);
  note_came_in_over(added, s);
  general.set_blocks(absent, added, s.plan.linear);
  s.loads_at(s.state.time, s.forces.load_old);
  if (s.plan.linear) return;               // new contacts exert nothing, and the others are as they were
  refresh_tractions(s.state, s.contacts);  // their gaps were measured anew
  s.sum_internal_forces(s.forces.internal_old);
  s.audit.rock_changed(0, 0, stored_by_weight(added, s.contacts));
  s.audit.geometry_followed(s.stored_energy_now());
}

void excavate(BlockSystem& s, GeneralStep& general) {
  const Removal& removal = s.stage().removal;
  if (removal.blocks.empty()) return;
  ContactSet at_rest = s.contacts;  // what a linear stage keeps of them
  if (s.plan.linear) write_linear_states(s);
  // Before contacts are looked for where the blocks are now: some of their forces are others then, and it is with those
  // of the last step that the blocks were in balance.
  const Eigen::VectorXd internal_before = s.forces.internal_old;
  if (s.plan.finite_kinematics) general.place_geometry(0);
  const StoredEnergy stored = s.stored_energy_now();
  leave_out_absent(s, general);
  for (const int block : removal.blocks) lay_to_rest(block, s.state);
  s.audit.blocks_removed(stored, s.stored_energy_now());
  s.sum_internal_forces(s.forces.internal_old);
  if (removal.relaxation) keep_as_loads(internal_before, s);
  if (!s.plan.linear) return;
  leave_out(s.excavated.absent, at_rest);
  fit_to_neighbours(s.model, at_rest);
  s.contacts = std::move(at_rest);
}

}  // namespace dda
