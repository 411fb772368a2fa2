#include "verification/exact/dense_chain.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace exact {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd zero_row(const BlockChain& chain) { return VectorXd::Zero(3 * static_cast<Eigen::Index>(chain.blocks)); }

// Rows below are linear forms of the unknowns: their product with the vector of unknowns is the quantity.
VectorXd stress_row(const BlockChain& chain, int block) {
  VectorXd row = zero_row(chain);
  row[3 * block + 1] = chain.elasticity.e11;
  row[3 * block + 2] = chain.elasticity.e12;
  return row;
}

// The stress that is left of sigma_x when the block contracts sideways until sigma_y vanishes: Q ex.
VectorXd side_free_stress_row(const BlockChain& chain, int block) {
  VectorXd lateral_stress = zero_row(chain);
  lateral_stress[3 * block + 1] = chain.elasticity.e12;
  lateral_stress[3 * block + 2] = chain.elasticity.e11;
  return stress_row(chain, block) - chain.elasticity.e12 / chain.elasticity.e11 * lateral_stress;
}

VectorXd face_row(const BlockChain& chain, int block, double side) {
  VectorXd row = zero_row(chain);
  row[3 * block] = 1;
  row[3 * block + 1] = side * chain.length / 2;
  return row;
}

VectorXd gap_row(const BlockChain& chain, int left) { return face_row(chain, left + 1, -1) - face_row(chain, left, 1); }

VectorXd mean_stress_row(const BlockChain& chain, int left) {
  return (stress_row(chain, left) + stress_row(chain, left + 1)) / 2;
}

VectorXd tangential_row(const BlockChain& chain, int left) {
  const Eigen::Index unknowns = 3 * chain.blocks;
  return chain.height / 2 * (VectorXd::Unit(unknowns, 3 * left + 5) - VectorXd::Unit(unknowns, 3 * left + 2));
}

// Displacement and slope of the cubic between two blocks at x = s L/2 from their interface, s in [-1, 1].
using PairRow = Eigen::Matrix<double, 6, 1>;
struct CubicRows {
  PairRow value = PairRow::Zero(), slope = PairRow::Zero();
};
CubicRows cubic_rows(const BlockChain& chain, double s) {
  const double half = chain.length / 2;
  CubicRows rows;
  rows.value[0] = (1 - s) * (1 - s) * (2 + s) / 4;
  rows.value[3] = (1 + s) * (1 + s) * (2 - s) / 4;
  rows.value[1] = half * (1 - s) * (1 - s) * (1 + s) / 4;
  rows.value[4] = -half * (1 + s) * (1 + s) * (1 - s) / 4;
  rows.slope[0] = -3 * (1 - s * s) / (4 * half);
  rows.slope[3] = -rows.slope[0];
  rows.slope[1] = (1 - s) * (-1 - 3 * s) / 4;
  rows.slope[4] = (1 + s) * (3 * s - 1) / 4;
  return rows;
}

VectorXd force_row(const BlockChain& chain, int left) {
  if (chain.interface.cubic) {
    const double stiffness = 1.5 * bar_modulus(chain.elasticity) / chain.length;
    const VectorXd blocks = side_free_stress_row(chain, left) + side_free_stress_row(chain, left + 1);
    return chain.height * (blocks / 2 + stiffness * gap_row(chain, left));
  }
  VectorXd row = chain.interface.normal * gap_row(chain, left);
  if (chain.interface.consistent) row += chain.height * mean_stress_row(chain, left);
  return row;
}

void add_block(const BlockChain& chain, int block, DenseSystem& system) {
  const double area = chain.length * chain.height, mass = chain.density * area;
  const double spread = chain.inertia_factor * mass / 12;
  system.mass(3 * block, 3 * block) = mass;
  system.mass(3 * block + 1, 3 * block + 1) = spread * chain.length * chain.length;
  system.mass(3 * block + 2, 3 * block + 2) = chain.lateral_inertia * spread * chain.height * chain.height;
  Eigen::Matrix2d elasticity;
  elasticity << chain.elasticity.e11, chain.elasticity.e12, chain.elasticity.e12, chain.elasticity.e11;
  system.stiffness.block<2, 2>(3 * block + 1, 3 * block + 1) += area * elasticity;
}

// One point of the quadrature over block `block`'s half of the cell of two blocks: the cubic's energies less the
// block's.
void add_cubic_point(const BlockChain& chain, int block, double s, double weight, DenseSystem& system) {
  const double distance = chain.length / 2 * (block == 0 ? 1 + s : s - 1);
  const PairRow strain = PairRow::Unit(3 * block + 1);
  const PairRow straight = PairRow::Unit(3 * block) + distance * strain;
  const CubicRows cubic = cubic_rows(chain, s);
  const PairRow excess = cubic.slope - strain, stress = weight * side_free_stress_row(chain, block);
  system.stiffness += stress * excess.transpose() + excess * stress.transpose() +
                      weight * bar_modulus(chain.elasticity) * excess * excess.transpose();
  system.mass += weight * chain.density * (cubic.value * cubic.value.transpose() - straight * straight.transpose());
}

