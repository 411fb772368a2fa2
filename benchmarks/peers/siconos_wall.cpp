// The wall of ci/compare-peers as rigid bricks stepped by Moreau and Jean's scheme, each step a frictional contact
// problem for Siconos' plane Gauss-Seidel: `siconos-wall SIDE DT STEPS TOLERANCE` prints bricks, CPU ms a step and the
// farthest way of a brick in m.
//
// With v_f = v + dt g and gaps p:  v = v_f + M^-1 H r,  0 <= H_N^T v + p_N/dt, r_N >= 0, and Coulomb's law for H_T^T v.
// Bricks stay where they are to first order, so contacts, H and W = H^T M^-1 H are made once.
#include <cstdio>
#include <cstdlib>
#include <map>
#include <utility>

#include "wall.h"

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

namespace {

using peers::Brick;

struct Contact {
  int below, above;  // brick; -1: the floor
  double x, y;
  bool is_upright;  // a joint between neighbours: its normal points right
};

// Both ends of every stretch that two bricks, or a brick and the floor, have in common.
std::vector<Contact> contacts_of(const std::vector<Brick>& bricks) {
  std::vector<Contact> contacts;
  const auto count = static_cast<int>(bricks.size());
  for (int b = 0; b < count; ++b) {
    const Brick& above = bricks[static_cast<std::size_t>(b)];
    const double left = above.x - above.width / 2, right = above.x + above.width / 2;
    const double foot = above.y - peers::brick_height / 2;
    if (foot == 0)
      for (const double x : {left, right}) contacts.push_back({-1, b, x, 0, false});
    for (int a = 0; a < b; ++a) {
      const Brick& other = bricks[static_cast<std::size_t>(a)];
      const double from = std::max(left, other.x - other.width / 2), to = std::min(right, other.x + other.width / 2);
      const bool lies_on = other.y + peers::brick_height / 2 == foot && to > from;
      const bool stands_beside = other.y == above.y && other.x + other.width / 2 == left;
      if (lies_on)
        for (const double x : {from, to}) contacts.push_back({a, b, x, foot, false});
      if (stands_beside)
        for (const double y : {foot, foot + peers::brick_height}) contacts.push_back({a, b, left, y, true});
    }
  }
  return contacts;
}

using Row = double[3];

// What velocity and spin of a brick make of normal and tangential velocity at the contact.
void rows_of(const Contact& contact, const Brick& brick, double side, Row& normal, Row& tangent) {
  const double x = contact.x - brick.x, y = contact.y - brick.y;
  const double nx = contact.is_upright ? side : 0, ny = contact.is_upright ? 0 : side;
  normal[0] = nx, normal[1] = ny, normal[2] = x * ny - y * nx;
  tangent[0] = -ny, tangent[1] = nx, tangent[2] = x * nx + y * ny;
}

struct Column {  // of H: two bricks
  int brick[2];
  double entry[2][3];
};

std::vector<Column> columns_of(const std::vector<Contact>& contacts, const std::vector<Brick>& bricks) {
  std::vector<Column> columns(2 * contacts.size());
  for (std::size_t k = 0; k < contacts.size(); ++k)
    for (int end = 0; end < 2; ++end) {
      const int brick = end == 0 ? contacts[k].below : contacts[k].above;
      columns[2 * k].brick[end] = columns[2 * k + 1].brick[end] = brick;
      if (brick >= 0)
        rows_of(contacts[k], bricks[static_cast<std::size_t>(brick)], end == 0 ? -1 : 1, columns[2 * k].entry[end],
                columns[2 * k + 1].entry[end]);
    }
  return columns;
}

struct Wall {
  std::vector<Brick> bricks;
  std::vector<Column> columns;
  std::vector<double> inverse_mass;  // 3 a brick
};

Wall wall_with_contacts(int side) {
  Wall wall;
  wall.bricks = peers::wall_of(side);
  wall.columns = columns_of(contacts_of(wall.bricks), wall.bricks);
  for (const Brick& brick : wall.bricks) {
    const double h = peers::brick_height, mass = peers::density * brick.width * h;
    for (const double inertia : {mass, mass, mass * (brick.width * brick.width + h * h) / 12})
      wall.inverse_mass.push_back(1 / inertia);
  }
  return wall;
}

// W times the mass of a brick, so that its diagonal is about 1 and forces are impulses over that mass.
constexpr double scale = peers::density * peers::brick_height;

NumericsMatrix* delassus(const Wall& wall) {
  const auto count = static_cast<int>(wall.columns.size());
  std::vector<std::vector<int>> of_brick(wall.bricks.size());
  for (int i = 0; i < count; ++i)
    for (const int brick : wall.columns[static_cast<std::size_t>(i)].brick)
      if (brick >= 0) of_brick[static_cast<std::size_t>(brick)].push_back(i);
  std::map<std::pair<int, int>, double> sums;  // Siconos keeps one of several numbers at a place
  for (std::size_t brick = 0; brick < wall.bricks.size(); ++brick)
    for (const int i : of_brick[brick])
      for (const int j : of_brick[brick]) {
        const Column &a = wall.columns[static_cast<std::size_t>(i)], &b = wall.columns[static_cast<std::size_t>(j)];
        double sum = 0;
        for (std::size_t n = 0; n < 3; ++n)
          sum += a.entry[a.brick[1] == static_cast<int>(brick)][n] * wall.inverse_mass[3 * brick + n] *
                 b.entry[b.brick[1] == static_cast<int>(brick)][n];
        sums[{i, j}] += scale * sum;
      }
  NumericsMatrix* triplets = NM_create(NM_SPARSE, count, count);
  NM_triplet_alloc(triplets, static_cast<CS_INT>(sums.size()));
  for (const auto& [place, sum] : sums) NM_entry(triplets, place.first, place.second, sum);
  NumericsMatrix* blocks = NM_create(NM_SPARSE_BLOCK, count, count);
  SBM_from_csparse(2, NM_csc(triplets), blocks->matrix1);
  return blocks;
}

double along(const Column& column, const std::vector<double>& v) {
  double sum = 0;
  for (int end = 0; end < 2; ++end)
    for (std::size_t n = 0; column.brick[end] >= 0 && n < 3; ++n)
      sum += column.entry[end][n] * v[3 * static_cast<std::size_t>(column.brick[end]) + n];
  return sum;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) return 2;
  const int side = std::atoi(argv[1]), steps = std::atoi(argv[3]);
  const double dt = std::atof(argv[2]);
  const Wall wall = wall_with_contacts(side);
  const std::size_t count = wall.columns.size();
  std::vector<double> v(3 * wall.bricks.size(), 0), way = v, r(count, 0), u = r, q = r, gap = r;
  std::vector<double> mu(count / 2, peers::friction);
  const std::clock_t begin = std::clock();
  FrictionContactProblem problem{2, static_cast<int>(count / 2), delassus(wall), q.data(), mu.data()};
  SolverOptions* options = solver_options_create(SICONOS_FRICTION_2D_NSGS);
  options->iparam[SICONOS_IPARAM_MAX_ITER] = 100'000;
  options->dparam[SICONOS_DPARAM_TOL] = std::atof(argv[4]);
  int failed = 0;
  for (int step = 0; step < steps; ++step) {
    for (std::size_t i = 1; i < v.size(); i += 3) v[i] -= dt * peers::gravity;
    for (std::size_t i = 0; i < count; ++i) q[i] = along(wall.columns[i], v) + (i % 2 == 0 ? gap[i] / dt : 0);
    failed += fc2d_driver(&problem, r.data(), u.data(), options) != 0;
    for (std::size_t i = 0; i < count; ++i)
      for (int end = 0; end < 2; ++end)
        for (std::size_t n = 0; wall.columns[i].brick[end] >= 0 && n < 3; ++n) {
          const std::size_t at = 3 * static_cast<std::size_t>(wall.columns[i].brick[end]) + n;
          v[at] += wall.inverse_mass[at] * scale * wall.columns[i].entry[end][n] * r[i];
        }
    for (std::size_t i = 0; i < v.size(); ++i) way[i] += dt * v[i];
    for (std::size_t i = 0; i < count; ++i) gap[i] = along(wall.columns[i], way);
  }
  const double seconds = peers::seconds_since(begin);
  double drift = 0;
  for (std::size_t i = 0; i < way.size(); i += 3) drift = std::max(drift, std::hypot(way[i], way[i + 1]));
  std::printf("%zu %.6g %.6g\n", wall.bricks.size(), 1e3 * seconds / steps, drift);
  if (failed > 0) std::fprintf(stderr, "siconos-wall: %d of %d steps did not converge\n", failed, steps);
  return 0;
}
