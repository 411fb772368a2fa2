#include "verification/exact/half_chain.h"

#include <Eigen/QR>
#include <cmath>
#include <cstddef>
#include <vector>

#include "verification/exact/chain_modes.h"

namespace exact {
namespace {

using EndMatrix = Eigen::Matrix<Complex, 3, Eigen::Dynamic, 0, 3, 3>;
using Amplitudes = Eigen::Matrix<Complex, Eigen::Dynamic, 1, 0, 3, 1>;

// z of a wave that grows as exp(growth omega t). A scheme without damping leaves |lambda| = 1, to round-off, for the
// wave that runs away from the end and for the one that runs towards it. Where the motion grows in time, what comes
// from the end is smaller the farther away it is, so that the right one decays. A travel time of 100 periods is off by
// 1e-9.
Complex slowly_growing(double phase) {
  constexpr Real growth = 1e-12L;  // |lambda| is 1 - 6e-14 in blocks of a hundredth of a wavelength; Real has 19 digits
  return std::polar(std::exp(growth * widen(phase)), widen(phase));
}

}  // namespace

// As in a finite chain the homogeneous chain runs on over a ghost block, and what the interface with it adds to the
// equations of the end block must be the load less what the half block there has of its own; of these three equations
// as many are independent as there are waves.
Complex half_chain_force(const BlockChain& chain, const TimeScheme& scheme, double dt, double omega, int interface) {
  check(chain, {});
  const Complex z = slowly_growing(omega * dt);
  const ScaledChain scaled(chain);
  const Complex inertia = scheme_operators(scheme, dt, z).inertia;
  const std::vector<ChainMode> modes = chain_modes(scaled, inertia);
  const ChainEnd face(chain, scaled, Face::left, inertia);
  EndMatrix end(3, static_cast<Eigen::Index>(modes.size()));
  for (std::size_t i = 0; i < modes.size(); ++i)
    end.col(static_cast<Eigen::Index>(i)) = modes[i].on_right - face.missing(modes[i].lambda * modes[i].ex);
  const Amplitudes amplitudes = end.colPivHouseholderQr().solve(-face.push(-1));
  Complex force = 0;
  for (std::size_t i = 0; i < modes.size(); ++i)
    force += amplitudes[static_cast<Eigen::Index>(i)] * modes[i].force * std::pow(modes[i].lambda, interface);
  return -force;  // waves count tension as positive
}

}  // namespace exact
