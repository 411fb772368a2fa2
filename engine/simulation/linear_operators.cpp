#include "engine/simulation/linear_operators.h"

#include <cstddef>
#include <numeric>

#include "engine/simulation/system_matrix.h"

namespace dda {
namespace {

// The coefficients that leave one matrix of the sum mass M + damping C + stiffness K.
StepCoefficients only_stiffness() {
  StepCoefficients step;
  step.stiffness = 1;
  return step;
}

void add_scaled(double factor, const ConstantOperator& matrix, BlockMatrix& sum) {
  matrix.for_each_block([&](int row, int column, const auto& block) {
    if (row == column) {
      sum.diagonal(row) += factor * block;
    } else {
      sum.add_coupling(row, column, factor * block);
    }
  });
}

BlockMatrix make_stiffness(const Model& model, const BlockTerms& terms, const ContactSet& contacts,
                           const std::vector<SupportElement>& supports, const LiningSet& linings,
                           const WaveCorrections& waves) {
  BlockMatrix stiffness = make_system_matrix(static_cast<int>(terms.inertia.size()), contacts, linings.pairs());
  std::vector<int> all(contacts.elements.size());
  std::iota(all.begin(), all.end(), 0);
  assemble_base_matrix(only_stiffness(), terms, {}, supports, contacts, all, stiffness);
  linings.add_stiffness(1, stiffness);
  waves.add_to_stiffness(model, contacts, stiffness);
  return stiffness;
}

}  // namespace

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
      inertia(make_inertia(model, terms, contacts, waves)) {}

void assemble(const StepCoefficients& step, const LinearOperators& operators, const BlockDamping& damping,
              BlockMatrix& matrix) {
  matrix.set_zero();
  add_scaled(step.mass, operators.inertia, matrix);
  add_scaled(step.stiffness, operators.stiffness, matrix);
  for (const auto& [block, c] : damping) matrix.diagonal(block) += step.damping * c;
}

}  // namespace dda
