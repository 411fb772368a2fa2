#include "engine/app/scene_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "engine/advice/advice.h"
#include "engine/advice/advise.h"
#include "engine/advice/ramp_of_removal.h"
#include "engine/advice/remarks.h"
#include "engine/advice/ringing_weight.h"
#include "engine/app/joints_that_come.h"
#include "engine/app/measurement_report.h"
#include "engine/app/recording_report.h"
#include "engine/app/stiffness_report.h"
#include "engine/contact/contact_set.h"
#include "engine/geometry/box.h"
#include "engine/linear/cholesky_solver.h"
#include "engine/model/free_field_side.h"
#include "engine/model/held_flags.h"
#include "engine/model/law_name.h"
#include "engine/model/rock_change.h"
#include "engine/model/step_choice.h"
#include "engine/simulation/block_terms.h"
#include "engine/simulation/probes.h"
#include "engine/simulation/run_so_far.h"
#include "engine/simulation/settling_pace.h"
#include "engine/simulation/simulation.h"
#include "engine/simulation/step_plan.h"
#include "engine/simulation/system_matrix.h"

namespace dda {
namespace {

// Lines with their subject in a column of its own.
class Text {
 public:
  template <typename... Arguments>
  void line(const char* subject, fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(text_), "{:<13}", subject);
    fmt::format_to(std::back_inserter(text_), format, std::forward<Arguments>(arguments)...);
    text_ += '\n';
  }
  void gap() { text_ += '\n'; }
  void plain(const std::string& line) { text_ += line + '\n'; }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

std::string count(std::size_t n, const char* singular) {
  return fmt::format("{} {}{}", n, singular, n == 1 ? "" : "s");
}

void add_blocks(const Model& model, Text& text) {
  double least = std::numeric_limits<double>::infinity();
  double most = 0;
  std::vector<std::size_t> of_material(model.materials.size(), 0);
  for (const Block& block : model.blocks) {
    const Box box = bounding_box(block.shape);
    least = std::min(least, (box.upper - box.lower).minCoeff());
    most = std::max(most, (box.upper - box.lower).maxCoeff());
    ++of_material[static_cast<std::size_t>(block.material)];
  }
  text.line("blocks", "{}, {:.6g} m to {:.6g} m wide or high", model.blocks.size(), least, most);
  for (std::size_t i = 0; i < of_material.size(); ++i) {
    const Material& material = model.materials[i];
    text.line("material", "\"{}\": {:.6g} kg/m3, E = {:.6g} GPa, nu = {:.6g}, plane {}; {}", material.name,
              material.density, material.young / 1e9, material.poisson,
              material.plane == PlaneState::stress ? "stress" : "strain", count(of_material[i], "block"));
  }
}

std::string after_failure(const JointMaterial& joint) {
  constexpr double degrees = 57.29577951308232;
  std::string text;
  if (joint.residual_friction_angle || joint.residual_cohesion > 0)
    text += fmt::format("; residual {:.6g} deg, {:.6g} MPa",
                        joint.residual_friction_angle.value_or(joint.friction_angle) * degrees,
                        joint.residual_cohesion / 1e6);
  if (joint.dilation_angle > 0) text += fmt::format("; dilation {:.6g} deg", joint.dilation_angle * degrees);
  return text;
}

std::string strength_of(const JointMaterial& joint) {
  if (joint.bonded) return "bonded: never opens or slides";
  constexpr double degrees = 57.29577951308232;
  return fmt::format("friction {:.6g} deg, cohesion {:.6g} MPa, tension {:.6g} MPa{}", joint.friction_angle * degrees,
                     joint.cohesion / 1e6, joint.tensile_strength / 1e6, after_failure(joint));
}

// A contact of a vertex is one end of a face that two springs hold, or where blocks touch in a point alone.
std::string vertices_among(const std::vector<Interface>& interfaces) {
  std::size_t ends = 0, points = 0;
  for (const Interface& interface : interfaces)
    if (interface.length == 0) ++(interface.closed > 0 ? ends : points);
  return (ends > 0 ? fmt::format(", {} of them springs at ends of faces", ends) : "") +
         (points > 0 ? fmt::format(", {} of them in a point", points) : "");
}

// Interfaces by joint and law: a joint's law may not be usable everywhere, e.g. where blocks touch in a point.
void add_contacts(const Model& model, const ContactSet& contacts, Text& text) {
  std::map<std::pair<int, InterfaceLaw>, std::size_t> groups;
  for (std::size_t i = 0; i < contacts.interfaces.size(); ++i)
    ++groups[{contacts.interfaces[i].joint, contacts.elements.but_for_blocks(i).law}];
  text.line("contacts", "{}{}", count(contacts.interfaces.size(), "interface"), vertices_among(contacts.interfaces));
  for (const auto& [group, number] : groups) {
    const JointMaterial& joint = model.joints[static_cast<std::size_t>(group.first)];
    text.line("joint", "\"{}\": {} {}, {}", joint.name, number, law_name(group.second), strength_of(joint));
  }
}

// What gives way in a joint takes part in the result: how much, joint by joint.
void add_stiffness(const Model& model, Text& text) {
  const std::vector<std::optional<JointSurvey>> joints = survey_joints(model);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (!joints[i]) continue;
    const JointSurvey& survey = *joints[i];
    text.line(model.joints[i].law == InterfaceLaw::projected ? "gives way" : "springs",
              "\"{}\": {:.3g} to {:.3g} GPa/m{}; adds at most {:.3g} % to the compliance of the blocks; blocks "
              "pressed in by at most {:.2g} of their size under {:.3g} MPa",
              model.joints[i].name, survey.softest / 1e9, survey.stiffest / 1e9,
              model.joints[i].automatic_stiffness ? ", chosen" : "", 100 * survey.worst.compliance,
              survey.worst.penetration, model.expected.pressure / 1e6);
  }
}

// The projected law finds its penalty by itself: what it came to.
void add_penalties(const Model& model, const ContactSet& contacts, Text& text) {
  const std::vector<std::optional<PenaltySurvey>> joints = survey_penalties(model, contacts);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (!joints[i]) continue;
    text.line(
        "penalty", "\"{}\": {:.3g} to {:.3g} times plane modulus over width, contacts of {:.3g} to {:.3g} GPa/m{}",
        model.joints[i].name, joints[i]->least, joints[i]->most, joints[i]->softest / 1e9, joints[i]->stiffest / 1e9,
        model.joints[i].normal_stiffness > 0 ? ", the joint's own compliance included"
                                             : "; adds no compliance while closed");
  }
}

