// Rock cut at random with an opening of random shape that is removed, and whose wall is lined afterwards: thirty seeds
// of each kind. What the lining reports must be what acts on the blocks, and the ledger must close.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "engine/geometry/segment.h"
#include "engine/scene/scene.h"
#include "engine/simulation/block_system.h"
#include "engine/simulation/run_so_far.h"
#include "engine/simulation/simulation.h"

namespace dda {
namespace {

using nlohmann::json;

constexpr int seeds = 30;

struct Kind {
  const char* name;
  json joint;
  const char* kinematics;
  bool yields;
};

const Kind kinds[] = {{"bonded", {{"bonded", true}}, "small", false},
                      {"bonded, weak concrete", {{"bonded", true}}, "small", true},
                      {"dry", {{"friction_angle", "35 deg"}}, "finite", false},
                      {"dry, weak concrete", {{"friction_angle", "35 deg"}}, "finite", true}};

json wall(double left, double bottom, double right, double top) {
  return {{"polygon",
           {{"name", fmt::format("wall {} {}", left, bottom)},
            {"group", "walls"},
            {"vertices", {{left, bottom}, {right, bottom}, {right, top}, {left, top}}}}}};
}

// A polygon around the middle whose corners lie as far from it as chance has it.
json shape_of(int seed, std::mt19937_64& random) {
  std::uniform_real_distribution<double> share(0, 1);
  const double x = 2.7 + 0.6 * share(random);
  if (seed % 3 == 0) return {"circle", {{"centre", {x, 3}}, {"radius", 0.8 + 0.5 * share(random)}}};
  if (seed % 3 == 1)
    return {"horseshoe", {{"foot", {x, 2}}, {"width", 1.6 + share(random)}, {"height", 2 + 0.2 * share(random)}}};
  json corners = json::array();
  const int count = 5 + static_cast<int>(4 * share(random));
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * M_PI * (i + 0.3 * share(random)) / count;
    const double radius = 0.9 + 0.5 * share(random);
    corners.push_back({x + radius * std::cos(angle), 3 + radius * std::sin(angle)});
  }
  return {"polygon", corners};
}

Model model_of(int seed, const Kind& kind) {
  std::mt19937_64 random(static_cast<unsigned>(seed));
  std::uniform_real_distribution<double> share(0, 1);
  const auto set = [&](double low, double high) {
    return json{
        {"dip", {{"mean", fmt::format("{:.3f} deg", low + (high - low) * share(random))}, {"deviation", "4 deg"}}},
        {"spacing", {{"mean", 0.7 + 0.5 * share(random)}, {"deviation", 0.2}}},
        {"joint", "default"}};
  };
  const json shape = shape_of(seed, random);
  const json opening = {{"name", "opening"}, {shape[0].get<std::string>(), shape[1]}};
  const json rock = {{"boundary", {{0, 0}, {6, 0}, {6, 6}, {0, 6}}},
                     {"joint_sets", {set(20, 80), set(-60, 10)}},
                     {"openings", {opening}},
                     {"seed", seed},
                     {"merge", {{"area", 0.02}, {"angle", "8 deg"}}}};
  json lining = {
      {"name", "shotcrete"}, {"opening", "opening"}, {"thickness", 0.1}, {"young", 15e9}, {"from_stage", "lined"}};
  if (kind.yields) lining["compressive_strength"] = 5e6;
  if (kind.yields) lining["tensile_strength"] = 5e5;
  const json motion = {{"integrator", {{"generalized_alpha", 0.5}}},
                       {"dt", 1e-4},
                       {"kinematics", kind.kinematics},
                       {"solver", "cholesky"}};
  json settle = {
      {"name", "settle"}, {"integrator", "static"}, {"dt", 1}, {"duration", 1}, {"kinematics", kind.kinematics}};
  json opened = motion;
  opened.update({{"name", "opened"}, {"remove", json::array({"opening"})}, {"duration", 5e-4}});
  json lined = motion;
  lined.update({{"name", "lined"}, {"duration", 40e-4}});
  const json scene = {
      {"dda", 1},
      {"materials", {{"rock", {{"density", 2600}, {"young", 20e9}, {"poisson", 0.2}}}}},
      {"joints", {{"default", kind.joint}}},
      {"blocks", {{{"rock", rock}}, wall(-1, -1, 7, 0), wall(-1, 6, 7, 7), wall(-1, 0, 0, 6), wall(6, 0, 7, 6)}},
      {"stress_field", {{"xx", "-6 MPa"}, {"yy", "-8 MPa"}, {"xy", "0.5 MPa"}}},
      {"fixed", json::array({"walls"})},
      {"linings", json::array({lining})},
      {"steps", {settle, opened, lined}}};
  return parse_scene(scene.dump(), fmt::format("seed {}", seed));
}

// Forces of a beam's ends on the two blocks, put together from thrust, moment and shear, against what the balance of
// the blocks has.
void expect_reported_forces_act(const Simulation& simulation, const std::string& name) {
  const BlockSystem& system = simulation.system();
  const Lining& lining = system.model.linings[0];
  Eigen::VectorXd acting = Eigen::VectorXd::Zero(system.forces.internal_old.size());
  system.reinforcement.linings.add_force(acting);
  Eigen::VectorXd reported = Eigen::VectorXd::Zero(acting.size());
  const bool moves = system.geometry_moves();
  double largest = 0, sheared = 0;
  for (std::size_t i = 0; i < lining.elements(); ++i) {
    const SectionForces forces = system.reinforcement.linings.forces(system.model, 0, i);
    const LiningNode& a = lining.start_of(i);
    const LiningNode& b = lining.end_of(i);
    const auto at = [&](const LiningNode& node) -> Vec2 {
      return moves ? current_position(system.model, system.state, node.block, node.point) : node.point;
    };
    const Vec2 along = (at(b) - at(a)).normalized();
    const Vec2 across(-along.y(), along.x());
    const Vec2 drawn = (b.point - a.point).normalized();
    const auto turn = [&](const LiningNode& node) {
      return system.state.displacement[static_cast<std::size_t>(node.block)](2);
    };
    sheared = std::max(sheared, std::abs(std::asin(cross(drawn, along)) - (turn(a) + turn(b)) / 2));
    const Vec2 on_b = forces.thrust * along + forces.shear * across;
    const auto add = [&](const LiningNode& node, const Vec2& force, double moment) {
      const Vec2 centroid = moves ? current_centroid(system.model, system.state, node.block)
                                  : system.model.blocks[static_cast<std::size_t>(node.block)].moments.centroid;
      const Vec2 arm = at(node) - centroid;
      reported.segment<3>(6 * node.block) += Vec3(force.x(), force.y(), moment + cross(arm, force));
    };
    add(b, on_b, -forces.moment_at_end);
    add(a, -on_b, forces.moment_at_start);
    largest = std::max({largest, std::abs(forces.thrust), std::abs(forces.shear)});
  }
  EXPECT_GT(largest, 1e3) << name << ": the rock presses on it";
  for (std::size_t block = 0; block < system.model.blocks.size(); ++block) {
    const auto first = static_cast<Eigen::Index>(6 * block);
    // Where geometry moves, rows are those foreseen for the middle of the last step: blocks of 1 m/s turn elements of
    // 5 cm by 1e-3 until its end. And an element's axis is that of its sections, from which shear turns the straight
    // way between its nodes: by 0.028 in one that is 7 mm long.
    EXPECT_LT((reported.segment<3>(first) + acting.segment<3>(first)).norm(),
              (moves ? 5e-3 + sheared : 1e-10) * largest)
        << name << ", block " << block;
  }
}

TEST(LiningPopulation, RandomOpenings) {
  for (const Kind& kind : kinds) {
    int yielded = 0;
    for (int seed = 1; seed <= seeds; ++seed) {
      const std::string name = fmt::format("{}, seed {}", kind.name, seed);
      Simulation simulation(model_of(seed, kind));
      while (!simulation.finished()) ASSERT_EQ(simulation.step(), Status::ok) << name << ": " << simulation.message();
      EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-9) << name;
      expect_reported_forces_act(simulation, name);
      const auto elements = linings_of(simulation).elements();
      yielded += static_cast<int>(std::ranges::any_of(elements, &LiningElement::has_yielded));
      for (std::size_t i = 0; i < elements.size(); ++i)
        EXPECT_LE(linings_of(simulation).forces(simulation.model(), 0, i).utilisation, 1 + 1e-5) << name;
    }
    EXPECT_EQ(yielded > seeds / 2, kind.yields) << kind.name << ": " << yielded;
  }
}

}  // namespace
}  // namespace dda
