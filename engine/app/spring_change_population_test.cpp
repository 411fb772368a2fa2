// Stages that change springs of joints and the density of the rock, on stressed rock cut at random. Oracles that do not
// share the change: the same rock without one, the rock with the new springs under the new weight alone (what is linear
// adds up), a branch, and the run that was not stopped.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "engine/app/random_rock_test_support.h"
#include "engine/scene/scene.h"
#include "engine/simulation/branch.h"
#include "engine/simulation/memory_test_support.h"
#include "engine/simulation/simulation.h"
#include "engine/simulation/stopped_run_test_support.h"

namespace dda {
namespace {

using nlohmann::json;

constexpr int seeds = 16;  // of each kind
constexpr int settling = 60, moving = 25;
constexpr double density = 2600;  // of random_rock_test_support.h

// A joint, and its springs by a factor.
struct Kind {
  RockKind rock;
  json (*springs)(double factor);
};

// NOLINTNEXTLINE(readability-identifier-naming): gtest's
void PrintTo(const Kind& kind, std::ostream* out) { *out << kind.rock.name; }

json by_young(double factor) { return {{"spring_over_young", 10 * factor}}; }
json by_contact(double factor) { return {{"normal_spring", 3e11 * factor}, {"shear_to_normal", 0.3 * factor}}; }
json by_area(double factor) { return {{"normal_stiffness", 4e11 * factor}, {"shear_stiffness", 1.5e11 / factor}}; }

json joint_with(json strength, const json& springs) {
  strength.update(springs);
  return strength;
}

const json bonded = {{"bonded", true}, {"law", "classical"}};
const json rough = {{"friction_angle", "55 deg"}};
const json strong = {{"friction_angle", "35 deg"}, {"cohesion", "30 MPa"}, {"tensile_strength", "30 MPa"}};
const json strong_springs = joint_with(strong, {{"law", "classical"}});

const json projected = joint_with(rough, {{"law", "projected"}});

const Kind kinds[] = {{{"bonded", joint_with(bonded, by_area(1)), "small"}, by_area},
                      {{"bonded_moving", joint_with(bonded, by_young(1)), "finite"}, by_young},
                      {{"dry", joint_with(rough, by_contact(1)), "finite"}, by_contact},
                      {{"dry_by_area", joint_with(rough, by_area(1)), "finite"}, by_area},
                      {{"dry_as_drawn", joint_with(rough, by_young(1)), "small"}, by_young},
                      {{"strong", joint_with(strong_springs, by_area(1)), "finite"}, by_area},
                      {{"strong_as_drawn", joint_with(strong_springs, by_contact(1)), "small"}, by_contact},
                      {{"projected", joint_with(projected, by_area(1)), "finite"}, by_area},
                      {{"projected_as_drawn", joint_with(projected, by_area(1)), "small"}, by_area}};

json settle(const RockKind& kind) {
  return {{"name", "settle"},        {"integrator", "static"},        {"dt", 1},
          {"duration", settling},    {"equilibrium", 1e-13},          {"on_unbalanced", "continue"},
          {"strength", "unlimited"}, {"kinematics", kind.kinematics}, {"solver", "cholesky"}};
}

// The rock settles, then moves in two stages.
json scene_of(int seed, const RockKind& kind) {
  json scene = scene_with_opening(seed, kind, false,
                                  {settle(kind), motion_of(kind, "changed", moving), motion_of(kind, "after", moving)});
  scene["gravity"] = 10;
  return scene;
}

json with_change(json scene, std::size_t stage, const json& springs, double of_density = 0) {
  if (!springs.is_null()) scene["steps"][stage]["joints"]["default"] = springs;
  if (of_density > 0) scene["steps"][stage]["materials"]["rock"]["density"] = of_density;
  return scene;
}

Model model_of(const json& scene) { return parse_scene(scene.dump(), "scene"); }

double largest(const std::vector<Vec6>& displacement, const std::vector<Vec6>* less = nullptr) {
  double most = 0;
  for (std::size_t i = 0; i < displacement.size(); ++i)
    most = std::max(most, Vec6(displacement[i] - (less != nullptr ? (*less)[i] : Vec6::Zero())).head<2>().norm());
  return most;
}

// By lot, so that all of a population differ.
double factor_of(int seed) { return RockByLot(100 + seed).between(0.2, 4); }

class ChangedSpringsOfRock : public testing::TestWithParam<Kind> {};

TEST_P(ChangedSpringsOfRock, MoveAsBeforeWhereNothingIsOther) {
  for (int seed = 1; seed <= seeds; ++seed) {
    SCOPED_TRACE(seed);
    const json scene = scene_of(seed, GetParam().rock);
    Simulation plain(model_of(scene)), same(model_of(with_change(scene, 1, GetParam().springs(1), density)));
    run_to_stage(plain, 1);
    run_to_stage(same, 1);
    EXPECT_EQ(same.state().velocity, plain.state().velocity);
    while (!plain.finished()) {
      ASSERT_EQ(plain.step(), Status::ok) << plain.message();
      ASSERT_EQ(same.step(), Status::ok) << same.message();
      ASSERT_EQ(same.state().displacement, plain.state().displacement) << plain.state().step;
    }
    EXPECT_EQ(same.state().velocity, plain.state().velocity);
    EXPECT_EQ(same.state().stress, plain.state().stress);
    EXPECT_EQ(same.energy().external_work, plain.energy().external_work);
  }
}

// Rock at rest stays, whatever its springs become. Gaps that count from a place are as good as places are, to a few of
// the last digits of 6 m, and add up along a row of blocks: 4e-14 m.
TEST_P(ChangedSpringsOfRock, MoveNothing) {
  for (int seed = 1; seed <= seeds; ++seed) {
    SCOPED_TRACE(seed);
    const json scene = scene_of(seed, GetParam().rock);
    Simulation plain(model_of(scene)), changed(model_of(with_change(scene, 1, GetParam().springs(factor_of(seed)))));
    run_to_stage(plain, 1);
    run_to_stage(changed, 1);
    const std::vector<Vec6> settled = changed.state().displacement;
    run_to_stage(plain, 3);
    run_to_stage(changed, 3);
    const double moved = largest(changed.state().displacement, &settled);
    EXPECT_LT(moved, 1e-9 * largest(settled) + 2 * largest(plain.state().displacement, &settled) + 1e-13);
  }
}

TEST_P(ChangedSpringsOfRock, GoOnToTheSameBitsAndBalanceTheirEnergy) {
  for (int seed = 1; seed <= seeds; ++seed) {
    SCOPED_TRACE(seed);
    const Model model = model_of(
        with_change(with_change(scene_of(seed, GetParam().rock), 1, GetParam().springs(factor_of(seed)), 1.7 * density),
                    2, GetParam().springs(1), 0.6 * density));
    Simulation whole(model);
    expect_same_when_stopped(model, 1, (7 * seed) % (2 * moving), whole);
  }
}

// The other run changes its rock in the stage after.
TEST_P(ChangedSpringsOfRock, CanBeABranch) {
  for (int seed = 1; seed <= seeds; seed += 3) {
    SCOPED_TRACE(seed);
    const json plain = scene_of(seed, GetParam().rock);
    const json springs = GetParam().springs(factor_of(seed));
    const Model changed = model_of(with_change(with_change(plain, 1, springs, 2 * density), 2, springs, density));
    const Model other = model_of(with_change(with_change(plain, 1, springs, 2 * density), 2, springs, 3 * density));
    for (const std::size_t stage : {1U, 2U}) {
      Simulation between(other), branch(changed), whole(changed);
      bring_between_stages(other, stage, between);
      begin_from(between, branch);
      run_to_stage(whole, 3);
      run_to_stage(branch, 3);
      EXPECT_EQ(memory_of(branch), memory_of(whole));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Joints, ChangedSpringsOfRock, testing::ValuesIn(kinds),
                         [](const auto& kind) { return std::string(kind.param.rock.name); });

// What bonded rock does from the change on is what rock of the new springs does under the weight that has come,
// whatever happened before: superposition.
TEST(ChangedSpringsOfBondedRock, MoveAsRockOfTheNewSpringsUnderTheNewWeight) {
  for (int seed = 1; seed <= seeds; ++seed) {
    SCOPED_TRACE(seed);
    const Kind& kind = kinds[0];
    const double factor = factor_of(seed);
    json scene = scene_of(seed, kind.rock);
    json second = settle(kind.rock);
    second["name"] = "heavier";
    scene["steps"] = {settle(kind.rock), second};
    Simulation changed(model_of(with_change(scene, 1, kind.springs(factor), 2.5 * density)));
    run_to_stage(changed, 1);
    const std::vector<Vec6> before = changed.state().displacement;
    run_to_stage(changed, 2);
    json alone = scene;
    alone.erase("stress_field");
    alone["joints"]["default"] = joint_with(bonded, kind.springs(factor));
    alone["materials"]["rock"]["density"] = 1.5 * density;
    alone["steps"] = {settle(kind.rock)};
    Simulation fresh(model_of(alone));
    run_to_stage(fresh, 1);
    std::vector<Vec6> difference = changed.state().displacement;
    for (std::size_t i = 0; i < before.size(); ++i) difference[i] -= before[i];
    const double most = largest(fresh.state().displacement);
    EXPECT_GT(most, 1e-6);
    EXPECT_LT(largest(difference, &fresh.state().displacement), 1e-9 * most);
  }
}

// Joints that are free of force where they carry 3 MPa, and carry a third of that and a shear: seen from where the new
// springs would carry 3 MPa they lie open, which says nothing of what they do. The shear of 1e-5 m in each of two
// joints was counted twice as soon as a load moved the blocks.
TEST(ChangedSpringsOfRock, KeepTheirShearWhereMostOfTheInSituStressIsGone) {
  const json grid = {{"name", "g"}, {"columns", 3}, {"rows", 3}, {"block_width", 1}, {"block_height", 1}};
  const json joint = joint_with(projected, {{"normal_stiffness", 5e9}, {"shear_stiffness", 2e9}});
  const json still = {{"integrator", "static"}, {"dt", 1}, {"duration", 20}, {"kinematics", "finite"}};
  json stiffer = still;
  stiffer["joints"]["default"] = {{"normal_stiffness", 25e9}, {"shear_stiffness", 2e9}};
  const json pressed_more = {{"edge", "top"}, {"traction", {0, "-0.5 MPa"}}, {"from_stage", "stage 3"}};
  const json scene = {{"dda", 1},
                      {"materials", {{"rock", {{"density", density}, {"young", "20 GPa"}, {"poisson", 0.2}}}}},
                      {"joints", {{"default", joint}}},
                      {"blocks", {{"grid", grid}}},
                      {"supports", {{{"edge", "bottom"}, {"hold", "xy"}}}},
                      {"stress_field", {{"xx", 0}, {"yy", "-3 MPa"}}},
                      {"loads", {{{"edge", "top"}, {"traction", {"0.02 MPa", "-1 MPa"}}}, pressed_more}},
                      {"steps", {still, stiffer, still}}};
  Simulation simulation(model_of(scene));
  run_to_stage(simulation, 1);
  const std::vector<Vec6> settled = simulation.state().displacement;
  run_to_stage(simulation, 2);
  EXPECT_LT(largest(simulation.state().displacement, &settled), 1e-9 * largest(settled));
  while (!simulation.finished()) ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
  const Vec6 more = simulation.state().displacement[7] - settled[7];  // of the block in the middle of the top
  EXPECT_LT(more(1), -5e-5);
  EXPECT_LT(std::abs(more(0)), 1e-6);
}

}  // namespace
}  // namespace dda
