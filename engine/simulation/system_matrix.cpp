#include "engine/simulation/system_matrix.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

#include "engine/solve/step_matrix.h"
#include "engine/terms/elasticity.h"
#include "engine/terms/support.h"

namespace dda {
namespace {

void add_blocks(const StepCoefficients& step, const BlockTerms& terms, const ContactSet& contacts,
                BlockMatrix& matrix) {
  for (std::size_t i = 0; i < terms.inertia.size(); ++i) {
    auto diagonal = matrix.diagonal(static_cast<int>(i));
    diagonal += step.mass * mass_matrix(terms.inertia[i]);
    diagonal.bottomRightCorner<3, 3>() += step.stiffness * strain_stiffness(terms.area[i], terms.elasticity[i]);
    if (!contacts.outline_compliance.empty())
      diagonal.bottomRightCorner<3, 3>() -= step.stiffness * outline_stiffness(contacts, i, terms.elasticity[i]);
  }
}

void add_all_but_contacts(const StepCoefficients& step, const BlockTerms& terms, const BlockDamping& damping,
                          const std::vector<SupportElement>& supports, const ContactSet& contacts,
                          BlockMatrix& matrix) {
  matrix.set_zero();
  add_blocks(step, terms, contacts, matrix);
  for (const auto& [block, c] : damping) matrix.diagonal(block) += step.damping * c;
  for (const SupportElement& support : supports)
    matrix.diagonal(support.block) += step.stiffness * support_stiffness(support.rows, support.stiffness);
}

// The lesser mass of the two blocks, held ones aside; infinite where both are held.
double least_mass(const BlockTerms& terms, int a, int b) {
  double least = std::numeric_limits<double>::infinity();
  for (const int block : {a, b}) {
    const double mass = terms.inertia[static_cast<std::size_t>(block)].mass;
    if (mass > 0) least = std::min(least, mass);
  }
  return least;
}

}  // namespace

BlockMatrix make_system_matrix(int blocks, const ContactSet& contacts, std::vector<std::pair<int, int>> others) {
  for (const Interface& interface : contacts.interfaces) others.emplace_back(interface.block_a, interface.block_b);
  return {blocks, std::move(others)};
}

void assemble(const StepCoefficients& step, const BlockTerms& terms, const BlockDamping& damping,
              const std::vector<SupportElement>& supports, const ContactSet& contacts, const std::vector<Vec4>& active,
              BlockMatrix& matrix) {
  add_all_but_contacts(step, terms, damping, supports, contacts, matrix);
  InterfaceElement room;
  for (std::size_t i = 0; i < contacts.elements.size(); ++i)
    add_contact(step.stiffness, contacts.elements.read(i, room), {active[i], 0}, true, true, matrix);
}

void assemble_base_matrix(const StepCoefficients& step, const BlockTerms& terms, const BlockDamping& damping,
                          const std::vector<SupportElement>& supports, const ContactSet& contacts,
                          std::span<const int> bonded, BlockMatrix& matrix) {
  add_all_but_contacts(step, terms, damping, supports, contacts, matrix);
  InterfaceElement room;
  for (const int i : bonded)
    add_contact(step.stiffness, contacts.elements.read(static_cast<std::size_t>(i), room), {}, true, true, matrix);
}

StiffnessNumbers stiffness_numbers(const ContactSet& contacts, const BlockTerms& terms, double dt) {
  std::vector<double> chi(contacts.interfaces.size());
  for (std::size_t i = 0; i < chi.size(); ++i) {
    const double mass = least_mass(terms, contacts.interfaces[i].block_a, contacts.interfaces[i].block_b);
    chi[i] = normal_stiffness(contacts.elements.but_for_blocks(i)) * dt * dt / mass;
  }
  if (chi.empty()) return {};
  const auto tenth = chi.begin() + static_cast<std::ptrdiff_t>(chi.size() * 9 / 10);
  std::ranges::nth_element(chi, tenth);
  return {.largest = *std::max_element(tenth, chi.end()), .of_most = *tenth};
}

}  // namespace dda
