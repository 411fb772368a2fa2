#include "verification/cases/bloch.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <random>
#include <utility>

#include "dda/contact/contact_set.h"
#include "dda/contact/mesh_correction.h"
#include "dda/model/model.h"
#include "dda/terms/elasticity.h"
#include "dda/terms/inertia.h"

namespace verify {
namespace {

dda::Ring moved(dda::Ring ring, const dda::Vec2& shift) {
  for (dda::Vec2& vertex : ring) vertex += shift;
  return ring;
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

void add_sides(const dda::InterfaceElement& element, const dda::InterfaceStiffness& part, int blocks,
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

dda::Vec2 translation(const PeriodicMesh& mesh, int cell) {
  return (cell / 3 - 1) * mesh.first + (cell % 3 - 1) * mesh.second;
}

CellMatrices cell_matrices(const PeriodicMesh& mesh, const dda::Material& rock, const dda::JointMaterial& bond,
                           bool corrected) {
  const auto blocks = static_cast<int>(mesh.cell.size());
  CellMatrices cell;
  cell.model = patch(mesh, rock, bond);
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
  for (std::size_t i = 0; i < contacts.elements.size(); ++i) {
    const dda::InterfaceElement& element = contacts.elements[i];
    add_sides(element, dda::stiffness_of(element, dda::Vec4::Ones()), blocks, cell);
    if (corrected) add_sides(element, dda::jump_stiffness(cell.model, contacts.interfaces[i]), blocks, cell);
  }
  return cell;
}

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

namespace {

constexpr int voronoi_side = 4;  // m, and blocks

// Least distance of two points whose pattern repeats itself.
double periodic_distance(const dda::Vec2& a, const dda::Vec2& b) {
  const auto wrapped = [](double x) { return x - voronoi_side * std::round(x / voronoi_side); };
  return std::hypot(wrapped(a.x() - b.x()), wrapped(a.y() - b.y()));
}

std::vector<dda::Vec2> scattered_points(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(0, voronoi_side);
  std::vector<dda::Vec2> points;
  while (points.size() < voronoi_side * voronoi_side) {
    const double x = place(random);
    const dda::Vec2 point(x, place(random));
    const bool clear = std::ranges::all_of(points, [&](const auto& p) { return periodic_distance(p, point) > 0.55; });
    if (clear) points.push_back(point);
  }
  return points;
}

// What of a convex ring is nearer to `own` than to `other`.
dda::Ring nearer_part(const dda::Ring& ring, const dda::Vec2& own, const dda::Vec2& other) {
  const dda::Vec2 outward = other - own;
  const auto beyond = [&](const dda::Vec2& p) { return outward.dot(p - (own + other) / 2); };
  dda::Ring kept;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const dda::Vec2& from = ring[i];
    const dda::Vec2& to = ring[(i + 1) % ring.size()];
    const double a = beyond(from);
    const double b = beyond(to);
    if (a <= 0) kept.push_back(from);
    if ((a < 0 && b > 0) || (a > 0 && b < 0)) kept.push_back(from + a / (a - b) * (to - from));
  }
  return kept;
}

}  // namespace

PeriodicMesh voronoi_mesh(unsigned seed) {
  const std::vector<dda::Vec2> points = scattered_points(seed);
  PeriodicMesh mesh{{}, {voronoi_side, 0}, {0, voronoi_side}};
  for (const dda::Vec2& own : points) {
    dda::Ring ring;
    for (const auto& [x, y] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
      ring.push_back(own + voronoi_side / 2.0 * dda::Vec2(x, y));
    for (const dda::Vec2& other : points)
      for (int cell = 0; cell < 9; ++cell) {
        const dda::Vec2 image = other + translation(mesh, cell);
        if (image != own) ring = nearer_part(ring, own, image);
      }
    mesh.cell.push_back(ring);
  }
  return mesh;
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
