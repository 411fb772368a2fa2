#include "engine/simulation/branch_rule.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "engine/contact/contact_set.h"
#include "engine/contact/joint_stiffness.h"
#include "engine/contact/make_contacts.h"
#include "engine/core/error.h"
#include "engine/model/held_flags.h"
#include "engine/model/law_name.h"
#include "engine/model/rock_change.h"
#include "engine/model/same_history.h"

namespace dda {
namespace {

[[noreturn]] void refuse(const std::string& field, const std::string& value, const std::string& there) {
  throw InputError("", field, value, there + ", as in the run to go on from");
}

void expect(bool same, const std::string& field, const char* what) {
  if (!same) refuse(field, std::string("of another ") + what, std::string("the same ") + what);
}

template <typename Value>
void expect_equal(const Value& then, const Value& now, const std::string& field) {
  if (then != now) refuse(field, fmt::format("{}", now), fmt::format("{}", then));
}

void expect_equal(bool then, bool now, const std::string& field) {
  if (then != now) refuse(field, now ? "true" : "false", then ? "true" : "false");
}

std::string number_or_none(double number) { return number == 0 ? "none" : fmt::format("{}", number); }

// What scenes can leave out.
void expect_equal_or_none(double then, double now, const std::string& field) {
  if (then != now) refuse(field, number_or_none(now), number_or_none(then));
}

void check(const Block& then, const Block& now) {
  const std::string field = fmt::format("block \"{}\"", now.name);
  expect(then.shape.outer == now.shape.outer && then.shape.holes == now.shape.holes, field, "outline");
  expect(then.material == now.material, field, "material");
  expect(then.initial_stress == now.initial_stress, field, "stress at the start");
  expect(then.initial_velocity == now.initial_velocity && then.initial_spin == now.initial_spin &&
             then.initial_strain_rate == now.initial_strain_rate,
         field, "motion at the start");
}

// Stress that goes by the weight of the ground above follows gravity, which is free to differ.
void check_stress(const Model& then, const Model& now) {
  if (then.gravity == now.gravity) return;
  for (std::size_t i = 0; i < std::min(then.blocks.size(), now.blocks.size()); ++i)
    if (then.blocks[i].initial_stress != now.blocks[i].initial_stress)
      throw InputError("", "gravity", "another, and with it the stress at the start",
                       "a stress at the start that is as in the run to go on from: \"stress_field\" with \"gradient\" "
                       "in place of \"density\", which goes by gravity, in both scenes");
}

// What is unpacked in these functions and not compared may differ.
void check(const Material& then, const Material& now) {
  const auto& [name, density, young, poisson, plane] = now;
  const std::string field = "materials." + name;
  expect_equal(then.density, density, field + ".density");
  expect_equal(then.young, young, field + ".young");
  expect_equal(then.poisson, poisson, field + ".poisson");
  expect(then.plane == plane, field, "plane");
}

// A law that nobody gave has a name that nobody wrote.
std::string law_in_words(InterfaceLaw law) {
  return law == InterfaceLaw::cubic ? "that of the scheme" : fmt::format("\"{}\"", law_name(law));
}

// What a scene says of a joint decides about a law that it does not name, so that is compared before.
void check_law(const JointMaterial& then, const JointMaterial& now, const std::string& field) {
  if (then.law == now.law) return;
  if ((then.dilation_angle == 0) != (now.dilation_angle == 0))
    refuse(field + ".dilation_angle", now.dilation_angle == 0 ? "none" : "given",
           std::string(then.dilation_angle == 0 ? "none" : "some") +
               " (joints that dilate have springs from the start, of which others know nothing)");
  refuse(field + ".law", law_in_words(now.law) + " (given, or chosen by what joints and stages say)",
         law_in_words(then.law));
}

std::string with_automatic_stiffness(bool automatic) {
  return std::string(automatic ? "with" : "without") +
         " springs of \"normal_stiffness\": \"auto\" (given, or chosen where no stage has finite kinematics)";
}

void check(const JointMaterial& then, const JointMaterial& now) {
  const auto& [name, law, bonded, friction_angle, cohesion, tensile_strength, residual_friction_angle,
               residual_cohesion, dilation_angle, zero_dilation_slip, normal_spring, spring_over_young, shear_to_normal,
               normal_stiffness, shear_stiffness, automatic_stiffness, contact_damping, penalty, stabilisation] = now;
  const std::string field = "joints." + name;
  expect_equal(then.bonded, bonded, field + ".bonded");
  if (is_dry(then) != is_dry(now))
    refuse(field, is_dry(now) ? "without cohesion and tensile strength" : "with cohesion or tensile strength",
           is_dry(then) ? "none" : "some");
  expect_equal_or_none(then.normal_spring, normal_spring, field + ".normal_spring");
  expect_equal_or_none(then.spring_over_young, spring_over_young, field + ".spring_over_young");
  expect_equal(then.shear_to_normal, shear_to_normal, field + ".shear_to_normal");
  expect_equal_or_none(then.normal_stiffness, normal_stiffness, field + ".normal_stiffness");
  expect_equal_or_none(then.shear_stiffness, shear_stiffness, field + ".shear_stiffness");
  expect_equal_or_none(then.contact_damping, contact_damping, field + ".contact_damping");
  expect_equal(then.penalty, penalty, field + ".penalty");
  expect_equal(stabilisation_of(then), stabilisation.value_or(default_stabilisation), field + ".stabilisation");
  expect_equal(then.stabilisation.has_value(), stabilisation.has_value(), field + ".stabilisation");
  check_law(then, now, field);
  if (then.automatic_stiffness != automatic_stiffness)
    refuse(field, with_automatic_stiffness(automatic_stiffness), with_automatic_stiffness(then.automatic_stiffness));
}

bool are_same(const Integrator& a, const Integrator& b) {
  return a.beta == b.beta && a.gamma == b.gamma && a.alpha_m == b.alpha_m && a.alpha_f == b.alpha_f &&
         a.is_static == b.is_static && a.conserves_contact_energy == b.conserves_contact_energy;
}

bool are_same(const std::optional<TimeFunction>& a, const std::optional<TimeFunction>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return are_same(*a, *b);
}

void check(const Stage& then, const Stage& now, const std::string& field) {
  const auto& [name, dt, duration, integrator, chosen, kinematics, solver, velocity_factor, damping_rate,
               material_damping, strain_inertia, correct_block_dispersion, correct_time_dispersion, lateral_inertia,
               equilibrium, on_unbalanced, unlimited_strength, removal, rock, limits] = now;
  // What the engine chooses for a stage may change with the stages after it, and did its work in those that are done.
  const bool both_chosen = then.chosen.integrator.automatic && chosen.integrator.automatic;
  expect_equal(then.name, name, field + ".name");
  if (!both_chosen || !then.chosen.dt.automatic || !chosen.dt.automatic) {
    expect_equal(then.dt, dt, field + ".dt");
    expect(then.chosen.dt.first_steps == chosen.dt.first_steps, field + ".dt", "growth");
  }
  expect_equal(then.duration, duration, field + ".duration");
  if (!both_chosen) expect(are_same(then.integrator, integrator), field + ".integrator", "kind");
  expect(then.kinematics == kinematics, field + ".kinematics", "kind");
  expect(then.solver == solver, field + ".solver", "kind");
  expect_equal(then.velocity_factor, velocity_factor, field + ".velocity_factor");
  expect_equal(then.damping_rate, damping_rate, field + ".damping_rate");
  expect_equal(then.material_damping.mass, material_damping.mass, field + ".damping");
  expect_equal(then.material_damping.stiffness, material_damping.stiffness, field + ".damping");
  expect_equal(then.strain_inertia, strain_inertia, field + ".strain_inertia");
  expect_equal(then.correct_block_dispersion, correct_block_dispersion, field + ".correct_block_dispersion");
  expect_equal(then.correct_time_dispersion, correct_time_dispersion, field + ".correct_time_dispersion");
  expect_equal(then.lateral_inertia, lateral_inertia, field + ".lateral_inertia");
  expect_equal(then.equilibrium, equilibrium, field + ".equilibrium");
  expect(then.unlimited_strength == unlimited_strength, field + ".strength", "kind");
  expect(then.removal.blocks == removal.blocks, field + ".remove", "list of blocks");
  expect(then.rock.added == rock.added, field + ".add", "list of blocks");
  expect(are_same(then.removal.relaxation, removal.relaxation), field + ".remove", "course");
  expect_equal(then.limits.open_close_iterations, limits.open_close_iterations, field + ".max_open_close_iterations");
  expect_equal(then.limits.step_reductions, limits.step_reductions, field + ".max_step_reductions");
}

void check_stages(const Model& then, const Model& now, std::size_t stages) {
  for (std::size_t i = 0; i < stages; ++i) {
    const std::string field = fmt::format("steps[{}]", i);
    if (i >= now.stages.size()) refuse(field, "missing", fmt::format("stage \"{}\"", then.stages[i].name));
    check(then.stages[i], now.stages[i], field);
    expect(then.absent_in(i) == now.absent_in(i), field + ".add", "list of blocks that are yet to come in");
  }
  if (now.stages.size() == stages)
    throw InputError("", fmt::format("steps[{}]", stages), "missing", "a stage to go on with");
}

template <typename Item>
void check_all(const std::vector<Item>& then, const std::vector<Item>& now, const char* field) {
  expect_equal(then.size(), now.size(), fmt::format("the number of {}", field));
  for (std::size_t i = 0; i < now.size(); ++i) check(then[i], now[i]);
}

bool are_same(const ViscousEdge& a, const ViscousEdge& b) {
  return a.block == b.block && a.from == b.from && a.to == b.to && a.normal_impedance == b.normal_impedance &&
         a.shear_impedance == b.shear_impedance && a.first_stage == b.first_stage;
}

void check_free_field(const Model& then, const Model& now) {
  const auto same_side = [](const FreeFieldSide& a, const FreeFieldSide& b) {
    return a.outward == b.outward && a.viscous_edges == b.viscous_edges;
  };
  expect(std::ranges::equal(then.free_field_sides, now.free_field_sides, same_side), "viscous_boundaries",
         "list of free-field sides");
  if (!now.free_field_sides.empty())
    expect(have_same_viscous_edges(then, now), "viscous_boundaries", "list beside free-field sides");
}

// Springs that a contact has, or has from when its joint breaks.
bool have_same_springs(const Model& then, const Interface& a, const Model& now, const Interface& b) {
  if (now.joints[static_cast<std::size_t>(b.joint)].bonded) return true;
  const Springs before = springs_of(then, a), after = springs_of(now, b);
  return before.normal == after.normal && before.shear == after.shear;
}

// Automatic stiffness depends on loads and time steps, and what a cubic joint is on all joints and stages.
void check_contacts(const Model& then, const Model& now) {
  const ContactSet before = make_contacts(then);
  const ContactSet after = make_contacts(now);
  for (std::size_t i = 0; i < std::min(before.elements.size(), after.elements.size()); ++i) {
    const InterfaceElement& a = before.elements[i];
    const InterfaceElement& b = after.elements[i];
    if (a.law == b.law && a.stiffness == b.stiffness && a.dashpot == b.dashpot &&
        have_same_springs(then, before.interfaces[i], now, after.interfaces[i]))
      continue;
    throw InputError(
        "",
        fmt::format("the joint of blocks \"{}\" and \"{}\"", now.blocks[static_cast<std::size_t>(b.block_a)].name,
                    now.blocks[static_cast<std::size_t>(b.block_b)].name),
        "of another law or stiffness",
        "what it is in the run to go on from; automatic stiffness depends on loads and time steps, and "
        "cubic joints on all stages, removals and bolts: give the law, or the stiffness, in both scenes");
  }
  expect(before.can_change == after.can_change, "steps or joints", "kind: in one of them joints can open");
}

}  // namespace

bool have_same_viscous_edges(const Model& a, const Model& b) {
  return std::ranges::equal(a.viscous_edges, b.viscous_edges,
                            [](const ViscousEdge& one, const ViscousEdge& other) { return are_same(one, other); });
}

namespace {

// What is taken out slowly leaves loads behind that are told by its number.
template <typename Support>
void check_withdrawals(const std::vector<Support>& then, const std::vector<Support>& now, std::size_t stages,
                       const char* field) {
  const auto fades = [stages](const Support& each) {
    return each.withdrawal.relaxation && each.withdrawal.is_over_in(stages - 1);
  };
  for (std::size_t i = 0; i < std::max(then.size(), now.size()); ++i) {
    const bool faded = i < then.size() && fades(then[i]);
    if (!faded && !(i < now.size() && fades(now[i]))) continue;
    expect(i < then.size() && i < now.size() && then[i].name == now[i].name &&
               then[i].withdrawal.last_stage == now[i].withdrawal.last_stage &&
               are_same(then[i].withdrawal.relaxation, now[i].withdrawal.relaxation),
           field, "list up to what has been taken out over a time");
  }
}

}  // namespace

void expect_same_past(const Model& run, const Model& scene, std::size_t stages) {
  const Model settled = with_rock_at_start(run), branch = with_rock_at_start(scene);
  check_stress(settled, branch);
  check_all(settled.blocks, branch.blocks, "blocks");
  check_all(settled.materials, branch.materials, "materials");
  check_all(settled.joints, branch.joints, "joints");
  expect(settled.joint_of_block_pair == branch.joint_of_block_pair, "joint_pairs", "list");
  const auto same_line = [](const JointLine& a, const JointLine& b) {
    return a.from == b.from && a.to == b.to && a.joint == b.joint;
  };
  expect(std::ranges::equal(settled.joint_lines, branch.joint_lines, same_line), "joint_lines", "list");
  expect(held_flags(settled) == held_flags(branch), "fixed or supports", "list of held blocks");
  check_stages(settled, branch, stages);
  for (std::size_t i = 0; i < stages; ++i) {
    check_all(materials_in(settled, i), materials_in(branch, i), "materials");
    check_all(joints_in(settled, i), joints_in(branch, i), "joints");
  }
  check_withdrawals(settled.bolts, branch.bolts, stages, "bolts");
  check_withdrawals(settled.linings, branch.linings, stages, "linings");
  check_free_field(settled, branch);
  check_contacts(settled, branch);
}

}  // namespace dda
