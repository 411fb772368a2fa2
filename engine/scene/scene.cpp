#include "engine/scene/scene.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "engine/core/error.h"
#include "engine/core/read_file.h"
#include "engine/model/finish_model.h"
#include "engine/scene/choose_laws.h"
#include "engine/scene/file_kind.h"
#include "engine/scene/read_openings.h"
#include "engine/scene/scene_document.h"
#include "engine/scene/scene_parts.h"
#include "engine/scene/sections.h"

namespace dda {
namespace {

BlockFacts read_blocks_and_joints(const Field& scene, const Scheme& scheme, const std::filesystem::path& folder,
                                  const std::vector<GivenBlocks>& given, const std::vector<PlainLines>& lines,
                                  Model& model) {
  read_materials(scene, model);
  const std::vector<std::string> remarks = read_joints(scene, scheme, folder, lines, model);
  BlockFacts facts = read_blocks(scene, folder, given, lines, model);
  facts.remarks.insert(facts.remarks.begin(), remarks.begin(), remarks.end());
  read_joint_pairs(scene, facts.groups, model);
  read_gravity(scene, model);
  return facts;
}

void read_what_acts(const Field& scene, const SceneParts& parts, StressField& stresses,
                    const std::filesystem::path& folder, Model& model) {
  const std::vector<std::string>& groups = parts.groups;
  stresses.leave_to_themselves(read_initial_fields(scene, groups, model));
  const GroundPlan plan(model);
  read_joint_lines(scene, plan, model);
  RecordFiles records(folder);
  read_loads(scene, plan, groups, stresses, records, model);
  read_supports(scene, plan, groups, records, model);
  read_bolts(scene, plan, model);
  read_linings(scene, groups, parts.openings, model);
  read_viscous_boundaries(scene, plan, stresses, model);
  read_measurements(scene, plan, groups, model);
}

std::vector<PlanOpening> openings_of(const Field& scene, const Model& model) {
  std::vector<PlanOpening> openings;
  const Field blocks = scene.at("blocks");
  for (const Field& entry : blocks.is_array() ? blocks.items() : std::vector<Field>{blocks}) {
    const auto rock = entry.find("rock");
    const auto list = rock ? rock->find("openings") : std::nullopt;
    if (!list) continue;
    for (const Field& opening : list->items()) openings.push_back(read_opening(opening, model));
  }
  return openings;
}

std::string line_of(const Field& field) {
  std::string text = field.text();
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; };
  if (std::ranges::any_of(text, is_control)) field.fail("one line of text, without control characters");
  return text;
}

SceneParts read_parts(const Field& scene, const std::filesystem::path& folder, const std::vector<GivenBlocks>& given,
                      const std::vector<PlainLines>& lines) {
  SceneParts parts;
  Model& model = parts.model;
  const Scheme scheme = read_scheme(scene);
  if (const auto frequency = scene.find("target_frequency"))
    model.expected.frequency = frequency->positive(Dimension::frequency);
  if (const auto title = scene.find("title")) model.title = line_of(*title);
  BlockFacts facts = read_blocks_and_joints(scene, scheme, folder, given, lines, model);
  parts.groups = std::move(facts.groups);
  parts.remarks = std::move(facts.remarks);
  parts.openings = openings_of(scene, model);
  finish_blocks(model);  // what follows needs the moments, and blocks that do not overlap
  StressField stresses(scene, std::move(facts.own_stress), model);
  read_stages(scene, scheme, parts.groups, model);
  choose_laws(scene, scheme, model);
  stresses.fill(model);
  read_what_acts(scene, parts, stresses, folder, model);
  if (auto remark = stresses.remark_on_surface(model)) parts.remarks.push_back(std::move(*remark));
  read_peaks(scene, parts.groups, parts.openings, model);
  finish_around_blocks(model);
  return parts;
}

}  // namespace

SceneParts parse_scene_parts(std::string_view json_text, const std::string& name_for_errors,
                             const std::filesystem::path& folder) {
  try {
    const SceneDocument scene = read_scene_document(json_text);
    return read_parts(Field(scene.document, ""), folder, {}, scene.lines);
  } catch (const InputError& error) {
    throw error.in_file(name_for_errors);
  }
}

Model parse_scene(std::string_view json_text, const std::string& name_for_errors, const std::filesystem::path& folder) {
  return parse_scene_parts(json_text, name_for_errors, folder).model;
}

Model read_document(const nlohmann::json& document, const std::vector<GivenBlocks>& given,
                    const std::string& name_for_errors, const std::filesystem::path& folder) {
  try {
    return read_parts(Field(document, ""), folder, given, {}).model;
  } catch (const InputError& error) {
    throw error.in_file(name_for_errors);
  }
}

std::string scene_text(const std::filesystem::path& file) {
  std::string text;
  try {
    text = read_file(file, most_input_bytes);
  } catch (const UnreadableFile& error) {
    throw InputError(file.string(), "the scene file", error.why(), "a JSON file");
  }
  if (const auto kind = kind_other_than_scene(file, text))
    throw InputError(file.string(), "the scene file", kind->what, "a scene (JSON); " + kind->command);
  return text;
}

SceneParts read_scene_parts(const std::filesystem::path& file) {
  return parse_scene_parts(scene_text(file), file.string(), file.parent_path());
}

Model read_scene(const std::filesystem::path& file) { return read_scene_parts(file).model; }

}  // namespace dda
