#include "engine/simulation/block_system.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/contact/make_contacts.h"
#include "engine/linear/block_vectors.h"
#include "engine/simulation/acting_damping.h"
#include "engine/simulation/free_field.h"
#include "engine/simulation/held_blocks.h"
#include "engine/terms/elasticity.h"

namespace dda {

std::vector<std::pair<int, int>> Reinforcement::pairs() const {
  std::vector<std::pair<int, int>> pairs = bolts.pairs();
  const std::vector<std::pair<int, int>> lined = linings.pairs();
  pairs.insert(pairs.end(), lined.begin(), lined.end());
  return pairs;
}

namespace {

ContactSet contacts_of(const Model& model) {
  ContactSet contacts = make_contacts(model);
  const bool changes = !model.stays_linear() || model.removes_blocks() || model.adds_blocks() ||
                       changes_materials(model) || changes_joints(model);
  if (!changes) contacts.elements.share();
  return contacts;
}

}  // namespace

BlockSystem::BlockSystem(Model finished_model)
    : model(std::move(finished_model)),
      state(initial_state(model)),
      contacts(contacts_of(model)),
      waves(model, model.stages.front(), contacts),
      supports(make_supports(model, state)),
      reinforcement(model, state),
      held(make_held_unknowns(model)),
      terms(make_block_terms(model)),
      damping(make_block_damping(model, state, 0)),
      external(model, state, waves) {
  const auto unknowns = static_cast<Eigen::Index>(6 * model.blocks.size());
  for (Eigen::VectorXd* vector :
       {&forces.load_old, &forces.load_new, &forces.internal_old, &forces.internal_new, &increment})
    vector->setZero(unknowns);
}

BlockSystem::~BlockSystem() = default;

const Stage& BlockSystem::stage_in_force() const { return model.stages[clock.in_force()]; }

double BlockSystem::end_of_stage() const { return clock.start + stage().length(); }

double BlockSystem::end_of_step(double dt) const {
  return stage_in_force().paces_itself() ? end_of_stage() : state.time + dt;
}

LoadTime BlockSystem::load_time() const {
  if (!stage_in_force().paces_itself()) return LoadTime::at(state.time);
  return {clock.start, end_of_stage(), clock.parts.share()};
}

LoadTime BlockSystem::load_time_after(double dt) const {
  if (!stage_in_force().paces_itself()) return LoadTime::at(state.time + dt);
  return {clock.start, end_of_stage(), clock.parts.next_share()};
}

bool BlockSystem::geometry_moves() const {
  const auto begun = model.stages.begin() + static_cast<std::ptrdiff_t>(clock.in_force() + 1);
  return std::any_of(model.stages.begin(), begun,
                     [](const Stage& each) { return each.kinematics == Kinematics::finite; });
}

void BlockSystem::loads_at(double time, Eigen::VectorXd& force) const {
  external.loads_at(time, force);
  excavated.released.add_loads_at(model, time, force);
  if (free_field) free_field->add_loads_at(time, acting_damping(stage_in_force()).stiffness, force);
}

void BlockSystem::loads_at(const LoadTime& time, Eigen::VectorXd& force) const {
  if (time.share >= 1) return loads_at(time.to, force);
  force = time.of([&](double then) {
    Eigen::VectorXd all(force.size());
    loads_at(then, all);
    return all;
  });
}

void BlockSystem::sum_internal_forces(Eigen::VectorXd& force) const {
  parallel_for_each(state.stress.size(), blocks_worth_sharing, [&](std::size_t i) {
    auto own = force.segment<6>(static_cast<Eigen::Index>(6 * i));
    own.head<3>().setZero();
    own.tail<3>() = stress_force(terms.area[i], state.stress[i]);
    if (!contacts.outline_compliance.empty())
      own.tail<3>() -= outline_force(contacts, i, terms.elasticity[i], state.stress[i]);
  });
  add_contact_force(contacts, force);
  waves.add_end_forces(model, state.stress, force);
  add_support_force(supports, force);
  reinforcement.bolts.add_force(force);
  reinforcement.linings.add_force(force);
}

StoredEnergy BlockSystem::stored_energy_now() const {
  StoredEnergy stored = stored_energy(terms, state, contacts, supports);
  stored.bolts = reinforcement.bolts.stored_energy();
  stored.linings = reinforcement.linings.stored_energy();
  return stored;
}

Eigen::VectorXd BlockSystem::unbalanced_forces() const {
  Eigen::VectorXd unbalanced = forces.load_old - forces.internal_old;
  if (plan.gravity) unbalanced += external.weight();
  return unbalanced;
}

}  // namespace dda
