#include "verification/fclib/peer/fclib_file.h"

#include <filesystem>
#include <stdexcept>
#include <vector>

extern "C" {
#include <fclib.h>
}

namespace verify {
namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

// Refers to the numbers of `matrix`, in compressed columns.
fclib_matrix view_of(SparseMatrix& matrix) {
  matrix.makeCompressed();
  const int numbers = static_cast<int>(matrix.nonZeros());
  return {.nzmax = numbers,
          .m = static_cast<int>(matrix.rows()),
          .n = static_cast<int>(matrix.cols()),
          .p = matrix.outerIndexPtr(),
          .i = matrix.innerIndexPtr(),
          .x = matrix.valuePtr(),
          .nz = -1,
          .info = nullptr};
}

SparseMatrix matrix_of(const fclib_matrix& given) {
  Triplets numbers;
  for (int k = 0; given.nz >= 0 && k < given.nz; ++k) numbers.emplace_back(given.p[k], given.i[k], given.x[k]);
  const int lines = given.nz == -1 ? given.n : given.nz == -2 ? given.m : 0;
  for (int line = 0; line < lines; ++line)
    for (int k = given.p[line]; k < given.p[line + 1]; ++k) {
      if (given.nz == -1) numbers.emplace_back(given.i[k], line, given.x[k]);
      if (given.nz == -2) numbers.emplace_back(line, given.i[k], given.x[k]);
    }
  SparseMatrix matrix(given.m, given.n);
  matrix.setFromTriplets(numbers.begin(), numbers.end());
  return matrix;
}

void append(const SparseMatrix& matrix, Triplets& numbers) {
  for (Eigen::Index column = 0; column < matrix.outerSize(); ++column)
    for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry)
      numbers.emplace_back(entry.row(), column, entry.value());
}

FrictionProblem with_springs_as_unknowns(const FrictionProblem& problem) {
  const Eigen::Index unknowns = problem.mass.rows(), springs = problem.compliance.size();
  if ((problem.compliance.array() == 0).all()) return problem;
  Triplets mass, directions;
  append(problem.mass, mass);
  append(problem.directions, directions);
  for (Eigen::Index i = 0; i < springs; ++i) {
    mass.emplace_back(unknowns + i, unknowns + i, 1 / problem.compliance(i));
    directions.emplace_back(unknowns + i, i, 1.0);
  }
  FrictionProblem more = problem;
  more.mass.resize(unknowns + springs, unknowns + springs);
  more.mass.setFromTriplets(mass.begin(), mass.end());
  more.directions.resize(unknowns + springs, springs);
  more.directions.setFromTriplets(directions.begin(), directions.end());
  more.force = Eigen::VectorXd::Zero(unknowns + springs);
  more.force.head(unknowns) = problem.force;
  more.compliance.setZero();
  return more;
}

// The last unknowns, one a number of a contact, are its spring: tied to nothing else.
bool ends_in_springs(const FrictionProblem& problem) {
  const Eigen::Index springs = problem.compliance.size(), others = problem.mass.rows() - springs;
  if (others <= 0) return false;
  const SparseMatrix mass = problem.mass.bottomRows(springs);
  const SparseMatrix directions = problem.directions.bottomRows(springs);
  if (mass.nonZeros() != springs || directions.nonZeros() != springs) return false;
  for (Eigen::Index i = 0; i < springs; ++i)
    if (mass.coeff(i, others + i) == 0 || directions.coeff(i, i) != 1 || problem.force(others + i) != 0) return false;
  return true;
}

void take_springs_back(FrictionProblem& problem) {
  if (!ends_in_springs(problem)) return;
  const Eigen::Index springs = problem.compliance.size(), others = problem.mass.rows() - springs;
  problem.compliance = problem.mass.diagonal().tail(springs).cwiseInverse();
  problem.mass = SparseMatrix(problem.mass.topLeftCorner(others, others));
  problem.directions = SparseMatrix(problem.directions.topRows(others));
  problem.force = Eigen::VectorXd(problem.force.head(others));
}

}  // namespace

void write_fclib(const FrictionProblem& problem, const std::string& title, const std::string& file) {
  FrictionProblem rigid = with_springs_as_unknowns(problem);
  fclib_matrix mass = view_of(rigid.mass), directions = view_of(rigid.directions);
  std::string name = title, description = "a step of dda", nothing = "existence and uniqueness unknown";
  fclib_info info{name.data(), description.data(), nothing.data()};
  fclib_global global{};
  global.M = &mass;
  global.H = &directions;
  global.mu = rigid.friction.data();
  global.f = rigid.force.data();
  global.w = rigid.gaps.data();
  global.spacedim = 2;
  global.info = &info;
  std::filesystem::remove(file);
  if (fclib_write_global(&global, file.c_str()) != 1) throw std::runtime_error(file + ": FCLIB could not write it");
}

FrictionProblem read_fclib(const std::string& file) {
  fclib_global* global = std::filesystem::is_regular_file(file) ? fclib_read_global(file.c_str()) : nullptr;
  if (global == nullptr) throw std::runtime_error(file + " holds no global problem of FCLIB");
  if (global->spacedim != 2 || global->G != nullptr)
    throw std::runtime_error(file + ": expected a problem of two dimensions without equality constraints");
  FrictionProblem problem;
  problem.mass = matrix_of(*global->M);
  problem.directions = matrix_of(*global->H);
  const Eigen::Index numbers = problem.directions.cols();
  problem.force = Eigen::Map<Eigen::VectorXd>(global->f, problem.mass.rows());
  problem.gaps = Eigen::Map<Eigen::VectorXd>(global->w, numbers);
  problem.friction = Eigen::Map<Eigen::VectorXd>(global->mu, numbers / 2);
  problem.compliance = Eigen::VectorXd::Zero(numbers);
  fclib_delete_global(global);
  take_springs_back(problem);
  return problem;
}

}  // namespace verify
