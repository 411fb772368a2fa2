#include "verification/fclib/step_of_run.h"

#include "engine/simulation/block_system.h"
#include "engine/simulation/force_balance.h"
#include "engine/simulation/simulation.h"
#include "engine/simulation/system_matrix.h"

namespace verify {
namespace {

struct Sorted {
  std::vector<int> changing, bonded;
};

Sorted sorted(const dda::ContactSet& contacts) {
  Sorted lists;
  for (std::size_t i = 0; i < contacts.elements.size(); ++i)
    (has_stress_rows(contacts.elements.but_for_blocks(i)) ? lists.bonded : lists.changing)
        .push_back(static_cast<int>(i));
  return lists;
}

}  // namespace

OwnedStep next_step(const dda::Simulation& simulation) {
  const dda::BlockSystem& s = simulation.system();
  const auto [changing, bonded] = sorted(s.contacts);
  OwnedStep step(dda::make_system_matrix(static_cast<int>(s.model.blocks.size()), s.contacts));
  assemble_base_matrix(s.coefficients, s.terms, s.damping, s.supports, s.contacts, bonded, step.base);
  form_rhs(s, step.rhs);
  step.guess = Eigen::VectorXd::Zero(step.rhs.size());
  step.areas = s.terms.area;
  step.places = changing;
  step.elements = s.contacts.elements.own();
  step.strengths = s.contacts.strengths;
  step.states = s.contacts.states;
  step.held = s.held;
  step.factor = s.coefficients.stiffness;
  return step;
}

}  // namespace verify
