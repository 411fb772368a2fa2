#include "verification/exact/interface_forms.h"

namespace exact {
namespace {

struct ScaledData {
  Real height, e12, normal, tangential, reduction, jump_reduction;
};

ScaledData scaled_data(const BlockChain& chain) {
  const Real e11 = widen(chain.elasticity.e11);
  return {widen(chain.height) / widen(chain.length), widen(chain.elasticity.e12) / e11,
          widen(chain.interface.normal) / e11,       widen(chain.interface.tangential_half) / e11,
          widen(chain.interface.inertia_reduction),  widen(jump_inertia_reduction(chain.interface))};
}

// h {stress} g, the stress of a block being `axial` ex + `lateral` ey.
void add_flux(Real height, Real axial, Real lateral, InterfaceForms& forms) {
  const RealVector3 mean_stress(0, height * axial / 2, height * lateral / 2);
  forms.opening_stiffness.col(0) += mean_stress;
  forms.opening_stiffness.row(0) += mean_stress.transpose();
  forms.force += mean_stress;
}

// With s = x/H in [-1, 1], H = 1/2, S = ex_0 + ex_1, D = ex_1 - ex_0, B = u_0 + u_1, the cubic is
//   opening: w' = S/2 + 3 g/(4 H) (1 - s^2), against the blocks' S/2
//   bending: w' = D s/2, against -D/2 on the left and D/2 on the right
// and the integrals over the cell are polynomials in s:
//   opening: strain h Q (S g/2 + 3 g^2/(5 H)/2), kinetic -9/70 H g'^2 - H^2/20 g' S'
//   bending: strain h Q (-D^2 H/4 + D^2 H/12), kinetic H^2/12 B' D' - H^3/20 D'^2
void add_cubic(const ScaledData& data, InterfaceForms& forms) {
  const Real half = 0.5L, modulus = 1 - data.e12 * data.e12;
  add_flux(data.height, modulus, 0, forms);
  forms.opening_stiffness(0, 0) += data.height * modulus * 3 / (5 * half);
  forms.force[0] += data.height * modulus * 3 / 2;
  forms.opening_inertia(0, 0) -= half * 9 / 35;
  forms.opening_inertia(0, 1) -= half * half / 20;
  forms.bending_stiffness(1, 1) -= data.height * modulus * half / 3;
  forms.bending_inertia(0, 1) += half * half / 12;
  forms.bending_inertia(1, 1) -= half * half * half / 10;
  // u_1 - u_0 = g + S/2
  const RealVector3 difference(1, half, 0);
  forms.opening_inertia -= data.reduction * difference * difference.transpose();
  forms.bending_inertia(1, 1) -= data.jump_reduction / 12;
  forms.opening_inertia(1, 0) = forms.opening_inertia(0, 1);
  forms.bending_inertia(1, 0) = forms.bending_inertia(0, 1);
}

}  // namespace

InterfaceForms interface_forms(const BlockChain& chain) {
  const ScaledData data = scaled_data(chain);
  InterfaceForms forms;
  forms.opening_stiffness(0, 0) = data.normal;
  if (chain.interface.cubic) {
    add_cubic(data, forms);
  } else {
    forms.force[0] = data.normal;
  }
  if (chain.interface.consistent) add_flux(data.height, 1, data.e12, forms);
  forms.bending_stiffness(2, 2) += data.tangential * data.height * data.height / 4;
  // The cubic and the flux couple ex of neighbours, tangential springs ey.
  forms.waves = 1 + (chain.interface.cubic || chain.interface.consistent ? 1 : 0) + (data.tangential > 0 ? 1 : 0);
  return forms;
}

}  // namespace exact
