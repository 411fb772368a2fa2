#include "verification/cases/incompressible_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <random>
#include <utility>

#include "verification/cases/contact_rig.h"
#include "verification/exact/cantilever.h"
#include "verification/harness/recorded_run.h"
#include "verification/lattice/periodic_mesh.h"

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

dda::Model bonded_blocks(const Rings& rings, double poisson) {
  dda::Model model;
  model.materials = {{"rock", 2000, young, poisson, dda::PlaneState::strain}};
  dda::JointMaterial joint;
  joint.law = dda::InterfaceLaw::consistent;
  joint.bonded = true;
  model.joints = {joint};
  for (const dda::Ring& ring : rings) model.blocks.emplace_back().shape.outer = ring;
  return model;
}

// Plane strain is plane stress with E/(1 - nu^2) and nu/(1 - nu).
exact::Cantilever beam_of(double poisson) {
  return {length, 1, young / (1 - poisson * poisson), poisson / (1 - poisson), 2000};
}

bool lies_at(double x, const dda::Vec2& from, const dda::Vec2& to) {
  return std::abs(from.x() - x) < 1e-9 && std::abs(to.x() - x) < 1e-9;
}

// The tractions of two-dimensional elasticity at both ends: each edge of a block carries their mean over it.
void load_ends(const exact::Cantilever& beam, dda::Model& model) {
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const dda::Ring& ring = model.blocks[i].shape.outer;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const dda::Vec2& from = ring[k];
      const dda::Vec2& to = ring[(k + 1) % ring.size()];
      const double shear = exact::mean_shear_stress(beam, load, std::min(from.y(), to.y()), std::max(from.y(), to.y()));
      const double fibre = exact::fibre_stress(beam, load, 0, (from.y() + to.y()) / 2);
      if (lies_at(beam.length, from, to)) model.edge_loads.push_back({static_cast<int>(i), from, to, {0, shear}, {}});
      if (lies_at(0, from, to)) model.edge_loads.push_back({static_cast<int>(i), from, to, {-fibre, -shear}, {}});
    }
  }
}

int block_at(const dda::Model& model, const dda::Vec2& corner) {
  for (std::size_t i = 0; i < model.blocks.size(); ++i)
    for (const dda::Vec2& vertex : model.blocks[i].shape.outer)
      if ((vertex - corner).norm() < 1e-9) return static_cast<int>(i);
  return -1;
}

// Three springs that carry no force keep the beam in place.
void keep_in_place(dda::Model& model) {
  const dda::Vec2 foot(0, -0.5);
  const dda::Vec2 head(0, 0.5);
  model.supports = {{block_at(model, foot), foot, true, true, 1e4 * young, dda::Vec2::Zero(), {}},
                    {block_at(model, head), head, true, false, 1e4 * young, dda::Vec2::Zero(), {}}};
}

// Work of loads that do not change, over the load. A static step whose inertia is 1e-10 of the stiffness, twice.
double working_deflection(const Rings& rings, double poisson, Outcome& outcome) {
  dda::Model model = bonded_blocks(rings, poisson);
  load_ends(beam_of(poisson), model);
  keep_in_place(model);
  dda::Stage stage = moving_stage(dda::static_integrator(), 1e3, 2e3);
  stage.kinematics = dda::Kinematics::small;
  model.stages = {stage};
  WatchedRun run(std::move(model));
  run.run_to_end();
  outcome.counters += run.simulation().counters();
  return run.simulation().energy().external_work / load;
}

struct Mesh {
  const char* name;
  Rings (*rings)(int rows);
  bool shows_order;  // the error of bricks changes its sign between 8 and 16 courses
};

void add_deflection(const Mesh& mesh, double poisson, Outcome& outcome) {
  const double expected = exact::deflection_with_shear(beam_of(poisson), load);
  const auto error = [&](int rows) {
    return relative_error(working_deflection(mesh.rings(rows), poisson, outcome), expected);
  };
  const double coarse = error(8);
  const double fine = error(16);
  const auto order = mesh.shows_order ? std::optional(Order{std::log2(coarse / fine), 2, 0.3}) : std::nullopt;
  outcome.assertions.push_back(
      {fmt::format("working deflection, 16 {} across, nu = {}", mesh.name, poisson), "m", expected * (1 + fine),
       expected,
       "P L^3/(3 E' I) + 1.2 P L/(G A), E' = E/(1 - nu^2): exact for the end tractions of two-dimensional elasticity",
       fine, 2e-3, "measured 1.7e-3 at most; a mesh that locks is 10 to 60 % too stiff at nu = 0.499", order});
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