void add_bolts(const Model& model, Text& text) {
  std::size_t links = 0;
  for (const Bolt& bolt : model.bolts) links += bolt.links.size();
  text.line("bolts", "{}, {}", model.bolts.size(), count(links, "link"));
}

// Blocks that bolts and linings couple.
std::vector<std::pair<int, int>> coupled_by_support(const Simulation& simulation) {
  std::vector<std::pair<int, int>> pairs = simulation.bolts().pairs();
  const std::vector<std::pair<int, int>> lined = linings_of(simulation).pairs();
  pairs.insert(pairs.end(), lined.begin(), lined.end());
  return pairs;
}

void add_linings(const Model& model, Text& text) {
  for (const Lining& lining : model.linings)
    text.line("lining", "\"{}\", {:.6g} m thick, {}{}{}", lining.name, lining.thickness,
              count(lining.elements(), "element"), lining.closed ? " all around" : "",
              lining.yields() ? fmt::format(", crushes at {:.6g} N and tears at {:.6g} N per m",
                                            lining.compressive_strength * lining.thickness,
                                            lining.tensile_strength * lining.thickness)
                              : ", elastic");
}

void add_what_acts(const Model& model, Text& text) {
  text.line("loads", "{}, {}, gravity [{:.6g}, {:.6g}] m/s2", count(model.point_loads.size(), "point load"),
            count(model.edge_loads.size(), "edge load"), model.gravity.x(), model.gravity.y());
  for (const std::string& line : describe_recordings(model)) text.line("record", "{}", line);
  text.line("held by", "{}, {}, {}", count(model.supports.size(), "point support"),
            count(static_cast<std::size_t>(std::ranges::count(held_flags(model), true)), "whole block"),
            count(model.viscous_edges.size(), "absorbing edge"));
  if (!model.bolts.empty()) add_bolts(model, text);
  add_linings(model, text);
  for (const Measurement& measurement : model.measurements) text.line("measured", "{}", describe(model, measurement));
}

const Block& block_held(const Model& model, int held) {
  return model.blocks[static_cast<std::size_t>(model.held_blocks[static_cast<std::size_t>(held)].block)];
}

