#include "verification/lattice/bloch.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <complex>
#include <cstddef>

#include "engine/contact/contact_set.h"
#include "engine/contact/make_contacts.h"
#include "engine/model/model.h"
#include "engine/terms/elasticity.h"
#include "engine/terms/inertia.h"
#include "engine/waves/mesh_correction.h"
#include "verification/lattice/periodic_patch.h"

namespace verify {
namespace {

Eigen::Index rows_of(int block, int blocks) { return 6 * static_cast<Eigen::Index>(block % blocks); }

void add_block(int block, const dda::Mat6& part, int blocks, Eigen::MatrixXd& sum) {
  sum.block<6, 6>(rows_of(block, blocks), rows_of(block, blocks)) += part;
}

// What the interface makes of the forces on the block `own` if that is one of the middle cell.
void add_side(int own, int other, const dda::Mat6& to_own, const dda::Mat6& to_other, int blocks, CellMatrices& cell) {
  if (own / blocks != middle_cell) return;
  const auto neighbour = static_cast<std::size_t>(other / blocks);
  add_block(own, to_own, blocks, cell.stiffness[middle_cell]);
  add_block(own, to_own, blocks, cell.interfaces[neighbour]);
  cell.stiffness[neighbour].block<6, 6>(rows_of(own, blocks), rows_of(other, blocks)) += to_other;
}

void add_sides(const dda::InterfaceElement& element, const dda::InterfaceMatrices& part, int blocks,
               CellMatrices& cell) {
  add_side(element.block_a, element.block_b, part.aa, part.ba.transpose(), blocks, cell);
  add_side(element.block_b, element.block_a, part.bb, part.ba, blocks, cell);
}

Eigen::MatrixXcd stiffness(const PeriodicMesh& mesh, const CellMatrices& cell, const dda::Vec2& wave_vector) {
  Eigen::MatrixXcd sum = Eigen::MatrixXcd::Zero(cell.mass.rows(), cell.mass.cols());
  for (std::size_t c = 0; c < cell.stiffness.size(); ++c)
    sum += std::polar(1.0, wave_vector.dot(translation(mesh, static_cast<int>(c)))) * cell.stiffness[c];
  return sum;
}

}  // namespace

CellMatrices cell_matrices(const PeriodicMesh& mesh, const dda::Material& rock, const dda::JointMaterial& bond,
                           bool corrected) {
  const auto blocks = static_cast<int>(mesh.cell.size());
  CellMatrices cell;
  cell.model = periodic_patch(mesh, 1, rock, bond);
  cell.mass.setZero(6 * blocks, 6 * blocks);
  cell.stiffness.fill(cell.mass);
  cell.interfaces.fill(cell.mass);
  for (int block = middle_cell * blocks; block < (middle_cell + 1) * blocks; ++block) {
    const dda::AreaMoments& moments = cell.model.blocks[static_cast<std::size_t>(block)].moments;
    dda::Mat6 own = dda::Mat6::Zero();
    own.bottomRightCorner<3, 3>() = dda::strain_stiffness(moments.area, dda::elasticity_matrix(rock));
    add_block(block, own, blocks, cell.stiffness[middle_cell]);
    const dda::Inertia inertia{cell.model.mass_of(block), dda::mean_squares(moments), 1};
    add_block(block, dda::mass_matrix(inertia), blocks, cell.mass);
  }
  const dda::ContactSet contacts = dda::make_contacts(cell.model);
  for (int block = middle_cell * blocks; block < (middle_cell + 1) * blocks; ++block) {
    if (contacts.outline_compliance.empty()) continue;
    dda::Mat6 taken = dda::Mat6::Zero();
    taken.bottomRightCorner<3, 3>() =
        dda::outline_stiffness(contacts, static_cast<std::size_t>(block), dda::elasticity_matrix(rock));
    add_block(block, -taken, blocks, cell.stiffness[middle_cell]);
  }
  for (std::size_t i = 0; i < contacts.elements.size(); ++i) {
    const dda::InterfaceElement& element = contacts.elements[i];
    add_sides(element, dda::stiffness_of(element, dda::Vec4::Ones()), blocks, cell);
    if (corrected) add_sides(element, dda::jump_stiffness(cell.model, contacts.interfaces[i]), blocks, cell);
  }
  return cell;
}

PhaseSpeeds phase_speeds(const PeriodicMesh& mesh, const dda::Material& rock, const dda::JointMaterial& bond,
                         const dda::Vec2& wave_vector, bool corrected) {
  const CellMatrices cell = cell_matrices(mesh, rock, bond, corrected);
  const Eigen::MatrixXcd mass = cell.mass.cast<std::complex<double>>();
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXcd> waves(stiffness(mesh, cell, wave_vector), mass,
                                                                         Eigen::EigenvaluesOnly);
  const double q = wave_vector.norm();
  return {std::sqrt(waves.eigenvalues()(0)) / q, std::sqrt(waves.eigenvalues()(1)) / q};
}

}  // namespace verify
