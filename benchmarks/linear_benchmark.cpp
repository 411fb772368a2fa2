// The figures behind choose_solver (engine/linear/README.md): a reused factor, a new factor and conjugate gradients, on
// a chain of 200 square blocks and on grids of 400, 2,500 and 10,000, bonded by two springs an interface.
//
// Arguments: columns, rows, and for PCG 1000 chi with chi = k dt^2 / m. Times do not depend on chi otherwise.
#include <benchmark/benchmark.h>

#include <random>
#include <utility>
#include <vector>

#include "engine/linear/cholesky_solver.h"
#include "engine/linear/pcg_solver.h"

namespace dda {
namespace {

using Pairs = std::vector<std::pair<int, int>>;

Pairs grid_pairs(int columns, int rows) {
  Pairs pairs;
  for (int i = 0; i < columns * rows; ++i) {
    if ((i + 1) % columns != 0) pairs.emplace_back(i, i + 1);
    if (i + columns < columns * rows) pairs.emplace_back(i, i + columns);
  }
  return pairs;
}

// Two springs, normal and tangential stiffness chi / 2 each, at the corners of the edge that the unit squares i and j
// share; `step` leads from centre to centre.
void add_bond(BlockMatrix& matrix, int i, int j, const Vec2& step, double chi) {
  for (const double end : {-0.5, 0.5}) {
    const Vec2 corner = 0.5 * step + end * Vec2(-step.y(), step.x());
    const Mat26 on_i = displacement_rows(corner);
    const Mat26 on_j = displacement_rows(corner - step);
    matrix.add_coupling(i, i, 0.5 * chi * on_i.transpose() * on_i);
    matrix.add_coupling(j, j, 0.5 * chi * on_j.transpose() * on_j);
    matrix.add_coupling(i, j, -0.5 * chi * on_i.transpose() * on_j);
  }
}

// The step matrix over m / dt^2, of unit squares: inertia plus bonds.
BlockMatrix bonded_grid(int columns, int rows, double chi) {
  const Pairs pairs = grid_pairs(columns, rows);
  BlockMatrix matrix(columns * rows, pairs);
  Vec6 inertia;
  inertia << 1, 1, 1.0 / 6, 1.0 / 12, 1.0 / 12, 1.0 / 24;
  for (int i = 0; i < matrix.size(); ++i) matrix.diagonal(i).diagonal() += inertia;
  for (const auto& [i, j] : pairs) add_bond(matrix, i, j, j == i + columns ? Vec2(0, 1) : Vec2(1, 0), chi);
  return matrix;
}

// A right-hand side with all wavelengths in it: the hardest case for PCG.
Eigen::VectorXd rough_load(const BlockMatrix& matrix) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  return Eigen::VectorXd::NullaryExpr(matrix.unknowns(), [&] { return uniform(generator); });
}

BlockMatrix matrix_of(const benchmark::State& state, double chi) {
  return bonded_grid(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)), chi);
}

// Makes block-solves per second appear.
void count_blocks(benchmark::State& state) {
  state.SetItemsProcessed(state.iterations() * state.range(0) * state.range(1));
}

void analyze(benchmark::State& state) {
  const BlockMatrix matrix = matrix_of(state, 1);
  CholeskySolver solver;
  for (auto _ : state) solver.analyze(matrix);
  state.counters["nonzeros"] = solver.factor_facts().nonzeros;
  count_blocks(state);
}

void factorize(benchmark::State& state) {
  const BlockMatrix matrix = matrix_of(state, 1);
  CholeskySolver solver;
  solver.analyze(matrix);
  for (auto _ : state) {
    if (solver.factorize(matrix) != Status::ok) state.SkipWithError("singular");
  }
  count_blocks(state);
}

void solve_with_reused_factor(benchmark::State& state) {
  const BlockMatrix matrix = matrix_of(state, 1);
  const Eigen::VectorXd rhs = rough_load(matrix);
  Eigen::VectorXd x(rhs.size());
  CholeskySolver solver;
  solver.analyze(matrix);
  if (solver.factorize(matrix) != Status::ok) state.SkipWithError("singular");
  for (auto _ : state) {
    benchmark::DoNotOptimize(solver.solve(rhs, x));
    benchmark::ClobberMemory();
  }
  count_blocks(state);
}

// From a zero guess, with the set-up of the preconditioner, as for a matrix that changed.
void solve_with_pcg(benchmark::State& state) {
  const BlockMatrix matrix = matrix_of(state, static_cast<double>(state.range(2)) / 1000);
  const Eigen::VectorXd rhs = rough_load(matrix);
  Eigen::VectorXd x(rhs.size());
  PcgSolver solver;
  solver.analyze(matrix);
  for (auto _ : state) {
    x.setZero();
    if (solver.factorize(matrix) != Status::ok || solver.solve(rhs, x) != Status::ok) state.SkipWithError("failed");
  }
  state.counters["iterations_each"] =
      static_cast<double>(solver.counts().iterations) / static_cast<double>(solver.counts().solves);
  count_blocks(state);
}

void multiply(benchmark::State& state) {
  const BlockMatrix matrix = matrix_of(state, 1);
  const Eigen::VectorXd x = rough_load(matrix);
  Eigen::VectorXd y(x.size());
  for (auto _ : state) {
    matrix.multiply(x, y);
    benchmark::ClobberMemory();
  }
  count_blocks(state);
}

void shapes(benchmark::internal::Benchmark* benchmark) {
  benchmark->Unit(benchmark::kMicrosecond);
  for (const auto& [columns, rows] : {std::pair{200, 1}, {20, 20}, {50, 50}, {100, 100}}) {
    benchmark->Args({columns, rows});
  }
}

void shapes_and_chi(benchmark::internal::Benchmark* benchmark) {
  benchmark->Unit(benchmark::kMicrosecond);
  for (const auto& [columns, rows] : {std::pair{200, 1}, {20, 20}, {50, 50}, {100, 100}}) {
    for (const int chi_thousandths : {20, 200, 2000, 20000}) benchmark->Args({columns, rows, chi_thousandths});
  }
}

BENCHMARK(analyze)->Name("linear/analyze")->Apply(shapes);
BENCHMARK(factorize)->Name("linear/factorize")->Apply(shapes);
BENCHMARK(solve_with_reused_factor)->Name("linear/reused_solve")->Apply(shapes);
BENCHMARK(solve_with_pcg)->Name("linear/pcg")->Apply(shapes_and_chi);
BENCHMARK(multiply)->Name("linear/multiply")->Apply(shapes);

}  // namespace
}  // namespace dda
