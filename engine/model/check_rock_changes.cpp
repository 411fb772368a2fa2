// What a stage may change of the rock, and what not.
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/core/error.h"
#include "engine/model/check_parts.h"
#include "engine/model/checks.h"
#include "engine/model/rock_change.h"

namespace dda::model_checks {
namespace {

// Joints hold by a penalty of so many moduli of the rock at the start, which must stay above one modulus: half of it is
// what every block's neighbours leave it.
constexpr double share_of_penalty = 0.5;

// Joints keep the stiffness of the start: softer blocks beside them leave less than seven of the sixteen digits that
// numbers have.
constexpr double least_growth = 1e-9;

void expect_same(bool same, const Item& item, std::string_view member) {
  if (!same)
    item.fail(member, "changed by a stage", "what it was: stages change the strength and the springs of joints alone");
}

// What a force stores in a spring goes by one over its stiffness, and weight by the density: further away numbers have
// too few digits beside those of the rest.
void check_ratio(const Item& item, std::string_view member, double before, double now) {
  constexpr double least = least_growth, most = 1 / least_growth;
  if (before == 0 || now == 0 || (now >= least * before && now <= most * before)) return;
  item.fail(member, fmt::format("{:.3g} times what it was", now / before),
            fmt::format("from {:g} to {:g} times that", least, most));
}

bool is_projected(const JointMaterial& joint) { return joint.law == InterfaceLaw::projected && !joint.bonded; }

double shear_stiffness_share(const JointMaterial& joint) {
  return joint.shear_stiffness > 0 ? joint.shear_stiffness : joint.shear_to_normal;
}

// Which contacts of a face have springs goes by what their stiffness goes by; and a force needs a spring that bears it.
void check_springs(const Item& item, const JointMaterial& before, const JointMaterial& now) {
  if (have_same_springs(before, now)) return;
  check_ratio(item, "normal stiffness", before.normal_stiffness, now.normal_stiffness);
  check_ratio(item, "shear stiffness", before.shear_stiffness, now.shear_stiffness);
  check_ratio(item, "normal spring", before.normal_spring, now.normal_spring);
  check_ratio(item, "spring over Young's modulus", before.spring_over_young, now.spring_over_young);
  check_ratio(item, "shear to normal spring", before.shear_to_normal, now.shear_to_normal);
  expect_same(springs_go_by_length(before) == springs_go_by_length(now), item, "kind of stiffness");
  if (is_projected(before))
    expect_same((before.normal_stiffness > 0) == (now.normal_stiffness > 0), item, "kind of stiffness");
  if (shear_stiffness_share(before) > 0 && shear_stiffness_share(now) == 0)
    item.fail("shear stiffness", "0 in a stage", "above 0, as before: what the joint carries would be lost");
}

// What is unpacked and not looked at may change, but for springs, which have a check of their own.
void check_change(const Item& item, const JointMaterial& before, const JointMaterial& now) {
  const auto& [name, law, bonded, friction_angle, cohesion, tensile_strength, residual_friction_angle,
               residual_cohesion, dilation_angle, zero_dilation_slip, normal_spring, spring_over_young, shear_to_normal,
               normal_stiffness, shear_stiffness, automatic_stiffness, contact_damping, penalty, stabilisation] = now;
  expect_same(name == before.name, item, "name");
  expect_same(law == before.law && bonded == before.bonded, item, "law");
  expect_same(dilation_angle == before.dilation_angle && zero_dilation_slip == before.zero_dilation_slip, item,
              "dilation");
  check_springs(item, before, now);
  expect_same(penalty == before.penalty && stabilisation == before.stabilisation, item, "penalty");
  if (is_dry(before) && !is_dry(now))
    item.fail("strength", "given cohesion or tensile strength by a stage",
              "none, as before: what is dry has no bond that could become stronger");
  if ((before.residual_cohesion > 0) != (residual_cohesion > 0))
    item.fail("residual cohesion",
              fmt::format("{} Pa in a stage, {} Pa before", residual_cohesion, before.residual_cohesion),
              "a positive one in both, or none in either");
}

void check_change(const Item& item, const Material& before, const Material& now) {
  if (now.name != before.name || now.plane != before.plane)
    item.fail("name or plane", "changed by a stage", "what it was: stages change moduli and densities");
  check_ratio(item, "density", before.density, now.density);
}

void check_growth(const Item& item, const ModulusLimits& limits, const Material& start, const Material& now) {
  if (const auto problem = problem_of_growth(limits, modulus_growth(start, now)))
    item.fail("Young's modulus", problem->first, problem->second);
}

void check_sizes(std::size_t now, std::size_t before) {
  if (now != before)
    throw InputError("", "rock", fmt::format("of {} entries", now), fmt::format("{}, as the model", before));
}

void check_joints_of(const Model& model, std::size_t stage) {
  const std::vector<JointMaterial>& before = joints_in(model, stage - 1);
  const std::vector<JointMaterial>& now = model.stages[stage].rock.joints;
  check_strengths(now);
  check_sizes(now.size(), before.size());
  for (std::size_t i = 0; i < now.size(); ++i) check_change(Item("joints", i, now[i].name), before[i], now[i]);
}

void check_materials_of(const Model& model, std::size_t stage) {
  const std::vector<Material>& before = materials_in(model, stage - 1);
  const std::vector<Material>& now = model.stages[stage].rock.materials;
  check_materials(now);
  check_sizes(now.size(), before.size());
  for (std::size_t i = 0; i < now.size(); ++i) {
    check_change(Item("materials", i, now[i].name), before[i], now[i]);
    check_growth(Item("materials", i, now[i].name), modulus_limits(model), materials_in(model, 0)[i], now[i]);
  }
}

void refuse_beside(const Model& model, std::size_t stage) {
  const RockOfStage& rock = model.stages[stage].rock;
  const Item item("stages", stage, model.stages[stage].name);
  if (!model.free_field_sides.empty())
    item.fail("rock", "changed beside free-field sides", "the same in all stages: their columns do not change");
  const bool has_other_moduli =
      !rock.materials.empty() && !std::ranges::equal(materials_in(model, stage - 1), rock.materials, have_same_moduli);
  if (has_other_moduli && std::ranges::any_of(model.joints, is_projected))
    item.fail("moduli", "changed beside projected joints",
              "the same in all stages, or joints of another law: what projected joints take off their blocks goes by "
              "the modulus at the start");
}

// A joint or material may be changed by many stages: what is refused says by which.
template <typename Check>
void in_stage(const Model& model, std::size_t stage, Check check) {
  try {
    check(model, stage);
  } catch (const InputError& error) {
    Item("stages", stage, model.stages[stage].name).fail(error.field(), error.value(), error.expected());
  }
}

}  // namespace

ModulusLimits modulus_limits(const Model& model) {
  ModulusLimits limits{least_growth, std::numeric_limits<double>::infinity()};
  for (const JointMaterial& joint : joints_in(model, 0))
    if (joint.law != InterfaceLaw::classical && (limits.penalty == 0 || joint.penalty < limits.penalty))
      limits.penalty = joint.penalty;
  if (limits.penalty > 0) limits.most = share_of_penalty * limits.penalty;
  return limits;
}

double modulus_growth(const Material& start, const Material& now) {
  return elasticity_matrix(now)(0, 0) / elasticity_matrix(start)(0, 0);
}

std::optional<std::pair<std::string, std::string>> problem_of_growth(const ModulusLimits& limits, double growth) {
  if (growth >= limits.least && growth <= limits.most) return std::nullopt;
  const std::string found = fmt::format("{:.3g} times as stiff as at the start", growth);
  if (growth > limits.most)
    return std::pair{found, fmt::format("at most {:g} times: joints hold by a penalty of {:g} moduli of the start",
                                        limits.most, limits.penalty)};
  return std::pair{found, fmt::format("at least {:g} times, as joints keep the stiffness of the start", limits.least)};
}

void check_rock_changes(const Model& model) {
  for (std::size_t i = 1; i < model.stages.size(); ++i) {
    const RockOfStage& rock = model.stages[i].rock;
    if (rock.materials.empty() && rock.joints.empty()) continue;
    refuse_beside(model, i);
    if (!rock.joints.empty()) in_stage(model, i, check_joints_of);
    if (!rock.materials.empty()) in_stage(model, i, check_materials_of);
  }
}

}  // namespace dda::model_checks
