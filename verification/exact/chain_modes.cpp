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

using Matrix3 = Eigen::Matrix<Complex, 3, 3>;
using Vector3 = Eigen::Matrix<Complex, 3, 1>;

// With lambda = exp(i kappa) and X = sin^2(kappa/2), a wave has gap g and strains cos(kappa/2) (e, y) half an interface
// away. Eliminating the force N = k g + [consistent] h (1 - X)(e + e12 y) and u from the block's three equations leaves
// (constant + X linear)(g, e, y) = 0: every row is linear in X.
struct Pencil {
  Matrix3 constant = Matrix3::Zero();
  Matrix3 linear = Matrix3::Zero();
};

Pencil wave_pencil(const ScaledChain& c, Complex mass) {
  const Real flux = c.consistent * c.height, lateral = flux * c.e12, one = 1;
  const Complex x_inertia = c.inertia * mass + c.height, coupling = c.height * c.e12;
  const Complex y_inertia = c.inertia * c.height * c.height * mass + c.height;
  const Complex compliance = Real{4} / mass;
  Pencil pencil;
  pencil.constant << one, one, Complex(0),                    //
      flux - c.normal, x_inertia - flux, coupling - lateral,  //
      lateral, coupling, y_inertia;
  pencil.linear << compliance * flux, compliance * x_inertia - one, compliance * coupling,  //
      Complex(0), flux, lateral,                                                            //
      Complex(0), Complex(0), c.tangential * c.height * c.height;
  return pencil;
}

// exp(-i kappa) of the decaying wave; through half angles, and as an inverse, so that nothing cancels.
Complex decaying_factor(Complex sin2) {
  const Complex sine = std::sqrt(sin2), cosine = std::sqrt(Real{1} - sin2), turn(-sine.imag(), sine.real());
  const Complex growing = std::abs(cosine + turn) >= 1 ? cosine + turn : cosine - turn;
  return Real{1} / (growing * growing);
}

ChainMode mode_of(const ScaledChain& c, Complex sin2, const Vector3& shape) {
  ChainMode mode;
  const Real one = 1, half = 0.5L;
  mode.sin2 = sin2;
  const Complex lambda = mode.lambda = decaying_factor(sin2);
  // Scaled by lambda (lambda^(1/2) - lambda^(-1/2)): no half powers, and finite as lambda goes to 0.
  const Complex strain = half * (lambda * lambda - one);
  mode.u = lambda * (shape[0] + (one - sin2) * shape[1]);
  mode.ex = strain * shape[1];
  mode.ey = strain * shape[2];
  mode.gap = (lambda - one) * mode.u - half * (lambda + one) * mode.ex;
  mode.force = c.normal * mode.gap + c.consistent * c.height * half * (lambda + one) * (mode.ex + c.e12 * mode.ey);
  mode.slip = (lambda - one) * mode.ey;
  return mode;
}

void normalise(ChainMode& mode) {
  const Real scale = 1 / (std::abs(mode.gap) + std::abs(mode.force) + std::abs(mode.slip));
  for (Complex* value : {&mode.u, &mode.ex, &mode.ey, &mode.gap, &mode.force, &mode.slip}) *value *= scale;
}

}  // namespace

ScaledChain::ScaledChain(const BlockChain& chain)
    : height(widen(chain.height) / widen(chain.length)),
      e12(widen(chain.elasticity.e12) / widen(chain.elasticity.e11)),
      normal(widen(chain.interface.normal) / widen(chain.elasticity.e11)),
      tangential(widen(chain.interface.tangential_half) / widen(chain.elasticity.e11)),
      consistent(chain.interface.consistent ? 1 : 0),
      inertia(widen(chain.inertia_factor) / 12),
      mass_over_stiffness(widen(chain.density) * widen(chain.height * chain.length) / widen(chain.elasticity.e11)),
      waves(1 + (chain.interface.consistent ? 1 : 0) + (chain.interface.tangential_half > 0 ? 1 : 0)) {}

// The eigenvalues of -constant^-1 linear are 1/X; those of the waves that do not exist are 0 and come last.
std::vector<ChainMode> chain_modes(const ScaledChain& chain, Complex inertia_operator) {
  const Pencil pencil = wave_pencil(chain, chain.mass_over_stiffness * inertia_operator);
  const Eigen::ComplexEigenSolver<Matrix3> solver(-pencil.constant.partialPivLu().solve(pencil.linear));
  std::array<Eigen::Index, 3> order{0, 1, 2};
  std::ranges::sort(order, [&](Eigen::Index i, Eigen::Index j) {
    return std::abs(solver.eigenvalues()[i]) > std::abs(solver.eigenvalues()[j]);
  });
  std::vector<ChainMode> modes;
  for (std::size_t i = 0; i < static_cast<std::size_t>(chain.waves); ++i) {
    modes.push_back(mode_of(chain, Real{1} / solver.eigenvalues()[order[i]], solver.eigenvectors().col(order[i])));
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
