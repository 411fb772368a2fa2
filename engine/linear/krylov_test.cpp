#include "engine/linear/krylov.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <limits>

#include "engine/core/allocation_counter.h"
#include "engine/linear/random_system.h"

namespace dda {
namespace {

// A system that is not symmetric: springs, and forces that follow a displacement without an answer to them.
Eigen::MatrixXd lopsided(const RandomSystem& system, double share) {
  Eigen::MatrixXd dense = system.dense;
  for (Eigen::Index i = 0; i + 6 < dense.rows(); i += 6) dense(i + 7, i) += share * dense(i, i);
  return dense;
}

struct Preconditioned {
  Eigen::MatrixXd matrix;
  Eigen::VectorXd inverse_diagonal;
  auto multiply() const {
    return [this](const Eigen::VectorXd& v, Eigen::VectorXd& w) { w.noalias() = matrix * v; };
  }
  auto precondition() const {
    return [this](const Eigen::VectorXd& r, Eigen::VectorXd& z) {
      z = inverse_diagonal.cwiseProduct(r);
      return r.dot(z);
    };
  }
};

Preconditioned preconditioned(const Eigen::MatrixXd& matrix) { return {matrix, matrix.diagonal().cwiseInverse()}; }

// A system of 120 unknowns that is not symmetric, solved for to 1e-12.
struct SolvedLopsided {
  SolvedLopsided(int basis, int most) {
    Gmres gmres(basis);
    gmres.resize(120);
    result = gmres.solve(problem.multiply(), problem.precondition(), system.rhs, 1e-12, most, x);
  }

  void expect_solution() const {
    EXPECT_EQ(result.status, Status::ok);
    const Eigen::VectorXd expected = problem.matrix.partialPivLu().solve(system.rhs);
    EXPECT_LE((x - expected).norm(), 1e-10 * expected.norm());
  }

  RandomSystem system = random_system(20, grid_couplings(5, 4), 2);
  Preconditioned problem = preconditioned(lopsided(system, 0.8));
  Eigen::VectorXd x = Eigen::VectorXd(120);
  KrylovResult result;
};

TEST(Gmres, SolvesWhatIsNotSymmetric) { SolvedLopsided(120, 120).expect_solution(); }

// The residual it stops at is the true one, in the norm of the preconditioner.
TEST(Gmres, KnowsItsResidual) {
  const RandomSystem system = random_system(20, grid_couplings(5, 4), 2);
  const Preconditioned problem = preconditioned(lopsided(system, 0.8));
  Gmres gmres(60);
  gmres.resize(120);
  Eigen::VectorXd x(120);
  const auto norm = [&](const Eigen::VectorXd& r) {
    return std::sqrt(r.dot(problem.inverse_diagonal.cwiseProduct(r)));
  };
  int before = 0;
  for (const double relative : {1e-1, 1e-2, 1e-3}) {
    const KrylovResult result = gmres.solve(problem.multiply(), problem.precondition(), system.rhs, relative, 60, x);
    EXPECT_EQ(result.status, Status::ok);
    EXPECT_GT(result.iterations, before);
    EXPECT_LE(norm(system.rhs - problem.matrix * x), (1 + 1e-9) * relative * norm(system.rhs));
    before = result.iterations;
  }
}

TEST(Gmres, StopsWhereItMayGoNoFurtherWithTheBestFound) {
  const SolvedLopsided solved(5, 5);
  EXPECT_EQ(solved.result.status, Status::not_converged);
  EXPECT_EQ(solved.result.iterations, 5);
  EXPECT_LT((solved.system.rhs - solved.problem.matrix * solved.x).norm(), solved.system.rhs.norm());
}

TEST(Gmres, BeginsAgainWhereItsBasisIsFull) {
  const SolvedLopsided solved(20, 400);
  solved.expect_solution();
  EXPECT_GT(solved.result.iterations, 20);
}

// A rotation by a right angle moves every residual of a basis of one across itself: none is less.
TEST(Gmres, DoesNotBeginAgainWhereThatLeadsNowhere) {
  Eigen::MatrixXd turn = Eigen::MatrixXd::Identity(6, 6);
  turn.topLeftCorner<2, 2>() << 0, -1, 1, 0;
  const auto multiply = [&turn](const Eigen::VectorXd& v, Eigen::VectorXd& w) { w = turn * v; };
  const auto precondition = [](const Eigen::VectorXd& r, Eigen::VectorXd& z) {
    z = r;
    return r.dot(r);
  };
  Gmres gmres(1);
  gmres.resize(6);
  Eigen::VectorXd x(6);
  const KrylovResult result = gmres.solve(multiply, precondition, Eigen::VectorXd::Unit(6, 0), 1e-12, 400, x);
  EXPECT_EQ(result.status, Status::not_converged);
  EXPECT_EQ(result.iterations, 1);
}

TEST(Gmres, HasNothingToDoWithoutLoadAndReportsWhatIsNotFinite) {
  const Preconditioned problem = preconditioned(Eigen::MatrixXd::Identity(6, 6));
  Gmres gmres(5);
  gmres.resize(6);
  Eigen::VectorXd x = Eigen::VectorXd::Ones(6);
  const KrylovResult none =
      gmres.solve(problem.multiply(), problem.precondition(), Eigen::VectorXd::Zero(6), 1e-12, 5, x);
  EXPECT_EQ(none.status, Status::ok);
  EXPECT_EQ(none.iterations, 0);
  EXPECT_TRUE(x.isZero(0));
  const Eigen::VectorXd load = Eigen::VectorXd::Constant(6, std::numeric_limits<double>::infinity());
  EXPECT_EQ(gmres.solve(problem.multiply(), problem.precondition(), load, 1e-12, 5, x).status, Status::not_finite);
}

// On a symmetric system both minimize over the same space, each in its own norm.
TEST(Gmres, TakesAsManyIterationsAsConjugateGradients) {
  const RandomSystem system = random_system(100, grid_couplings(10, 10), 3);
  const Preconditioned problem = preconditioned(system.dense);
  Gmres gmres(200);
  gmres.resize(600);
  ConjugateGradients gradients;
  gradients.resize(600);
  Eigen::VectorXd x(600);
  Eigen::VectorXd y = Eigen::VectorXd::Zero(600);
  const KrylovResult one = gmres.solve(problem.multiply(), problem.precondition(), system.rhs, 1e-8, 200, x);
  const KrylovResult other = gradients.solve(problem.multiply(), problem.precondition(), system.rhs, 1e-8, 200, y);
  EXPECT_EQ(one.status, Status::ok);
  EXPECT_EQ(other.status, Status::ok);
  EXPECT_LE(one.iterations, other.iterations);
  EXPECT_GE(one.iterations, other.iterations - 5);
}

TEST(Gmres, AllocatesNothingWhenWarm) {
  const RandomSystem system = random_system(20, grid_couplings(5, 4), 2);
  const Preconditioned problem = preconditioned(lopsided(system, 0.8));
  Gmres gmres(60);
  gmres.resize(120);
  Eigen::VectorXd x(120);
  const auto solve = [&] {
    return gmres.solve(problem.multiply(), problem.precondition(), system.rhs, 1e-6, 60, x).status;
  };
  EXPECT_EQ(solve(), Status::ok);
  const long before = allocations_so_far();
  const Status status = solve();
  EXPECT_EQ(allocations_so_far() - before, 0);
  EXPECT_EQ(status, Status::ok);
}

}  // namespace
}  // namespace dda