void add_cubic(const BlockChain& pair, DenseSystem& system) {
  // Gauss' four points on [-1, 1]: exact for the sixth degree of the kinetic energy.
  const double spread = 2.0 / 7 * std::sqrt(6.0 / 5), root = std::sqrt(30.0);
  const double inner = std::sqrt(3.0 / 7 - spread), outer = std::sqrt(3.0 / 7 + spread);
  const std::array<double, 4> points{-outer, -inner, inner, outer};
  for (const double point : points) {
    const double weight = (18 + (std::abs(point) < 0.5 ? root : -root)) / 36 * pair.length / 4 * pair.height;
    add_cubic_point(pair, 0, (point - 1) / 2, weight, system);
    add_cubic_point(pair, 1, (point + 1) / 2, weight, system);
  }
  VectorXd jump = VectorXd::Zero(6);
  jump(1) = -pair.length;
  jump(4) = pair.length;
  system.mass -=
      jump_inertia_reduction(pair.interface) * pair.density * pair.length * pair.height / 12 * jump * jump.transpose();
  const VectorXd difference = face_row(pair, 1, 0) - face_row(pair, 0, 0);
  system.mass -=
      pair.interface.inertia_reduction * pair.density * pair.length * pair.height * difference * difference.transpose();
}

DenseSystem no_system(int blocks) {
  const MatrixXd zero = MatrixXd::Zero(3 * blocks, 3 * blocks);
  return {zero, zero, zero};
}

// What any interface adds to the matrices of its two blocks (6 x 6).
DenseSystem interface_system(BlockChain chain) {
  chain.blocks = 2;
  DenseSystem system = no_system(2);
  const VectorXd gap = gap_row(chain, 0), slip = tangential_row(chain, 0);
  system.stiffness += chain.interface.tangential_half * slip * slip.transpose();
  system.stiffness += chain.interface.normal * gap * gap.transpose();
  if (chain.interface.cubic) add_cubic(chain, system);
  if (chain.interface.consistent) {
    const MatrixXd flux = chain.height * mean_stress_row(chain, 0) * gap.transpose();
    system.stiffness += flux + flux.transpose();
  }
  return system;
}

// The half block at a face that nothing holds.
void add_end(const BlockChain& chain, int block, Face face, DenseSystem& system) {
  const int ex = 3 * block + 1;
  const double half_area = chain.length * chain.height / 2;
  system.stiffness(ex, ex) -= (1 - end_share(chain, face)) * half_area * bar_modulus(chain.elasticity);
  system.mass(ex, ex) -=
      end_inertia_reduction(chain, face) * chain.density * chain.height * std::pow(chain.length, 3) / 12;
}

VectorXd probe_row(const BlockChain& chain, const ChainProbe& probe) {
  switch (probe.quantity) {
    case ChainQuantity::block_stress: return stress_row(chain, probe.index);
    case ChainQuantity::interface_force: return force_row(chain, probe.index);
    case ChainQuantity::interface_stress: return force_row(chain, probe.index) / chain.height;
    case ChainQuantity::displacement: break;
  }
  return face_row(chain, probe.index, 0);
}

}  // namespace

DenseSystem dense_chain_system(const BlockChain& chain) {
  const DenseSystem between = interface_system(chain);
  DenseSystem system = no_system(chain.blocks);
  for (int block = 0; block < chain.blocks; ++block) add_block(chain, block, system);
  for (int left = 0; left + 1 < chain.blocks; ++left) {
    system.mass.block<6, 6>(3 * left, 3 * left) += between.mass;
    system.stiffness.block<6, 6>(3 * left, 3 * left) += between.stiffness;
  }
  add_end(chain, 0, Face::left, system);
  add_end(chain, chain.blocks - 1, Face::right, system);
  const VectorXd end = face_row(chain, chain.blocks - 1, 1);
  system.stiffness += chain.end_stiffness * end * end.transpose();
  system.damping += chain.end_impedance * end * end.transpose();
  return system;
}

ChainHistories dense_chain_response(const BlockChain& chain, const TimeScheme& scheme, double dt,
                                    const std::vector<double>& load, const std::vector<ChainProbe>& probes) {
  check(chain, probes);
  MatrixXd observe(static_cast<Eigen::Index>(probes.size()), 3 * chain.blocks);
  for (std::size_t i = 0; i < probes.size(); ++i) {
    observe.row(static_cast<Eigen::Index>(i)) = probe_row(chain, probes[i]).transpose();
  }
  const VectorXd pattern = face_row(chain, 0, -end_share(chain, Face::left));
  const auto force = [&](int i) -> VectorXd { return load[static_cast<std::size_t>(i)] * pattern; };
  const int steps = static_cast<int>(load.size()) - 1;
  const MatrixXd history = dense_newmark(dense_chain_system(chain), scheme, dt, steps, force, observe);
  ChainHistories result;
  for (Eigen::Index i = 0; i < history.rows(); ++i) {
    const VectorXd row = history.row(i);
    result.emplace_back(row.begin(), row.end());
  }
  return result;
}

}  // namespace exact
