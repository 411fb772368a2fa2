#include "engine/simulation/linear_operators.h"

#include <cstddef>

#include "engine/simulation/system_matrix.h"

namespace dda {
namespace {

// The coefficients that leave one matrix of the sum mass M + damping C + stiffness K.
StepCoefficients only_stiffness() {
  StepCoefficients step;
  step.stiffness = 1;
  return step;
}

void add_scaled(double factor, const BlockMatrix& matrix, BlockMatrix& sum) {
  for (int column = 0; column < matrix.size(); ++column) {
    sum.diagonal(column) += factor * matrix.diagonal(column);
    const auto first = static_cast<std::size_t>(matrix.column_starts()[static_cast<std::size_t>(column)]);
    const auto last = static_cast<std::size_t>(matrix.column_starts()[static_cast<std::size_t>(column) + 1]);
    for (std::size_t k = first + 1; k < last; ++k)
      sum.add_coupling(matrix.block_rows()[k], column, factor * matrix.offdiagonal(static_cast<int>(k)));
  }
}

BlockMatrix make_stiffness(const Model& model, const BlockTerms& terms, const ContactSet& contacts,
                           const std::vector<SupportElement>& supports, const LiningSet& linings,
                           const WaveCorrections& waves) {
  BlockMatrix stiffness = make_system_matrix(static_cast<int>(terms.inertia.size()), contacts, linings.pairs());
  const std::vector<Vec4> all_rows(contacts.elements.size(), Vec4::Ones());
  assemble(only_stiffness(), terms, {}, supports, contacts, all_rows, stiffness);
  linings.add_stiffness(1, stiffness);
  waves.add_to_stiffness(model, contacts, stiffness);
  return stiffness;
}

}  // namespace

void scale(double factor, BlockMatrix& matrix) {
  if (factor == 1) return;
  const BlockMatrix before = matrix;
  matrix.set_zero();
  add_scaled(factor, before, matrix);
}

BlockMatrix make_inertia(const Model& model, const BlockTerms& terms, const ContactSet& contacts,
                         const WaveCorrections& waves) {
  BlockMatrix inertia(static_cast<int>(terms.inertia.size()), waves.coupled_by_inertia(contacts));
  for (std::size_t i = 0; i < terms.inertia.size(); ++i)
    inertia.diagonal(static_cast<int>(i)) = mass_matrix(terms.inertia[i]);
  waves.add_to_inertia(model, contacts, inertia);
  return inertia;
}

LinearOperators::LinearOperators(const Model& model, const BlockTerms& terms, const ContactSet& contacts,
                                 const std::vector<SupportElement>& supports, const WaveCorrections& waves,
                                 const LiningSet& linings)
    : stiffness(make_stiffness(model, terms, contacts, supports, linings, waves)),
      inertia(make_inertia(model, terms, contacts, waves)),
      stiffness_times(stiffness),
      inertia_times(inertia) {}

void assemble(const StepCoefficients& step, const LinearOperators& operators, const BlockDamping& damping,
              BlockMatrix& matrix) {
  matrix.set_zero();
  add_scaled(step.mass, operators.inertia, matrix);
  add_scaled(step.stiffness, operators.stiffness, matrix);
  for (const auto& [block, c] : damping) matrix.diagonal(block) += step.damping * c;
}

}  // namespace dda