// The columns beside sides with a free field, which are no blocks of the model: in the order of the sides.
void add_free_field(const Model& model, const Simulation& columns, Text& text) {
  std::size_t first = 0;
  for (const FreeFieldSide& side : model.free_field_sides) {
    const Vec2 foot = foot_of(model, side);
    const Vec2 head = head_of(model, side);
    const int base = held_base_of(model, side);
    const Box box = bounding_box(columns.model().blocks[first].shape);
    const std::size_t number = side.viscous_edges.size();
    text.line("free field", "{} side, x = {:.6g} m: column of {}, {:.6g} m wide, y = {:.6g} m to {:.6g} m, on {}",
              side.outward < 0 ? "left" : "right", foot.x(), count(number, "block"), (box.upper - box.lower).x(),
              foot.y(), head.y(),
              base < 0 ? "the supports and viscous edges below"
                       : fmt::format("a copy of \"{}\"", block_held(model, base).name));
    first += number + (base < 0 ? 0 : 1);
  }
}

std::string steps_of(const Stage& stage) {
  if (stage.paces_itself())
    return fmt::format("finds its own steps to equilibrium within {:.2g} of the largest force", stage.equilibrium);
  return fmt::format("{} steps of {}{}, {:.6g} s in all", stage.steps(), in_words(stage.shortest_dt(), stage.dt),
                     stage.chosen.dt.automatic ? fmt::format(" (chosen: {})", stage.chosen.dt.reason) : "",
                     stage.duration);
}

std::string removal_of(const Model& model, const Stage& stage) {
  const std::vector<int>& blocks = stage.removal.blocks;
  constexpr std::size_t most_named = 3;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::min(blocks.size(), most_named); ++i)
    names.push_back(fmt::format("\"{}\"", model.blocks[static_cast<std::size_t>(blocks[i])].name));
  if (blocks.size() > most_named) names.push_back(fmt::format("{} more", blocks.size() - most_named));
  return fmt::format("removes {}: {}{}", count(blocks.size(), "block"), fmt::join(names, ", "),
                     stage.removal.relaxation ? "; what they exerted on the others fades" : ", at once");
}

template <typename Item>
std::vector<std::string> names_of_changed(const std::vector<Item>& before, const std::vector<Item>& now,
                                          bool (*same)(const Item&, const Item&)) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < now.size(); ++i)
    if (!same(before[i], now[i])) names.push_back(fmt::format("\"{}\"", now[i].name));
  return names;
}

void add_rock_of(const Model& model, std::size_t stage, Text& text) {
  const RockOfStage& rock = model.stages[stage].rock;
  if (stage == 0) return;
  bool any = false;
  const auto add = [&](const char* what, const auto& before, const auto& now, auto same) {
    const std::vector<std::string> names = names_of_changed(before, now, same);
    if (names.empty()) return;
    any = true;
    text.plain(fmt::format("  other {}: {}", what, fmt::join(names, ", ")));
  };
  const std::vector<JointMaterial>& joints = joints_in(model, stage);
  add("strength of joints", joints_in(model, stage - 1), joints, have_same_strength);
  add("springs of joints", joints_in(model, stage - 1), joints, have_same_springs);
  const std::vector<Material>& materials = materials_in(model, stage);
  add("moduli of materials", materials_in(model, stage - 1), materials, have_same_moduli);
  add("density of materials", materials_in(model, stage - 1), materials, have_same_density);
  if (!any && !(rock.joints.empty() && rock.materials.empty())) text.plain("  joints and materials as before");
}

void add_stage(const Simulation& simulation, std::size_t index, const BlockMatrix& matrix, Text& text) {
  const Model& model = simulation.model();
  const ContactSet& contacts = simulation.contacts();
  const Stage& stage = model.stages[index];
  const BlockTerms terms = make_block_terms(model, stage);
  const double dt = first_step(model, stage, contacts.can_change);
  const StepPlan plan = make_plan(model, index, contacts, matrix.couplings(), stiffness_numbers(contacts, terms, dt));
  text.gap();
  text.plain(fmt::format("stage \"{}\": {}; {}, {} kinematics", stage.name, steps_of(stage), stage.integrator.name,
                         stage.kinematics == Kinematics::small ? "small" : "finite"));
  if (const std::string& reason = stage.chosen.integrator.reason; !reason.empty()) text.plain("  chosen: " + reason);
  if (!stage.removal.blocks.empty()) text.plain("  " + removal_of(model, stage));
  if (const std::string ramp = ramp_of_removal(model, contacts, index); !ramp.empty()) text.plain("  " + ramp);
  add_rock_of(model, index, text);
  const auto put_in = std::ranges::count(model.bolts, static_cast<int>(index), &Bolt::first_stage);
  if (index > 0 && put_in > 0) text.plain(fmt::format("  puts in {}", count(static_cast<std::size_t>(put_in), "bolt")));
  for (const Lining& lining : model.linings)
    if (index > 0 && static_cast<std::size_t>(lining.first_stage) == index)
      text.plain(fmt::format("  sprays \"{}\"", lining.name));
  const auto taken_out =
      std::ranges::count_if(model.bolts, [index](const Bolt& bolt) { return bolt.withdrawal.is_at_start_of(index); });
  if (taken_out > 0) text.plain(fmt::format("  takes out {}", count(static_cast<std::size_t>(taken_out), "bolt")));
  for (const Lining& lining : model.linings)
    if (lining.withdrawal.is_at_start_of(index)) text.plain(fmt::format("  takes out \"{}\"", lining.name));
  if (!stage.rock.added.empty()) {
    const std::string joints = joints_that_come(model, index);
    const std::string added = count(stage.rock.added.size(), "block");
    text.plain(fmt::format("  adds {}{}{}", added, joints.empty() ? "" : " ", joints));
  }
  for (const std::string& line : plan.describe()) text.plain("  " + line);
  if (const double limit = simulation.stability_limit(index); limit > 0)
    text.plain(fmt::format("  stable: up to dt = {:.6g} s, of which this is {:.3g} %", limit, 100 * stage.dt / limit));
  if (const MaterialDamping& damping = stage.material_damping; damping.acts())
    text.plain(fmt::format("  damping of the material: {:.4g} 1/s of inertia, {:.4g} s of stiffness", damping.mass,
                           damping.stiffness));
  for (const std::string& line : warn_of_recordings(model, index)) text.plain("  " + line);
}

