#include "verification/cases/edge_reflection.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "engine/terms/viscous_boundary.h"

namespace verify {
namespace {

using Complex = std::complex<double>;
using Matrix = Eigen::MatrixXcd;
using Vector = Eigen::VectorXcd;

// A column of cells along the edge and its neighbours, with the phase of the wave along the edge summed up:
// back q(n-1) + own q(n) + ahead q(n+1) = 0 for steady waves exp(i omega t), n growing towards the edge.
struct Column {
  Matrix back, own, ahead;
  Matrix own_at_edge;  // of the last column: without the joints ahead, with the dashpots
};

// Faces of the middle cell that lie on the edge, and their dashpots.
Eigen::MatrixXd edge_damping(const MeshEdge& edge, const dda::Model& model) {
  const auto blocks = static_cast<Eigen::Index>(edge.mesh.cell.size());
  const dda::Vec2 normal =
      dda::Vec2(edge.mesh.second.y(), -edge.mesh.second.x()).normalized() *
      (edge.mesh.first.x() * edge.mesh.second.y() > edge.mesh.first.y() * edge.mesh.second.x() ? 1 : -1);
  double outermost = -1e300;
  for (const dda::Ring& ring : edge.mesh.cell)
    for (const dda::Vec2& vertex : ring) outermost = std::max(outermost, normal.dot(vertex));
  Eigen::MatrixXd damping = Eigen::MatrixXd::Zero(6 * blocks, 6 * blocks);
  const double normal_impedance = edge.across * edge.rock.density * dda::p_wave_speed(edge.rock);
  const double shear_impedance = edge.along * edge.rock.density * dda::s_wave_speed(edge.rock);
  for (Eigen::Index i = 0; i < blocks; ++i) {
    const dda::Ring& ring = edge.mesh.cell[static_cast<std::size_t>(i)];
    const dda::Vec2 centroid = model.blocks[static_cast<std::size_t>(middle_cell * blocks + i)].moments.centroid;
    for (std::size_t j = 0; j < ring.size(); ++j) {
      const dda::Vec2& from = ring[j];
      const dda::Vec2& to = ring[(j + 1) % ring.size()];
      if (std::min(normal.dot(from), normal.dot(to)) < outermost - 1e-9) continue;
      damping.block<6, 6>(6 * i, 6 * i) +=
          dda::viscous_damping(from - centroid, to - centroid, normal_impedance, shear_impedance);
    }
  }
  return damping;
}

// Scaled by Young's modulus, so that entries are of the order of 1.
Column column_of(const MeshEdge& edge, const CellMatrices& cell, double wave_number, double omega) {
  const Eigen::Index size = cell.mass.rows();
  Column column{Matrix::Zero(size, size), Matrix::Zero(size, size), Matrix::Zero(size, size), {}};
  for (std::size_t c = 0; c < 9; ++c) {
    const double way = edge.mesh.second.norm() * (static_cast<int>(c) % 3 - 1);
    Matrix& part = c < 3 ? column.back : c < 6 ? column.own : column.ahead;
    part += std::polar(1 / edge.rock.young, -wave_number * way) * cell.stiffness[c];
  }
  column.own -= omega * omega / edge.rock.young * cell.mass;
  column.own_at_edge = column.own + Complex(0, omega / edge.rock.young) * edge_damping(edge, cell.model);
  for (const std::size_t c : {6U, 7U, 8U}) column.own_at_edge -= cell.interfaces[c] / edge.rock.young;
  return column;
}

// A wave of the mesh: q(n) = shape back^-n.
struct MeshWave {
  Complex back;  // from one column to the one behind it
  Vector shape;
  double flux = 0;  // energy through a joint between columns, towards the edge; 0 for waves that decay
};

constexpr double unit_circle = 1e-7;

MeshWave wave_of(const Column& column, Complex back, const Vector& shape) {
  MeshWave wave{back, shape.normalized(), 0};
  if (std::abs(std::abs(back) - 1) < unit_circle) wave.flux = (wave.shape.dot(column.ahead * wave.shape) / back).imag();
  return wave;
}

// Solutions of (back m^2 + own m + ahead) shape = 0 for m = MeshWave::back. The coupling matrices are singular, so m
// may be 0 or infinite: with a shift both are harmless.
std::vector<MeshWave> waves_of(const Column& column) {
  const Eigen::Index size = column.own.rows();
  const Matrix one = Matrix::Identity(size, size);
  Matrix left = Matrix::Zero(2 * size, 2 * size);
  Matrix right = left;
  left.topRightCorner(size, size) = one;
  left.bottomLeftCorner(size, size) = -column.ahead;
  left.bottomRightCorner(size, size) = -column.own;
  right.topLeftCorner(size, size) = one;
  right.bottomRightCorner(size, size) = column.back;
  const Complex shift(0.37, 0.61);
  const Eigen::ComplexEigenSolver<Matrix> solver((left - shift * right).partialPivLu().solve(right));
  std::vector<MeshWave> waves;
  for (Eigen::Index i = 0; i < 2 * size; ++i) {
    const Complex value = solver.eigenvalues()(i);
    if (std::abs(value) < 1e-12) continue;  // m infinite: nothing that leaves the edge
    waves.push_back(wave_of(column, shift + 1.0 / value, solver.eigenvectors().col(i).head(size)));
  }
  return waves;
}

// The wave of that kind among those that travel in one direction: P is faster, so it has the smaller phase from column
// to column.
const MeshWave& travelling(const std::vector<MeshWave>& waves, exact::PlaneWave kind, double sign) {
  std::vector<const MeshWave*> found;
  for (const MeshWave& wave : waves)
    if (wave.flux * sign > 0) found.push_back(&wave);
  std::ranges::sort(found, {}, [](const MeshWave* wave) { return std::abs(std::arg(wave->back)); });
  if (found.empty() || found.size() > 2) throw std::runtime_error("a mesh has S and P waves and no others");
  return kind == exact::PlaneWave::p ? *found.front() : *found.back();
}

}  // namespace

EdgeReflection reflect(const MeshEdge& edge, exact::PlaneWave incident, double angle, double omega) {
  const CellMatrices cell = cell_matrices(edge.mesh, edge.rock, edge.bond, edge.corrected);
  const double speed = incident == exact::PlaneWave::p ? dda::p_wave_speed(edge.rock) : dda::s_wave_speed(edge.rock);
  const Column column = column_of(edge, cell, omega / speed * std::sin(angle), omega);
  const std::vector<MeshWave> waves = waves_of(column);
  const MeshWave& in = travelling(waves, incident, 1);
  std::vector<const MeshWave*> leaving;
  for (const MeshWave& wave : waves)
    if (wave.flux < 0 || (wave.flux == 0 && std::abs(wave.back) < 1)) leaving.push_back(&wave);
  const Eigen::Index size = column.own.rows();
  if (static_cast<Eigen::Index>(leaving.size()) != size) throw std::runtime_error("half of all waves must leave");
  const auto at_edge = [&](const MeshWave& wave) -> Vector {
    return column.back * (wave.back * wave.shape) + column.own_at_edge * wave.shape;
  };
  Matrix balance(size, size);
  for (Eigen::Index i = 0; i < size; ++i) balance.col(i) = at_edge(*leaving[static_cast<std::size_t>(i)]);
  const Vector amplitudes = balance.fullPivLu().solve(-at_edge(in));
  EdgeReflection result;
  Vector motion = in.shape;
  const MeshWave* s = &travelling(waves, exact::PlaneWave::s, -1);
  for (Eigen::Index i = 0; i < size; ++i) {
    const MeshWave& wave = *leaving[static_cast<std::size_t>(i)];
    motion += amplitudes(i) * wave.shape;
    (&wave == s ? result.s_energy : result.p_energy) -= std::norm(amplitudes(i)) * wave.flux / in.flux;
  }
  const Matrix dashpots = edge_damping(edge, cell.model).cast<Complex>() * (omega / edge.rock.young);
  result.absorbed = motion.dot(dashpots * motion).real() / in.flux;
  return result;
}

}  // namespace verify
