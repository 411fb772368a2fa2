#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "engine/linear/over_processes.h"
#include "engine/scene/places.h"
#include "engine/scene/read_withdrawal.h"
#include "engine/scene/sections.h"

namespace dda {
namespace {

// What static stages without dt go on to.
constexpr double default_equilibrium = 1e-9;

Integrator read_integrator(const Field& field) {
  if (field.is_text()) {
    constexpr std::array integrators = {thesis_integrator, trapezoidal_integrator, energy_conserving_integrator,
                                        central_difference_integrator, static_integrator};
    return integrators.at(
        field.choice({"thesis", "trapezoidal", "energy_conserving", "central_difference", "static", "auto"}))();
  }
  if (const auto alpha = field.find("hht")) return hht_integrator(alpha->within(0, 1.0 / 3));
  return generalized_alpha_integrator(field.at("generalized_alpha").within(0, 1));
}

// Left out or "auto": that of the scheme, in place of which the accurate scheme may have explicit steps.
void read_integrator(const Field& field, const Scheme& scheme, Stage& stage) {
  const auto given = field.find("integrator");
  if (given && !(given->is_text() && given->text() == "auto")) {
    stage.integrator = read_integrator(*given);
  } else {
    stage.chosen.integrator.automatic = scheme.name == SchemeName::accurate;
  }
}

Kinematics read_kinematics(const Field& field) {
  return field.choice({"finite", "small"}) == 0 ? Kinematics::finite : Kinematics::small;
}

SolverRequest read_solver(const Field& field) {
  using enum SolverRequest;
  const std::vector all{automatic, cholesky, pcg, dense, petsc};
  const SolverRequest wanted = all.at(field.choice({"auto", "cholesky", "pcg", "dense", "petsc"}));
  if (wanted == petsc && !over_processes().make)
    field.fail("a solver of this program, which was built without PETSc (ci/petsc builds it with)");
  return wanted;
}

void read_duration(const Field& field, Stage& stage) {
  const auto dt = field.find("dt");
  const bool is_left_open = !dt || (dt->is_text() && dt->text() == "auto");
  if (is_left_open && stage.integrator.is_static) {  // it paces itself
    stage.duration = value_or(field, "duration", 0.0, [](const Field& f) { return f.not_negative(Dimension::time); });
    stage.equilibrium = default_equilibrium;
    return;
  }
  stage.chosen.dt.automatic = is_left_open;
  if (!is_left_open) stage.dt = dt->positive(Dimension::time);
  const Field duration = field.at("duration");
  stage.duration = duration.positive(Dimension::time);
  if (stage.chosen.dt.automatic) return;
  if (stage.duration < 0.5 * stage.dt) duration.fail(fmt::format("at least one step of {} s", stage.dt));
  if (stage.duration > 1e12 * stage.dt) duration.fail(fmt::format("at most 1e12 steps of {} s", stage.dt));
}

// Stiffness-proportional by one frequency, Rayleigh damping by two (rad/s): the ratio is that wanted at each.
void read_rayleigh_damping(const Field& field, Stage& stage) {
  if (stage.integrator.is_static) field.fail("to be left out in a static stage, which has no velocities");
  const double ratio = field.at("ratio").positive(Dimension::dimensionless);
  if (ratio >= 1) field.at("ratio").fail("a number below 1, the share of critical damping");
  const auto one = field.find("frequency");
  const auto two = field.find("frequencies");
  if (one.has_value() == two.has_value()) field.fail("either \"frequency\" or \"frequencies\"");
  const auto omega = [](const Field& f) { return 2 * std::numbers::pi * f.positive(Dimension::frequency); };
  if (one) {
    stage.material_damping.stiffness = 2 * ratio / omega(*one);
    return;
  }
  const std::vector<Field> pair = two->items();
  if (pair.size() != 2) two->fail("two frequencies, e.g. [\"20 Hz\", \"200 Hz\"]");
  const double low = omega(pair[0]), high = omega(pair[1]);
  if (low >= high) two->fail("two frequencies, the lower one first");
  stage.material_damping.mass = 2 * ratio * low * high / (low + high);
  stage.material_damping.stiffness = 2 * ratio / (low + high);
}

void read_damping(const Field& field, Stage& stage) {
  if (const auto damping = field.find("damping")) read_rayleigh_damping(*damping, stage);
  stage.velocity_factor =
      value_or(field, "velocity_factor", stage.velocity_factor, [](const Field& f) { return f.within(0, 1); });
  stage.damping_rate = value_or(field, "damping_rate", stage.damping_rate,
                                [](const Field& f) { return f.not_negative(Dimension::rate); });
}

void read_accuracy(const Field& field, Stage& stage) {
  const auto truth = [](const Field& f) { return f.truth(); };
  stage.strain_inertia = value_or(field, "strain_inertia", stage.strain_inertia,
                                  [](const Field& f) { return f.positive(Dimension::dimensionless); });
  stage.correct_block_dispersion = value_or(field, "correct_block_dispersion", stage.correct_block_dispersion, truth);
  stage.correct_time_dispersion = value_or(field, "correct_time_dispersion", stage.correct_time_dispersion, truth);
  stage.lateral_inertia = value_or(field, "lateral_inertia", stage.lateral_inertia, truth);
}

void read_equilibrium(const Field& equilibrium, Stage& stage) {
  if (!stage.integrator.is_static) equilibrium.fail("to be left out: only the integrator \"static\" seeks equilibrium");
  stage.equilibrium = equilibrium.within(0, 1);
  if (stage.paces_itself() && stage.equilibrium == 0)
    equilibrium.fail("above 0: without dt equilibrium is what ends the stage");
}

void read_static(const Field& field, Stage& stage) {
  if (const auto strength = field.find("strength"))
    stage.unlimited_strength = strength->choice({"unlimited", "joints"}) == 0;
  if (const auto equilibrium = field.find("equilibrium")) read_equilibrium(*equilibrium, stage);
  const auto unbalanced = field.find("on_unbalanced");
  if (!unbalanced) return;
  if (stage.equilibrium == 0)
    unbalanced->fail(
        "to be left out: this stage is not asked for equilibrium (static, without dt or with equilibrium)");
  stage.on_unbalanced = unbalanced->choice({"continue", "stop"}) == 0 ? OnUnbalanced::carry_on : OnUnbalanced::stop;
}

void read_limits(const Field& field, Stage& stage) {
  const auto whole = [](const Field& f) { return f.whole_number(); };
  stage.limits.open_close_iterations =
      value_or(field, "max_open_close_iterations", stage.limits.open_close_iterations, whole);
  stage.limits.step_reductions = value_or(field, "max_step_reductions", stage.limits.step_reductions, whole);
}

std::optional<TimeFunction> read_relaxation(const Field& field, const Stage& stage) {
  if (!field.is_object()) return std::nullopt;
  const char* given = field.has("over") ? "over" : "table";
  // A static stage that finds its own steps has what is left at the end of its duration from its first step on.
  if (field.has(given) && stage.paces_itself() && stage.duration == 0)
    field.at(given).fail("left out in a static stage without dt and duration, whose steps take no time");
  return read_fading(field);
}

void refuse_names_given_twice(const Field& names) {
  std::set<std::string> given;
  for (const Field& name : names.items())
    if (!given.insert(name.text()).second)
      name.fail(fmt::format("\"{}\" a second time", name.text()), "each name once");
}

const std::string& block_name(int block, const Model& model) {
  return model.blocks[static_cast<std::size_t>(block)].name;
}

// Names of blocks and groups; a block that is in two of them is meant once.
template <typename Check>
std::vector<int> blocks_called_by(const Field& names, const std::vector<std::string>& groups, const Model& model,
                                  const Check& check) {
  std::vector<int> blocks;
  for (const Field& name : names.items()) {
    for (const int block : blocks_called(name, groups, model)) {
      check(name, block);
      if (std::ranges::find(blocks, block) == blocks.end()) blocks.push_back(block);
    }
  }
  std::ranges::sort(blocks);
  return blocks;
}

// Says of every block whether it is away after the stages that have been read so far.
std::vector<bool> absent_so_far(const Model& model) {
  std::vector<bool> absent = model.absent_in(model.stages.size());
  absent.resize(model.blocks.size(), false);
  return absent;
}

// True where no stage that has been read so far adds or removes the block.
bool is_first_told_of(int block, const Model& model) {
  return std::ranges::none_of(model.stages, [block](const Stage& stage) {
    return std::ranges::binary_search(stage.removal.blocks, block) ||
           std::ranges::binary_search(stage.rock.added, block);
  });
}

void read_removal(const Field& field, const std::vector<std::string>& groups, const Model& model, Stage& stage) {
  const Field names = field.is_object() ? field.at("blocks") : field;
  if (model.stages.empty())
    field.fail("given in the first stage", "a later one: leave the blocks out of the scene, or let them settle first");
  refuse_names_given_twice(names);
  const std::vector<bool> absent = absent_so_far(model);
  stage.removal.blocks = blocks_called_by(names, groups, model, [&](const Field& name, int block) {
    if (absent[static_cast<std::size_t>(block)])
      name.fail("blocks that no stage before removes, as \"" + block_name(block, model) + "\" is");
  });
  stage.removal.relaxation = read_relaxation(field, stage);
}

// They bring no stress along, whatever the stress in the ground is.
void read_addition(const Field& names, const std::vector<std::string>& groups, Model& model, Stage& stage) {
  if (model.stages.empty())
    names.fail("given in the first stage", "a later one: blocks that no stage adds are there from the start");
  refuse_names_given_twice(names);
  const std::vector<bool> absent = absent_so_far(model);
  stage.rock.added = blocks_called_by(names, groups, model, [&](const Field& name, int block) {
    const std::string& called = block_name(block, model);
    if (std::ranges::find(stage.removal.blocks, block) != stage.removal.blocks.end())
      name.fail("blocks that the stage does not remove, as \"" + called + "\" is");
    if (!is_first_told_of(block, model) && !absent[static_cast<std::size_t>(block)])
      name.fail("blocks that no stage before adds, as \"" + called + "\" is");
  });
}

Stage read_stage(const Field& field, std::string name, const Scheme& scheme, bool all_bonded) {
  const Kinematics kinematics = value_or(field, "kinematics", Kinematics::finite, read_kinematics);
  Stage stage = preset_stage(scheme, kinematics, all_bonded);
  stage.name = value_or(field, "name", std::move(name), [](const Field& f) { return f.name(); });
  read_integrator(field, scheme, stage);
  stage.solver = value_or(field, "solver", stage.solver, read_solver);
  read_duration(field, stage);
  read_damping(field, stage);
  read_accuracy(field, stage);
  read_static(field, stage);
  read_limits(field, stage);
  return stage;
}

}  // namespace

Scheme read_scheme(const Field& scene) {
  Scheme scheme;
  scheme.name = value_or(scene, "scheme", scheme.name, [](const Field& f) {
    return f.choice({"accurate", "thesis"}) == 0 ? SchemeName::accurate : SchemeName::thesis;
  });
  return scheme;
}

void read_stages(const Field& scene, const Scheme& scheme, const std::vector<std::string>& groups, Model& model) {
  const bool all_bonded = std::all_of(model.joints.begin(), model.joints.end(), [](const auto& j) { return j.bonded; });
  const Field steps = scene.at("steps");
  const auto append = [&](const Field& step, std::string name) {
    Stage stage = read_stage(step, std::move(name), scheme, all_bonded);
    if (const auto removed = step.find("remove")) read_removal(*removed, groups, model, stage);
    stage.rock = read_rock_changes(step, model);
    if (const auto added = step.find("add")) read_addition(*added, groups, model, stage);
    model.stages.push_back(std::move(stage));
  };
  if (!steps.is_array()) {
    append(steps, "run");
    return;
  }
  std::set<std::string> names;
  for (const Field& step : steps.items()) {
    append(step, fmt::format("stage {}", model.stages.size() + 1));
    const std::string& name = model.stages.back().name;
    if (names.insert(name).second) continue;
    if (step.has("name")) step.at("name").fail("a name that no stage before has");
    step.fail(fmt::format("without a name, and so \"{}\", as a stage before is called", name), "a name of its own");
  }
}

}  // namespace dda
