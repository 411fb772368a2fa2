#include "verification/exact/dense_chain.h"

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
  VectorXd row = zero_row(chain);
  row[3 * left + 5] = chain.height / 2;
  row[3 * left + 2] = -chain.height / 2;
  return row;
}

VectorXd force_row(const BlockChain& chain, int left) {
  VectorXd row = chain.interface.normal * gap_row(chain, left);
  if (chain.interface.consistent) row += chain.height * mean_stress_row(chain, left);
  return row;
}

void add_block(const BlockChain& chain, int block, DenseSystem& system) {
  const double area = chain.length * chain.height, mass = chain.density * area;
  const double spread = chain.inertia_factor * mass / 12;
  system.mass(3 * block, 3 * block) = mass;
  system.mass(3 * block + 1, 3 * block + 1) = spread * chain.length * chain.length;
  system.mass(3 * block + 2, 3 * block + 2) = spread * chain.height * chain.height;
  Eigen::Matrix2d elasticity;
  elasticity << chain.elasticity.e11, chain.elasticity.e12, chain.elasticity.e12, chain.elasticity.e11;
  system.stiffness.block<2, 2>(3 * block + 1, 3 * block + 1) += area * elasticity;
}

void add_interface(const BlockChain& chain, int left, MatrixXd& stiffness) {
  const VectorXd gap = gap_row(chain, left), slip = tangential_row(chain, left);
  stiffness += chain.interface.normal * gap * gap.transpose();
  stiffness += chain.interface.tangential_half * slip * slip.transpose();
  if (!chain.interface.consistent) return;
  const MatrixXd flux = chain.height * mean_stress_row(chain, left) * gap.transpose();
  stiffness += flux + flux.transpose();
}

VectorXd probe_row(const BlockChain& chain, const ChainProbe& probe) {
  switch (probe.quantity) {
    case ChainQuantity::block_stress: return stress_row(chain, probe.index);
    case ChainQuantity::interface_force: return force_row(chain, probe.index);
    case ChainQuantity::displacement: break;
  }
  return face_row(chain, probe.index, 0);
}

}  // namespace

DenseSystem dense_chain_system(const BlockChain& chain) {
  const MatrixXd zero = MatrixXd::Zero(3 * chain.blocks, 3 * chain.blocks);
  DenseSystem system{zero, zero, zero};
  for (int block = 0; block < chain.blocks; ++block) add_block(chain, block, system);
  for (int left = 0; left + 1 < chain.blocks; ++left) add_interface(chain, left, system.stiffness);
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
  const VectorXd pattern = face_row(chain, 0, -1);
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
