#include "verification/cases/bloch.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <random>

#include "dda/contact/contact_set.h"
#include "dda/model/model.h"
#include "dda/terms/elasticity.h"
#include "dda/terms/inertia.h"

namespace verify {
namespace {

using Complex = std::complex<double>;

dda::Ring moved(dda::Ring ring, const dda::Vec2& shift) {
  for (dda::Vec2& vertex : ring) vertex += shift;
  return ring;
}

// The cell with its eight neighbours, cell by cell; the middle one is number 4.
constexpr int middle = 4;

dda::Vec2 translation(const PeriodicMesh& mesh, int cell) {
  return (cell / 3 - 1) * mesh.first + (cell % 3 - 1) * mesh.second;
}

dda::Model patch(const PeriodicMesh& mesh, const dda::Material& rock, const dda::JointMaterial& bond) {
  dda::Model model;
  model.materials = {rock};
  model.joints = {bond};
  for (int cell = 0; cell < 9; ++cell)
    for (const dda::Ring& ring : mesh.cell)
      model.blocks.emplace_back().shape.outer = moved(ring, translation(mesh, cell));
  dda::Stage stage;
  stage.dt = stage.duration = 1;
  stage.kinematics = dda::Kinematics::small;
  model.stages = {stage};
  dda::finish_model(model);
  return model;
}

// Hermitian K(q): what a wave exp(i q.x) makes of the forces on the middle cell.
class CellStiffness {
 public:
  CellStiffness(const PeriodicMesh& mesh, const dda::Vec2& wave_vector)
      : mesh_(mesh), wave_vector_(wave_vector), blocks_(static_cast<int>(mesh.cell.size())) {
    matrix_.setZero(6 * blocks_, 6 * blocks_);
  }

  void add(int row, int column, const dda::Mat6& part) {
    if (row / blocks_ != middle) return;
    const double phase = wave_vector_.dot(translation(mesh_, column / blocks_));
    matrix_.block<6, 6>(6 * (row % blocks_), 6 * (column % blocks_)) += std::polar(1.0, phase) * part;
  }

  [[nodiscard]] const Eigen::MatrixXcd& matrix() const { return matrix_; }

 private:
  const PeriodicMesh& mesh_;
  dda::Vec2 wave_vector_;
  int blocks_;
  Eigen::MatrixXcd matrix_;
};

Eigen::MatrixXcd stiffness(const PeriodicMesh& mesh, const dda::Model& model, const dda::Vec2& wave_vector) {
  CellStiffness sum(mesh, wave_vector);
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    dda::Mat6 own = dda::Mat6::Zero();
    own.bottomRightCorner<3, 3>() =
        dda::strain_stiffness(model.blocks[i].moments.area, dda::elasticity_matrix(model.materials[0]));
    sum.add(static_cast<int>(i), static_cast<int>(i), own);
  }
  for (const dda::InterfaceElement& element : dda::make_contacts(model).elements) {
    const dda::InterfaceStiffness part = dda::stiffness_of(element, dda::Vec4::Ones());
    sum.add(element.block_a, element.block_a, part.aa);
    sum.add(element.block_b, element.block_b, part.bb);
    sum.add(element.block_b, element.block_a, part.ba);
    sum.add(element.block_a, element.block_b, part.ba.transpose());
  }
  return sum.matrix();
}

Eigen::MatrixXcd mass(const PeriodicMesh& mesh, const dda::Model& model, double strain_inertia) {
  const auto blocks = static_cast<Eigen::Index>(mesh.cell.size());
  Eigen::MatrixXcd matrix = Eigen::MatrixXcd::Zero(6 * blocks, 6 * blocks);
  for (Eigen::Index i = 0; i < blocks; ++i) {
    const auto block = static_cast<std::size_t>(middle * blocks + i);
    const dda::Inertia inertia{model.mass_of(static_cast<int>(block)), dda::mean_squares(model.blocks[block].moments),
                               strain_inertia};
    matrix.block<6, 6>(6 * i, 6 * i) = dda::mass_matrix(inertia).cast<Complex>();
  }
  return matrix;
}

}  // namespace

double PeriodicMesh::longest_side() const {
  double longest = 0;
  for (const dda::Ring& ring : cell)
    for (std::size_t i = 0; i < ring.size(); ++i)
      longest = std::max(longest, (ring[(i + 1) % ring.size()] - ring[i]).norm());
  return longest;
}

PeriodicMesh square_mesh() { return {{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}, {1, 0}, {0, 1}}; }

PeriodicMesh brick_mesh() {
  return {{{{0, 0}, {1, 0}, {1, 0.5}, {0, 0.5}}, {{0.5, 0.5}, {1.5, 0.5}, {1.5, 1}, {0.5, 1}}}, {1, 0}, {0, 1}};
}

PeriodicMesh sheared_mesh() {
  const dda::Vec2 up(std::sin(std::numbers::pi / 6), std::cos(std::numbers::pi / 6));
  return {{{{0, 0}, {1, 0}, dda::Vec2(1, 0) + up, up}}, {1, 0}, up};
}

PeriodicMesh triangle_mesh() { return {{{{0, 0}, {1, 0}, {1, 1}}, {{0, 0}, {1, 1}, {0, 1}}}, {1, 0}, {0, 1}}; }

PeriodicMesh irregular_mesh(unsigned seed) {
  constexpr int side = 4;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-0.2, 0.2);
  std::vector<dda::Vec2> shifts;
  for (int i = 0; i < side * side; ++i) {
    const double x = shift(random);
    shifts.emplace_back(x, shift(random));
  }
  const auto corner = [&](int i, int j) -> dda::Vec2 {
    const int index = (i % side) * side + j % side;
    return dda::Vec2(i, j) + shifts[static_cast<std::size_t>(index)];
  };
  PeriodicMesh mesh{{}, {side, 0}, {0, side}};
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j)
      mesh.cell.push_back({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)});
  return mesh;
}

PhaseSpeeds phase_speeds(const PeriodicMesh& mesh, const dda::Material& rock, const dda::JointMaterial& bond,
                         const dda::Vec2& wave_vector, double strain_inertia) {
  const dda::Model model = patch(mesh, rock, bond);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXcd> waves(
      stiffness(mesh, model, wave_vector), mass(mesh, model, strain_inertia), Eigen::EigenvaluesOnly);
  const double q = wave_vector.norm();
  return {std::sqrt(waves.eigenvalues()(0)) / q, std::sqrt(waves.eigenvalues()(1)) / q};
}

}  // namespace verify
