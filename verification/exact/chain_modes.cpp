#include "verification/exact/chain_modes.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace exact {
namespace {

using ComplexMatrix3 = Eigen::Matrix<Complex, 3, 3>;

// Stiffness and inertia at one s^2.
struct DynamicForms {
  ComplexMatrix3 block, opening, bending;
};

DynamicForms dynamic_forms(const ScaledChain& c, Complex mass) {
  const InterfaceForms& forms = c.forms;
  DynamicForms dynamic;
  dynamic.block = (mass * c.inertia.cast<Complex>()).asDiagonal();
  dynamic.block(1, 1) += c.height;
  dynamic.block(2, 2) += c.height;
  dynamic.block(1, 2) += c.height * c.e12;
  dynamic.block(2, 1) += c.height * c.e12;
  dynamic.opening = forms.opening_stiffness.cast<Complex>() + mass * forms.opening_inertia.cast<Complex>();
  dynamic.bending = forms.bending_stiffness.cast<Complex>() + mass * forms.bending_inertia.cast<Complex>();
  return dynamic;
}

// What the opening part adds to the equations of the block to the right: the gap is u_1 - u_0 - (ex_0 + ex_1)/2.
template <typename Columns>
Columns opening_load(Columns load) {
  load.row(1) -= Real{0.5L} * load.row(0);
  return load;
}

// With lambda = exp(i kappa), s = sin(kappa/2), c = cos(kappa/2) a wave's block has u = c U, (ex, ey) = i s E. Then the
// opening part of an interface is 2 i s c (G, E) with G = U - Ex/2, the bending part (2 c^2 U, -2 s^2 E), and after
// division by c and i s the block's three equations are (constant + X linear)(G, E) = 0, linear in X = s^2.
struct Pencil {
  ComplexMatrix3 constant, linear;
};

Pencil wave_pencil(const DynamicForms& forms) {
  const Real half = 0.5L, four = 4;
  const ComplexMatrix3 opening = four * opening_load(forms.opening);
  const ComplexMatrix3 bending = four * forms.bending;
  Eigen::Matrix<Complex, 1, 3> u(1, half, 0);  // U
  Pencil pencil;
  pencil.constant.row(0) = (forms.block(0, 0) + bending(0, 0)) * u;
  pencil.linear.row(0) = opening.row(0) - bending.row(0);
  pencil.linear(0, 0) = opening(0, 0);
  pencil.linear.row(0) -= bending(0, 0) * u;
  pencil.constant.bottomRows<2>() = forms.block.bottomRows<2>() + opening.bottomRows<2>();
  pencil.constant.bottomRows<2>() -= bending.col(0).tail<2>() * u;
  pencil.linear.bottomRows<2>() = -opening.bottomRows<2>();
  pencil.linear.bottomRightCorner<2, 2>() += bending.bottomRightCorner<2, 2>();
  pencil.linear.bottomRows<2>() += bending.col(0).tail<2>() * u;
  return pencil;
}

// Newton's iteration on an eigenpair. The eigensolver's error is relative to the pencil's largest entry, which stiff
// springs make 1e7 times that of the wave; here it is relative to each entry's own.
void refine(const Pencil& pencil, Complex& sin2, ComplexVector3& shape) {
  for (int i = 0; i < 3; ++i) {
    Eigen::Index largest = 0;
    shape.cwiseAbs().maxCoeff(&largest);
    const ComplexMatrix3 residual = pencil.constant + sin2 * pencil.linear;
    const ComplexVector3 next = residual.partialPivLu().solve(pencil.linear * shape);
    const Real size = next.cwiseAbs().maxCoeff();
    if (!std::isfinite(size) || size <= 0) return;  // the residual is singular to the last bit
    sin2 -= shape[largest] / next[largest];
    shape = next / size;
  }
}

// exp(-i kappa) of the decaying wave; through half angles, and as an inverse, so that nothing cancels.
Complex decaying_factor(Complex sin2) {
  const Complex sine = std::sqrt(sin2), cosine = std::sqrt(Real{1} - sin2), turn(-sine.imag(), sine.real());
  const Complex growing = std::abs(cosine + turn) >= 1 ? cosine + turn : cosine - turn;
  return Real{1} / (growing * growing);
}

ChainMode mode_of(const ScaledChain& c, const DynamicForms& forms, Complex sin2, const ComplexVector3& shape) {
  ChainMode mode;
  const Real one = 1, half = 0.5L;
  mode.sin2 = sin2;
  const Complex lambda = mode.lambda = decaying_factor(sin2), plus = lambda + one, minus = lambda - one;
  // Scaled by 2 lambda^(1/2): no half powers, and finite as lambda goes to 0.
  const Complex shape_u = shape[0] + half * shape[1];
  mode.u = plus * shape_u;
  mode.ex = minus * shape[1];
  mode.ey = minus * shape[2];
  const ComplexVector3 opening = plus * minus * shape;
  const ComplexVector3 bending(plus * plus * shape_u, minus * minus * shape[1], minus * minus * shape[2]);
  const ComplexVector3 even = opening_load<ComplexVector3>(forms.opening * opening), odd = forms.bending * bending;
  mode.on_right = even + odd;
  mode.on_left << odd[0] - even[0], even[1] - odd[1], even[2] - odd[2];
  mode.force = c.forms.force.cast<Complex>().dot(opening);
  return mode;
}

void normalise(ChainMode& mode) {
  const Real scale = 1 / (mode.on_left.cwiseAbs().sum() + mode.on_right.cwiseAbs().sum());
  for (Complex* value : {&mode.u, &mode.ex, &mode.ey, &mode.force}) *value *= scale;
  mode.on_left *= scale;
  mode.on_right *= scale;
}

}  // namespace

