#include "verification/cases/incompressible_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>

#include "verification/cases/bonded_beam.h"
#include "verification/lattice/periodic_mesh.h"
#include "verification/suite/expect.h"

namespace verify {
namespace {

constexpr double load = 1e3;   // N per m of thickness
constexpr double young = 1e9;  // Pa
constexpr double length = 8;   // m; the beam is 1 m deep, its axis at y = 0

using Rings = std::vector<dda::Ring>;

dda::Ring box(double left, double bottom, double right, double top) {
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

Rings squares(int rows) {
  const double side = 1.0 / rows;
  Rings rings;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < length * rows; ++column)
      rings.push_back(box(column * side, row * side - 0.5, (column + 1) * side, (row + 1) * side - 0.5));
  return rings;
}

// Running bond of bricks twice as long as high; every other course begins and ends with half a brick.
Rings bricks(int rows) {
  const double height = 1.0 / rows;
  Rings rings;
  for (int row = 0; row < rows; ++row)
    for (double left = row % 2 == 0 ? 0 : -height; left < length - height / 2; left += 2 * height)
      rings.push_back(
          box(std::max(left, 0.0), row * height - 0.5, std::min(left + 2 * height, length), (row + 1) * height - 0.5));
  return rings;
}

// Voronoi polygons of the centres of squares, each moved by up to 0.3 of a side.
Rings polygons(int rows) {
  const double side = 1.0 / rows;
  const int columns = static_cast<int>(length) * rows;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> shift(-0.3, 0.3);
  std::vector<dda::Vec2> centres;
  for (int i = 0; i < columns * rows; ++i) {
    const int row = i / columns;
    const double x = (i % columns + 0.5 + shift(random)) * side;
    centres.emplace_back(x, (row + 0.5 + shift(random)) * side - 0.5);
  }
  Rings rings;
  for (int i = 0; i < columns * rows; ++i) {
    const dda::Vec2& own = centres[static_cast<std::size_t>(i)];
    dda::Ring ring = box(0, -0.5, length, 0.5);
    for (int row = std::max(0, i / columns - 2); row <= std::min(rows - 1, i / columns + 2); ++row)
      for (int column = std::max(0, i % columns - 2); column <= std::min(columns - 1, i % columns + 2); ++column)
        if (const int other = row * columns + column; other != i)
          ring = nearer_part(ring, own, centres[static_cast<std::size_t>(other)]);
    rings.push_back(ring);
  }
  return rings;
}

// Plane strain is plane stress with E/(1 - nu^2) and nu/(1 - nu).
exact::Cantilever beam_of(double poisson) {
  return {length, 1, young / (1 - poisson * poisson), poisson / (1 - poisson), 2000};
}

double deflection_of(const Rings& rings, double poisson, Outcome& outcome) {
  const exact::Cantilever beam = beam_of(poisson);
  dda::Model model = bonded_beam(rings, {"rock", 2000, young, poisson, dda::PlaneState::strain});
  load_free_end(beam, load, model);
  load_held_end(beam, load, model);
  keep_in_place(beam, model);
  return working_deflection(std::move(model), load, outcome);
}

struct Mesh {
  const char* name;
  Rings (*rings)(int rows);
  bool shows_order;  // the error of bricks changes its sign between 8 and 16 courses
};

void add_deflection(const Mesh& mesh, double poisson, Outcome& outcome) {
  const double expected = exact::deflection_with_shear(beam_of(poisson), load);
  const auto error = [&](int rows) {
    return relative_error(deflection_of(mesh.rings(rows), poisson, outcome), expected);
  };
  const double coarse = error(8);
  const double fine = error(16);
  const Expectation deflection =
      expect(fmt::format("working deflection, 16 {} across, nu = {}", mesh.name, poisson), "m")
          .is(expected * (1 + fine))
          .against(expected,
                   "P L^3/(3 E' I) + 1.2 P L/(G A), E' = E/(1 - nu^2): exact for the end tractions of two-dimensional "
                   "elasticity")
          .off_by(fine);
  const Order order = {std::log2(coarse / fine), 2, 0.3};
  outcome.assertions.push_back(
      (mesh.shows_order ? deflection.of_order(order) : deflection)
          .within(2e-3, "measured 1.7e-3 at most; a mesh that locks is 10 to 60 % too stiff at nu = 0.499"));
}

Outcome deflection() {
  Outcome outcome;
  for (const Mesh& mesh :
       {Mesh{"squares", squares, true}, Mesh{"bricks", bricks, false}, Mesh{"Voronoi polygons", polygons, true}})
    for (const double poisson : {0.25, 0.45, 0.49, 0.499}) add_deflection(mesh, poisson, outcome);
  return outcome;
}

}  // namespace

std::vector<Case> incompressible_cases() {
  return {{"cantilever-incompressible",
           "Beam of bonded blocks in plane strain: nearly incompressible rock does not lock",
           {27},
           CaseLabel::fast,
           deflection}};
}

}  // namespace verify
