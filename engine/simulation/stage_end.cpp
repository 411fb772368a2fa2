#include "engine/simulation/stage_end.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

#include "engine/contact/open_close.h"
#include "engine/simulation/block_system.h"
#include "engine/simulation/equilibrium.h"
#include "engine/simulation/held_blocks.h"
#include "engine/terms/velocity_damping.h"

namespace dda {
namespace {

template <typename Item>
void append(std::vector<Item> more, std::vector<Item>& list) {
  std::ranges::move(more, std::back_inserter(list));
}

// Blocks pass through each other in static steps as nothing lets them: only what is left of that is an answer.
void note_shared_ground(const BlockSystem& s, StageResults& results) {
  if (!s.plan.is_static) return;
  if (const auto left = shared_ground_of_stage(s)) results.shared_ground.push_back(*left);
}

}  // namespace

void release_shear_of_contacts(BlockSystem& s) {
  ContactSet& contacts = s.contacts;
  bool released = false;
  InterfaceElement room;
  for (std::size_t i = 0; i < contacts.elements.size(); ++i)
    released = release_shear(contacts.elements.read(i, room), contacts.strengths[i], contacts.states[i]) || released;
  if (!released) return;
  s.audit.geometry_followed(s.stored_energy_now());
  s.sum_internal_forces(s.forces.internal_old);
}

void give_up_unlimited_strength(BlockSystem& s) {
  release_shear_of_contacts(s);
  if (s.plan.is_static) s.audit.has_settled();
}

void close_books_of_stage(BlockSystem& s) {
  // Steps that leave three quarters lose energy by their integrator, and steps that leave half seem to gain by it.
  constexpr double little_is_left = 0.5;
  const Stage& stage = s.stage();
  if (s.plan.is_static)
    s.audit.has_settled();
  else if (velocity_factor(stage.velocity_factor, stage.damping_rate, s.coefficients.dt) <= little_is_left)
    s.audit.has_taken_velocities();
}

void let_go_of_loose_blocks(BlockSystem& s) {
  const bool any = !s.drag.loose().empty();
  s.drag = {};
  if (any) s.held = make_held_unknowns(s.model, s.excavated.absent);
}

void note_results(const BlockSystem& s, double in_situ_force, StageResults& results) {
  if (s.plan.is_static) results.out_of_balance[s.clock.stage] = out_of_balance(s, in_situ_force);
  append(placed(s, s.drag.loose()), results.loose);
  append(find_blocks_out_of_balance(s, in_situ_force), results.unbalanced);
  append(excess_by_joint(s), results.excess);
  note_shared_ground(s, results);
  if (const auto apart = water_apart(s.model, s.state, s.clock.stage)) results.water_apart.push_back(*apart);
}

std::string problem_at_end_of(std::size_t stage, const Model& model, const StageResults& ends) {
  return equilibrium_problem(
      model, {stage, ends.out_of_balance[stage], of_stage(stage, ends.loose), of_stage(stage, ends.unbalanced)});
}

}  // namespace dda
