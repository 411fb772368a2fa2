// Rings of blocks around a hole that a stage builds, and linings in rings that bear stress already, by lot. Oracles
// that know nothing of joints: Lame's thick ring; and, as all that happens is elastic, the sum of what each load does
// alone.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "engine/app/random_rock_test_support.h"
#include "engine/scene/scene.h"
#include "engine/simulation/simulation.h"
#include "engine/simulation/stopped_run_test_support.h"

namespace dda {
namespace {

using nlohmann::json;

struct Rings {
  int sectors, rings;
  double young, poisson;
  std::vector<double> radii;
  json joint;

  [[nodiscard]] Vec2 corner(int sector, double radius) const {
    const double angle = 2 * std::numbers::pi * sector / sectors;
    return {radius * std::cos(angle), radius * std::sin(angle)};
  }
};

Rings rings_by_lot(RockByLot& lot, bool dry) {
  Rings rings;
  rings.sectors = 4 * static_cast<int>(lot.between(5, 11));
  rings.rings = static_cast<int>(lot.between(4, 9));
  rings.young = std::pow(10, lot.between(9, 11));
  rings.poisson = lot.between(0, 0.4);
  rings.radii = {lot.between(0.5, 3)};
  for (int i = 0; i < rings.rings; ++i)
    rings.radii.push_back(rings.radii.back() * (1 + 2 * std::numbers::pi / rings.sectors));
  rings.joint = {{"friction_angle", fmt::format("{:.2f} deg", lot.between(45, 65))}};
  if (!dry) rings.joint.update({{"cohesion", rings.young}, {"tensile_strength", rings.young}});
  return rings;
}

// The blocks of the rings from one to the one before another, the innermost first.
json blocks_of(const Rings& rings, int first_ring, int end_ring) {
  json blocks = json::array();
  for (int ring = first_ring; ring < end_ring; ++ring)
    for (int i = 0; i < rings.sectors; ++i) {
      json corners = json::array();
      const auto add = [&](int sector, std::size_t radius) {
        const Vec2 at = rings.corner(sector, rings.radii[radius]);
        corners.push_back({at.x(), at.y()});
      };
      const auto inner = static_cast<std::size_t>(ring);
      add(i, inner);
      add(i, inner + 1);
      add(i + 1, inner + 1);
      add(i + 1, inner);
      blocks.push_back({{"polygon",
                         {{"name", fmt::format("b {}.{}", ring, i)},
                          {"group", fmt::format("ring {}", ring)},
                          {"vertices", corners}}}});
    }
  return blocks;
}

json pressure_on_face(const Rings& rings, int ring, int sector, std::size_t radius, double pressure) {
  const Vec2 from = rings.corner(sector, rings.radii[radius]), to = rings.corner(sector + 1, rings.radii[radius]);
  return {{"edge", {{"from", {from.x(), from.y()}}, {"to", {to.x(), to.y()}}}},
          {"block", fmt::format("b {}.{}", ring, sector)},
          {"pressure", pressure}};
}

// On the outer face.
json pressure_on(const Rings& rings, double pressure, const char* from_stage) {
  json loads = json::array();
  for (int i = 0; i < rings.sectors; ++i) {
    loads.push_back(pressure_on_face(rings, rings.rings - 1, i, rings.radii.size() - 1, pressure));
    loads.back()["from_stage"] = from_stage;
  }
  return loads;
}

// Nothing moves sideways along four rays, where that is held so that the rings stay in their place.
json held_sideways(const Rings& rings) {
  json supports = json::array();
  for (int quarter = 0; quarter < 4; ++quarter) {
    const int sector = quarter * rings.sectors / 4;
    const Vec2 point = rings.corner(sector, rings.radii.back());
    supports.push_back({{"point", {point.x(), point.y()}},
                        {"block", fmt::format("b {}.{}", rings.rings - 1, sector)},
                        {"hold", quarter % 2 == 0 ? "y" : "x"}});
  }
  return supports;
}

json square(const std::string& name, double left) {
  const json corners = {{left, 0}, {left + 1, 0}, {left + 1, 1}, {left, 1}};
  return {{"polygon", {{"name", name}, {"vertices", corners}}}};
}

constexpr std::size_t building = 3, stages = 5;

// The first rings come in with the fourth of five stages where they are `added`. In the two before, blocks far off do:
// what is followed is measured anew then, and moves by the square of what its geometry has changed.
json scene_of(const Rings& rings, int added, const char* kinematics) {
  json steps = json::array();
  for (const char* name : {"before", "far off", "further off", "build", "after"})
    steps.push_back({{"name", name}, {"integrator", "static"}, {"kinematics", kinematics}});
  json blocks = blocks_of(rings, 0, rings.rings);
  const double far = 3 * rings.radii.back();
  for (const char* name : {"far off", "further off", "held"})
    blocks.push_back(square(name, far + 3 * static_cast<double>(blocks.size())));
  steps[1]["add"] = {"far off"};
  steps[2]["add"] = {"further off"};
  for (int ring = 0; ring < added; ++ring) steps[building]["add"].push_back(fmt::format("ring {}", ring));
  return {{"dda", 1},
          {"plane", "strain"},
          {"materials", {{"rock", {{"density", 2600}, {"young", rings.young}, {"poisson", rings.poisson}}}}},
          {"joints", {{"default", rings.joint}}},
          {"blocks", blocks},
          {"fixed", {"held"}},
          {"supports", held_sideways(rings)},
          {"loads", json::array()},
          {"steps", steps}};
}

Simulation simulation_of(const json& scene) { return Simulation(parse_scene(scene.dump(), "rings")); }

// By how far the inner wall comes in, m, in the middle of its faces.
double closure(const Rings& rings, const Simulation& run) {
  double sum = 0;
  for (int i = 0; i < rings.sectors; ++i) {
    const Vec2 middle = (rings.corner(i, rings.radii[0]) + rings.corner(i + 1, rings.radii[0])) / 2;
    sum -= point_displacement(run.model(), run.state(), i, middle).dot(middle.normalized());
  }
  return sum / rings.sectors;
}

// Plane strain, pressure from outside alone.
double lame(const Rings& rings, double pressure) {
  const double a = rings.radii.front(), b = rings.radii.back();
  return pressure * a * (1 - rings.poisson * rings.poisson) / rings.young * 2 * b * b / (b * b - a * a);
}

// What blocks of one strain each are off by: 12/n^2 with n around the hole, as it falls with their size squared.
double tolerance(const Rings& rings) { return 16.0 / (rings.sectors * rings.sectors); }

template <typename Body>
void for_each_kind(Body body) {
  for (const bool dry : {true, false})
    for (const char* kinematics : {"small", "finite"})
      for (int seed = 1; seed <= 8; ++seed) {
        SCOPED_TRACE(fmt::format("{} {} seed {}", dry ? "dry" : "glued", kinematics, seed));
        RockByLot lot(seed);
        const Rings rings = rings_by_lot(lot, dry);
        body(rings, kinematics, rings.young * std::pow(10, lot.between(-6, -4)));
      }
}

TEST(AddedRings, ComeInAsLameSays) {
  for_each_kind([](const Rings& rings, const char* kinematics, double pressure) {
    for (const int added : {0, rings.rings}) {
      json scene = scene_of(rings, added, kinematics);
      scene["loads"] = pressure_on(rings, pressure, "after");
      Simulation run = simulation_of(scene);
      run_to_stage(run, stages);
      EXPECT_NEAR(closure(rings, run) / lame(rings, pressure), 1, tolerance(rings)) << (added > 0 ? "added" : "there");
    }
  });
}

// What a second pressure does to rings whose innermost came in under the first, after no more than building moved them;
// `inside` presses the wall that they come to lie on from the start, and goes on between it and them, as water does. In
// finite kinematics strains of up to 1e-3 change places and lengths by as much.
void expect_pressed_by_what_comes(const Rings& rings, const char* kinematics, double pressure, double inside) {
  const int lining = rings.rings / 2;
  json scene = scene_of(rings, lining, kinematics);
  scene["loads"] = pressure_on(rings, pressure, "before");
  for (const json& load : pressure_on(rings, pressure / 2, "after")) scene["loads"].push_back(load);
  for (int i = 0; i < rings.sectors && inside > 0; ++i)
    scene["loads"].push_back(pressure_on_face(rings, lining, i, static_cast<std::size_t>(lining), inside));
  Simulation lined = simulation_of(scene);
  run_to_stage(lined, building);
  const std::vector<Vec6> stressed = lined.state().displacement;
  run_to_stage(lined, building + 1);
  const std::vector<Vec6> built = lined.state().displacement;
  run_to_stage(lined, stages);
  json alone = scene_of(rings, 0, kinematics);
  alone["loads"] = pressure_on(rings, pressure / 2, "after");
  Simulation other = simulation_of(alone);
  run_to_stage(other, stages);
  double moved_by_building = 0, difference = 0, largest = 0;
  for (std::size_t i = 0; i < built.size(); ++i) {
    const Vec6& expected = other.state().displacement[i];
    moved_by_building = std::max(moved_by_building, (built[i] - stressed[i]).head<2>().norm());
    difference = std::max(difference, (lined.state().displacement[i] - built[i] - expected).head<2>().norm());
    largest = std::max(largest, expected.head<2>().norm());
  }
  const bool is_small = kinematics == std::string("small");
  EXPECT_LT(moved_by_building, (is_small ? 1e-9 : 1e-8) * largest);
  EXPECT_LT(difference, (is_small ? 1e-8 : 3e-3) * largest);
}

TEST(AddedRings, AreALiningThatOnlyWhatComesPresses) {
  for_each_kind([](const Rings& rings, const char* kinematics, double pressure) {
    expect_pressed_by_what_comes(rings, kinematics, pressure, 0);
  });
}

TEST(AddedRings, AreNotPressedByWaterThatWasThereBefore) {
  for_each_kind([](const Rings& rings, const char* kinematics, double pressure) {
    expect_pressed_by_what_comes(rings, kinematics, pressure, 0.3 * pressure);
  });
}

}  // namespace
}  // namespace dda
