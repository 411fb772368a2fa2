#include "engine/simulation/system_matrix.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

#include "engine/terms/elasticity.h"
#include "engine/terms/support.h"

namespace dda {
namespace {

void add_blocks(const StepCoefficients& step, const BlockTerms& terms, BlockMatrix& matrix) {
  for (std::size_t i = 0; i < terms.inertia.size(); ++i) {
    auto diagonal = matrix.diagonal(static_cast<int>(i));
    diagonal += step.mass * mass_matrix(terms.inertia[i]);
    diagonal.bottomRightCorner<3, 3>() += step.stiffness * strain_stiffness(terms.area[i], terms.elasticity[i]);
  }
}

// Of the blocks that are not held; infinite where both are.
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
  return make_system_matrix(blocks, std::move(others));
}

BlockMatrix make_system_matrix(int blocks, std::vector<std::pair<int, int>> pairs) {
  return {blocks, std::move(pairs)};
}

void add_contact(double factor, const InterfaceElement& element, const Vec4& mask, bool in_a, bool in_b,
                 BlockMatrix& matrix) {
  if (mask.isZero(0) && !has_stress_rows(element)) return;  // open
  const InterfaceMatrices k = stiffness_of(element, mask);
  if (in_a) matrix.diagonal(element.block_a) += factor * k.aa;
  if (in_b) matrix.diagonal(element.block_b) += factor * k.bb;
  if (in_a && in_b) matrix.add_coupling(element.block_b, element.block_a, factor * k.ba);
}

void assemble(const StepCoefficients& step, const BlockTerms& terms, const BlockDamping& damping,
              const std::vector<SupportElement>& supports, const ContactSet& contacts, const std::vector<Vec4>& active,
              BlockMatrix& matrix) {
  matrix.set_zero();
  add_blocks(step, terms, matrix);
  for (const auto& [block, c] : damping) matrix.diagonal(block) += step.damping * c;
  for (const SupportElement& support : supports)
    matrix.diagonal(support.block) += step.stiffness * support_stiffness(support.rows, support.stiffness);
  for (std::size_t i = 0; i < contacts.elements.size(); ++i)
    add_contact(step.stiffness, contacts.elements[i], active[i], true, true, matrix);
}

double stiffness_number(const ContactSet& contacts, const BlockTerms& terms, double dt) {
  double largest = 0;
  for (const InterfaceElement& element : contacts.elements) {
    const double mass = least_mass(terms, element.block_a, element.block_b);
    const double normal_stiffness =
        element.law == InterfaceLaw::classical ? element.stiffness(0) + element.stiffness(2) : element.stiffness(0);
    largest = std::max(largest, normal_stiffness * dt * dt / mass);
  }
  return largest;
}

}  // namespace dda
