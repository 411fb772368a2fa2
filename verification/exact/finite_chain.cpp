#include "verification/exact/finite_chain.h"

#include <Eigen/QR>
#include <cstddef>
#include <stdexcept>

#include "verification/exact/chain_modes.h"
#include "verification/exact/z_transform.h"

namespace exact {
namespace {

// At most three waves from each end; three equations of each end block.
using EndMatrix = Eigen::Matrix<Complex, 6, Eigen::Dynamic, 0, 6, 6>;
using EndVector = Eigen::Matrix<Complex, Eigen::Dynamic, 1, 0, 6, 1>;

Complex power(Complex base, int exponent) {
  Complex result = 1;
  for (; exponent > 0; exponent /= 2, base *= base) {
    if (exponent % 2 == 1) result *= base;
  }
  return result;
}

// A vector of a block's equations or unknowns (u, ex, ey) seen in a mirror.
ComplexVector3 mirrored(const ComplexVector3& vector) { return {-vector[0], vector[1], vector[2]}; }

// The field at one z. Blocks are 1..n and interfaces 0..n, of which 0 and n do not exist: the homogeneous chain runs on
// over ghost blocks 0 and n+1, and what a missing interface adds to the equations of its end block must be the load or
// the support of that end, less what the half block there has of its own. Of those three equations as many are
// independent as there are waves.
class ChainField {
 public:
  ChainField(const ScaledChain& chain, int blocks, Complex inertia, const ChainEnd& left, const ChainEnd& right,
             Complex end_reaction)
      : chain_(chain), blocks_(blocks), modes_(chain_modes(chain, inertia)) {
    const auto waves = static_cast<Eigen::Index>(modes_.size());
    EndMatrix ends(6, 2 * waves);
    for (Eigen::Index i = 0; i < waves; ++i) {
      const ChainMode& mode = modes_[static_cast<std::size_t>(i)];
      const Complex far = power(mode.lambda, blocks_), half = 0.5L;
      const Complex ex_near = mode.lambda * mode.ex, ex_far = far * mode.ex;
      ends.col(i) << mode.on_right - left.missing(ex_near),
          far * mode.on_left - right.missing(ex_far) - end_reaction * far * (mode.u + half * mode.ex) * right.push(1);
      ends.col(waves + i) << far * mirrored(mode.on_left) - left.missing(ex_far),
          mirrored(mode.on_right) - right.missing(ex_near) -
              end_reaction * mode.lambda * (half * mode.ex - mode.u) * right.push(1);
    }
    EndVector unit = EndVector::Zero(6);
    unit.head<3>() = -left.push(-1);  // a unit compressive force on the left face
    amplitudes_ = ends.colPivHouseholderQr().solve(unit);
  }

  [[nodiscard]] Complex displacement(int block) const {
    return sum(
        block, blocks_ + 1 - block, [](const ChainMode& mode) { return mode.u; }, -1);
  }
  [[nodiscard]] Complex stress(int block) const {
    return sum(
        block, blocks_ + 1 - block, [&](const ChainMode& mode) { return mode.ex + chain_.e12 * mode.ey; }, 1);
  }
  [[nodiscard]] Complex force(int interface) const {
    return sum(
        interface, blocks_ - interface, [](const ChainMode& mode) { return mode.force; }, 1);
  }

 private:
  template <typename Amplitude>
  [[nodiscard]] Complex sum(int from_left, int from_right, const Amplitude& amplitude, Real mirror_sign) const {
    Complex total = 0;
    for (std::size_t i = 0; i < modes_.size(); ++i) {
      const ChainMode& mode = modes_[i];
      const Complex forward = amplitudes_[static_cast<Eigen::Index>(i)] * power(mode.lambda, from_left);
      const Complex mirrored =
          amplitudes_[static_cast<Eigen::Index>(i + modes_.size())] * power(mode.lambda, from_right);
      total += amplitude(mode) * (forward + mirror_sign * mirrored);
    }
    return total;
  }

  const ScaledChain& chain_;
  int blocks_;
  std::vector<ChainMode> modes_;
  EndVector amplitudes_;
};

// In units of the chain for a unit force; `unit_response` turns it into SI.
Complex probe_value(const ChainField& field, const ChainProbe& probe) {
  switch (probe.quantity) {
    case ChainQuantity::block_stress: return field.stress(probe.index + 1);
    case ChainQuantity::interface_force:
    case ChainQuantity::interface_stress: return field.force(probe.index + 1);
    case ChainQuantity::displacement: break;
  }
  return field.displacement(probe.index + 1);
}

Real unit_response(const BlockChain& chain, const ChainProbe& probe) {
  if (probe.quantity == ChainQuantity::block_stress) return 1 / widen(chain.length);
  if (probe.quantity == ChainQuantity::interface_force) return 1;
  if (probe.quantity == ChainQuantity::interface_stress) return 1 / widen(chain.height);
  return 1 / widen(chain.elasticity.e11);
}

}  // namespace

ChainHistories finite_chain_response(const BlockChain& chain, const TimeScheme& scheme, double dt,
                                     const std::vector<double>& load, const std::vector<ChainProbe>& probes) {
  check(chain, probes);
  if (load.empty()) throw std::invalid_argument("the load has no samples");
  const ScaledChain scaled(chain);
  const ZCircle circle(load.size());
  const std::vector<Complex> load_transform = circle.forward(load);
  const Real first_load = widen(load.front()), e11 = widen(chain.elasticity.e11);
  std::vector<std::vector<Complex>> transforms(probes.size(), std::vector<Complex>(circle.points()));
  for (std::size_t i = 0; i < circle.points(); ++i) {
    const SchemeOperators op = scheme_operators(scheme, dt, circle.point(i));
    const Complex reaction = (widen(chain.end_stiffness) + op.damping * widen(chain.end_impedance)) / e11;
    const ChainEnd left(chain, scaled, Face::left, op.inertia), right(chain, scaled, Face::right, op.inertia);
    const ChainField field(scaled, chain.blocks, op.inertia, left, right, reaction);
    const Complex force = load_transform[i] + op.initial_load * first_load;
    for (std::size_t p = 0; p < probes.size(); ++p) {
      transforms[p][i] = force * unit_response(chain, probes[p]) * probe_value(field, probes[p]);
    }
  }
  ChainHistories histories;
  for (const auto& transform : transforms) histories.push_back(circle.inverse(transform));
  return histories;
}

}  // namespace exact