double megabytes(const Model& model, const ContactSet& contacts, const BlockMatrix& matrix, double factor_nonzeros) {
  const auto blocks = static_cast<double>(model.blocks.size());
  const double per_block = sizeof(Block) + 4 * sizeof(Vec2) + 30 * sizeof(Vec6) + 2 * sizeof(Mat3);
  const double per_interface = sizeof(Interface) + 2 * sizeof(InterfaceState);
  const auto elements = static_cast<double>(contacts.elements.kinds().size());
  const double matrix_numbers = 36.0 * (matrix.size() + matrix.couplings());
  return (blocks * per_block + static_cast<double>(contacts.interfaces.size()) * per_interface +
          elements * sizeof(InterfaceElement) + matrix_numbers * (sizeof(double) + sizeof(int)) +
          factor_nonzeros * sizeof(double)) /
         1e6;
}

void add_size(const Model& model, const ContactSet& contacts, const BlockMatrix& matrix, Text& text) {
  CholeskySolver solver;
  solver.analyze(matrix);
  const double nonzeros = solver.factor_facts().nonzeros;
  text.line("size", "{} unknowns, {} of blocks, {} numbers in a factor; about {:.3g} MB", matrix.unknowns(),
            count(static_cast<std::size_t>(matrix.couplings()), "coupled pair"), std::llround(nonzeros),
            megabytes(model, contacts, matrix, nonzeros));
}

// Waves of one frequency, and, where none is given, what the whole spectrum of the scene's load makes of them: a
// history holds more than its main frequency.
void add_waves(const Simulation& simulation, std::optional<double> frequency, Text& text) {
  AdviceQuestion question;
  question.frequency = frequency;
  question.limits = false;
  const Advice advice = advise(simulation, question);
  if (!advice.frequency) {
    text.gap();
    text.plain("no load with a history in the scene: give --frequency for predicted errors of waves");
  }
  for (const std::string& line : to_short_text(advice)) text.plain(line);
}

}  // namespace

std::string describe_scene(const Model& model, std::optional<double> frequency,
                           const std::vector<std::string>& remarks) {
  const Simulation simulation(model);
  const Probes probes(simulation);
  const ContactSet& contacts = simulation.contacts();
  const BlockMatrix matrix =
      make_system_matrix(static_cast<int>(model.blocks.size()), contacts, coupled_by_support(simulation));
  Text text;
  if (!model.title.empty()) text.plain(model.title + '\n');
  add_blocks(model, text);
  add_contacts(model, contacts, text);
  add_stiffness(model, text);
  add_penalties(model, contacts, text);
  add_what_acts(model, text);
  if (const Simulation* columns = simulation.free_field_columns()) add_free_field(model, *columns, text);
  add_size(model, contacts, matrix, text);
  for (const std::string& remark : remarks) text.line("remark", "{}", remark);
  for (const std::string& remark : remarks_on(model, contacts)) text.line("remark", "{}", remark);
  for (const std::string& remark : ringing_weight(model, contacts)) text.line("remark", "{}", remark);
  for (std::size_t i = 0; i < model.stages.size(); ++i) add_stage(simulation, i, matrix, text);
  add_waves(simulation, frequency, text);
  return text.take();
}

}  // namespace dda