ScaledChain::ScaledChain(const BlockChain& chain)
    : height(widen(chain.height) / widen(chain.length)),
      e12(widen(chain.elasticity.e12) / widen(chain.elasticity.e11)),
      inertia(1, widen(chain.inertia_factor) / 12,
              widen(chain.inertia_factor) * widen(chain.lateral_inertia) * height * height / 12),
      forms(interface_forms(chain)),
      mass_over_stiffness(widen(chain.density) * widen(chain.height * chain.length) / widen(chain.elasticity.e11)) {}

ChainEnd::ChainEnd(const BlockChain& chain, const ScaledChain& scaled, Face face, Complex inertia_operator)
    : share(widen(end_share(chain, face))) {
  const Real one = 1, half = 0.5L, modulus = one - scaled.e12 * scaled.e12;
  const Complex mass = scaled.mass_over_stiffness * inertia_operator;
  own = -(one - share) * half * scaled.height * modulus - mass * (widen(end_inertia_reduction(chain, face)) / Real{12});
}

// The eigenvalues of -constant^-1 linear are 1/X; those of the waves that do not exist are 0 and come last.
std::vector<ChainMode> chain_modes(const ScaledChain& chain, Complex inertia_operator) {
  const DynamicForms forms = dynamic_forms(chain, chain.mass_over_stiffness * inertia_operator);
  const Pencil pencil = wave_pencil(forms);
  const Eigen::ComplexEigenSolver<ComplexMatrix3> solver(-pencil.constant.partialPivLu().solve(pencil.linear));
  std::array<Eigen::Index, 3> order{0, 1, 2};
  std::ranges::sort(order, [&](Eigen::Index i, Eigen::Index j) {
    return std::abs(solver.eigenvalues()[i]) > std::abs(solver.eigenvalues()[j]);
  });
  std::vector<ChainMode> modes;
  for (std::size_t i = 0; i < static_cast<std::size_t>(chain.forms.waves); ++i) {
    Complex sin2 = Real{1} / solver.eigenvalues()[order[i]];
    ComplexVector3 shape = solver.eigenvectors().col(order[i]);
    refine(pencil, sin2, shape);
    modes.push_back(mode_of(chain, forms, sin2, shape));
    normalise(modes.back());
  }
  return modes;
}

ChainWave chain_wave(Complex sin2, double omega, double length) {
  const Complex kappa = Real{2} * std::asin(std::sqrt(sin2));
  return {static_cast<double>(widen(omega * length) / std::abs(kappa.real())),
          static_cast<double>(std::abs(kappa.imag()) / widen(length))};
}

ChainWave chain_wave(const BlockChain& chain, const TimeScheme& scheme, double dt, double omega) {
  check(chain, {});
  const Complex z = std::polar<Real>(1, widen(omega * dt));
  ChainWave best{0, std::numeric_limits<double>::infinity()};
  for (const ChainMode& mode : chain_modes(ScaledChain(chain), scheme_operators(scheme, dt, z).inertia)) {
    const ChainWave wave = chain_wave(mode.sin2, omega, chain.length);
    if (wave.attenuation < best.attenuation) best = wave;
  }
  return best;
}

}  // namespace exact
