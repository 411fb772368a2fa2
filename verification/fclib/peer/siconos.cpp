#include "verification/fclib/peer/siconos.h"

#include <ctime>
#include <memory>

extern "C" {
#include <CSparseMatrix.h>
#include <FrictionContactProblem.h>
#include <Friction_cst.h>
#include <NonSmoothDrivers.h>
#include <NumericsMatrix.h>
#include <NumericsSparseMatrix.h>
#include <SolverOptions.h>
#include <SparseBlockMatrix.h>
}

namespace verify {
namespace {

struct Scaled {
  double of_forces = 1;
  SparseMatrix matrix;
  Eigen::VectorXd free, friction;
};

Scaled scaled(const LocalFrictionProblem& problem) {
  Scaled result;
  const double softness = problem.delassus.diagonal().mean();
  const double gap = problem.free.cwiseAbs().maxCoeff();
  result.of_forces = gap / softness;
  result.matrix = problem.delassus / softness;
  result.free = problem.free / gap;
  result.friction = problem.friction;
  return result;
}

// Number i of a plane problem among those of a spatial one.
int spatial(Eigen::Index i) { return static_cast<int>(3 * (i / 2) + i % 2); }

Scaled with_second_tangent(const Scaled& plane) {
  std::vector<Eigen::Triplet<double>> numbers;
  for (Eigen::Index column = 0; column < plane.matrix.outerSize(); ++column)
    for (SparseMatrix::InnerIterator entry(plane.matrix, column); entry; ++entry)
      numbers.emplace_back(spatial(entry.row()), spatial(column), entry.value());
  const Eigen::Index contacts = plane.friction.size();
  for (int k = 0; k < contacts; ++k) numbers.emplace_back(3 * k + 2, 3 * k + 2, 1.0);
  Scaled space = plane;
  space.matrix.resize(3 * contacts, 3 * contacts);
  space.matrix.setFromTriplets(numbers.begin(), numbers.end());
  space.free = Eigen::VectorXd::Zero(3 * contacts);
  for (Eigen::Index i = 0; i < plane.free.size(); ++i) space.free(spatial(i)) = plane.free(i);
  return space;
}

Eigen::VectorXd without_second_tangent(const Eigen::VectorXd& space) {
  Eigen::VectorXd plane(2 * space.size() / 3);
  for (Eigen::Index i = 0; i < plane.size(); ++i) plane(i) = space(spatial(i));
  return plane;
}

using Matrix = std::unique_ptr<NumericsMatrix, NumericsMatrix* (*)(NumericsMatrix*)>;

Matrix sparse(const SparseMatrix& matrix) {
  const int size = static_cast<int>(matrix.rows());
  Matrix result(NM_create(NM_SPARSE, size, size), NM_free);
  NM_triplet_alloc(result.get(), static_cast<CS_INT>(matrix.nonZeros()));
  for (Eigen::Index column = 0; column < matrix.outerSize(); ++column)
    for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry)
      NM_entry(result.get(), static_cast<int>(entry.row()), static_cast<int>(column), entry.value());
  return result;
}

// Plane solvers take a dense matrix, and Gauss-Seidel one of 2 x 2 blocks.
Matrix dense(const SparseMatrix& matrix) {
  const int size = static_cast<int>(matrix.rows());
  Matrix result(NM_create(NM_DENSE, size, size), NM_free);
  Eigen::Map<Eigen::MatrixXd>(result->matrix0, size, size) = matrix;
  return result;
}

Matrix blocks(const SparseMatrix& matrix) {
  const int size = static_cast<int>(matrix.rows());
  const Matrix triplets = sparse(matrix);
  Matrix result(NM_create(NM_SPARSE_BLOCK, size, size), NM_free);
  SBM_from_csparse(2, NM_csc(triplets.get()), result->matrix1);
  return result;
}

Matrix matrix_for(const PeerSolver& solver, const SparseMatrix& matrix) {
  if (solver.is_spatial) return sparse(matrix);
  return solver.number == SICONOS_FRICTION_2D_NSGS ? blocks(matrix) : dense(matrix);
}

}  // namespace

const std::vector<PeerSolver>& siconos_solvers() {
  static const std::vector<PeerSolver> solvers{
      {"Gauss-Seidel (2-D NSGS)", SICONOS_FRICTION_2D_NSGS, false, 100'000, 100'000},
      {"projected gradients (2-D CPG)", SICONOS_FRICTION_2D_CPG, false, 20'000, 1'500},
      {"Lemke (2-D, as LCP)", SICONOS_FRICTION_2D_LEMKE, false, 100'000, 700},
      {"Newton, Alart-Curnier (3-D NSN_AC)", SICONOS_FRICTION_3D_NSN_AC, true, 500, 100'000},
      {"Newton, Fischer-Burmeister (3-D NSN_FB)", SICONOS_FRICTION_3D_NSN_FB, true, 500, 100'000},
  };
  return solvers;
}

PeerAnswer ask_siconos(const PeerSolver& solver, const LocalFrictionProblem& problem, double tolerance) {
  Scaled asked = scaled(problem);
  const double of_forces = asked.of_forces;
  if (solver.is_spatial) asked = with_second_tangent(asked);
  const Matrix matrix = matrix_for(solver, asked.matrix);
  FrictionContactProblem posed{solver.is_spatial ? 3 : 2, static_cast<int>(asked.friction.size()), matrix.get(),
                               asked.free.data(), asked.friction.data()};
  const std::unique_ptr<SolverOptions, void (*)(SolverOptions*)> options(solver_options_create(solver.number),
                                                                         solver_options_delete);
  options->iparam[SICONOS_IPARAM_MAX_ITER] = solver.most_iterations;
  options->dparam[SICONOS_DPARAM_TOL] = tolerance;
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(asked.free.size()), moved = forces;
  PeerAnswer answer;
  const std::clock_t begin = std::clock();
  const int info = solver.is_spatial ? fc3d_driver(&posed, forces.data(), moved.data(), options.get())
                                     : fc2d_driver(&posed, forces.data(), moved.data(), options.get());
  answer.cpu_s = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  answer.is_there = info == 0;
  answer.iterations = options->iparam[SICONOS_IPARAM_ITER_DONE];
  answer.forces = of_forces * (solver.is_spatial ? without_second_tangent(forces) : forces);
  return answer;
}

}  // namespace verify
