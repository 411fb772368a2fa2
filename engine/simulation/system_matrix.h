// The matrix of one step: mass M + damping C + stiffness K with the coefficients of the integrator.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "engine/contact/contact_set.h"
#include "engine/linear/block_matrix.h"
#include "engine/linear/solver_choice.h"
#include "engine/simulation/block_terms.h"
#include "engine/simulation/step_coefficients.h"
#include "engine/simulation/support_set.h"

namespace dda {

// Pattern: blocks that share an interface, or that may come to touch, are coupled, and those of `others`.
BlockMatrix make_system_matrix(int blocks, const ContactSet& contacts, std::vector<std::pair<int, int>> others = {});

// Writes all values. `active` has 1 for the rows of each interface that carry stiffness (see InterfaceTrial).
void assemble(const StepCoefficients& step, const BlockTerms& terms, const BlockDamping& damping,
              const std::vector<SupportElement>& supports, const ContactSet& contacts, const std::vector<Vec4>& active,
              BlockMatrix& matrix);

// The same with the interfaces of `bonded` alone, all of their rows.
void assemble_base_matrix(const StepCoefficients& step, const BlockTerms& terms, const BlockDamping& damping,
                          const std::vector<SupportElement>& supports, const ContactSet& contacts,
                          std::span<const int> bonded, BlockMatrix& matrix);

// chi = k dt^2/m, which decides on the solver. Supports do not count: PCG inverts the blocks they act on.
StiffnessNumbers stiffness_numbers(const ContactSet& contacts, const BlockTerms& terms, double dt);

}  // namespace dda
