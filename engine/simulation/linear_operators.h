// A scene in which nothing can change - all joints bonded, geometry as drawn - is linear: its stiffness and inertia are
// two constant matrices over all unknowns. A step then needs one product with each and one solve, and visits neither
// interfaces nor strengths.
#pragma once

#include <vector>

#include "engine/contact/contact_set.h"
#include "engine/linear/block_matrix.h"
#include "engine/linear/constant_operator.h"
#include "engine/model/model.h"
#include "engine/simulation/block_terms.h"
#include "engine/simulation/lining_set.h"
#include "engine/simulation/step_coefficients.h"
#include "engine/simulation/support_set.h"
#include "engine/waves/wave_corrections.h"

namespace dda {

struct LinearOperators {
  LinearOperators(const Model& model, const BlockTerms& terms, const ContactSet& contacts,
                  const std::vector<SupportElement>& supports, const WaveCorrections& waves,
                  const LiningSet& linings = {});

  ConstantOperator stiffness;  // blocks, interfaces, supports and linings
  ConstantOperator inertia;    // blocks, and what couples them
};

// The inertia among them.
BlockMatrix make_inertia(const Model& model, const BlockTerms& terms, const ContactSet& contacts,
                         const WaveCorrections& waves);

// The step's matrix out of the operators.
void assemble(const StepCoefficients& step, const LinearOperators& operators, const BlockDamping& damping,
              BlockMatrix& matrix);

}  // namespace dda
