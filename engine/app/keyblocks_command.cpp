#include "engine/app/keyblocks_command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <ostream>
#include <set>

#include "engine/app/keyblocks_picture.h"
#include "engine/app/named_opening.h"
#include "engine/core/error.h"
#include "engine/core/quantity.h"
#include "engine/keyblocks/key_blocks.h"
#include "engine/record/atomic_file.h"
#include "engine/record/reserved_folder.h"
#include "engine/scene/scene.h"
#include "engine/scene/scene_parts.h"
#include "engine/scene/unmerged_scene.h"

namespace dda {
namespace {

constexpr auto details =
    "Judges every block with a free face by block theory: whether it can be removed, whether it falls, slides or is\n"
    "held, its factor of safety, and the force of bolts that gives the wanted one. Blocks inside of openings, and\n"
    "those that a stage removes, are taken out. DIR gets keyblocks.json and keyblocks.svg, a picture.\n\n"
    "Examples:\n"
    "  dda keyblocks slope.json\n"
    "  dda keyblocks tunnel.json --opening tunnel --fos 1.5 --out keyblocks\n"
    "  dda keyblocks slope.json --acceleration 1.5,0 --bolt-direction 160deg\n";

constexpr double least_safety = 0.01;
constexpr double most_safety = 1000;
constexpr double most_acceleration = 1e6;  // m/s2: far beyond all shaking

Vec2 acceleration_of(const std::vector<double>& components) {
  if (components.empty()) return Vec2::Zero();
  const auto in_reach = [](double value) { return std::abs(value) <= most_acceleration; };
  if (components.size() != 2 || !std::ranges::all_of(components, in_reach))
    throw InputError("", "--acceleration", fmt::format("{}", fmt::join(components, ",")),
                     fmt::format("X,Y in m/s2, two numbers from -{:g} to {:g}", most_acceleration, most_acceleration));
  return {components[0], components[1]};
}

// Blocks that some stage removes. Whoever draws an opening as a group of blocks, as `dda cut` writes it, says in the
// stages alone that it is one.
std::vector<bool> excavated_blocks(const Model& model) {
  std::vector<bool> is_excavated(model.blocks.size(), false);
  for (const Stage& stage : model.stages)
    for (const int block : stage.removal.blocks) is_excavated[static_cast<std::size_t>(block)] = true;
  return is_excavated;
}

// Blocks of all openings are taken out, and all that stages remove; of the opening asked for alone, where there is one.
void take_out_openings(const SceneParts& scene, const std::string& asked, KeyBlockQuestion& question) {
  std::set<std::string> taken_out;
  for (const PlanOpening& opening : scene.openings) {
    if (asked.empty() && !opening.left_out) taken_out.insert(opening.name);
    if (opening.name == asked && opening.left_out) question.opening.push_back({opening.outline, {}});
  }
  if (!asked.empty()) taken_out.insert(asked);
  const std::vector<bool> is_excavated = excavated_blocks(scene.model);
  for (std::size_t block = 0; block < scene.groups.size(); ++block) {
    const bool is_removed = asked.empty() && is_excavated[block];
    question.is_void.push_back(is_removed || taken_out.contains(scene.groups[block]));
    if (scene.groups[block] == asked) question.opening.push_back(scene.model.blocks[block].shape);
  }
  if (!asked.empty() && question.opening.empty()) refuse_opening(asked, scene);
}

KeyBlockQuestion question_of(const SceneParts& scene, const KeyBlocksRequest& request) {
  KeyBlockQuestion question;
  const bool in_range = request.wanted_safety >= least_safety && request.wanted_safety <= most_safety;
  if (!in_range)  // nor is what is no number
    throw InputError("", "--fos", fmt::format("{:g}", request.wanted_safety),
                     fmt::format("a number from {:g} to {:g}", least_safety, most_safety));
  question.wanted_safety = request.wanted_safety;
  question.acceleration = acceleration_of(request.acceleration);
  if (!request.bolt_direction.empty())
    question.bolt_direction = parse_quantity(request.bolt_direction, Dimension::angle, "--bolt-direction");
  take_out_openings(scene, request.opening, question);
  return question;
}

// Merging blocks closes joints and opens the shapes of others; what could be removed before it?
std::optional<TypeCounts> types_without_merging(const KeyBlocksRequest& request) {
  const std::string name = request.scene.string();
  const auto unmerged = without_merging(scene_text(request.scene));
  if (!unmerged) return std::nullopt;
  const SceneParts scene = parse_scene_parts(*unmerged, name + " (not merged)", request.scene.parent_path());
  return count_types(key_blocks(scene.model, question_of(scene, request)).blocks);
}

}  // namespace

void add_keyblocks(CLI::App& app, KeyBlocksRequest& request) {
  CLI::App* command =
      app.add_subcommand("keyblocks", "Find the blocks that can come out at free faces")->footer(details);
  const auto add = [command](const char* name, auto& value, const char* help, const char* type) {
    return command->add_option(name, value, help)->type_name(type);
  };
  add("scene", request.scene, "scene file (JSON)", "SCENE.json")->required();
  add("--opening", request.opening, "alone taken out: an opening or group; default: openings, what stages remove",
      "NAME");
  add("--out", request.folder, "folder for the results; made if need be", "DIR");
  add("--fos", request.wanted_safety,
      "factor of safety that bolts are to give, on joints and on what acts; default 1.5", "FACTOR");
  add("--bolt-direction", request.bolt_direction,
      "of their pull, counter-clockwise from +x, e.g. 90deg; default: into the free faces", "ANGLE");
  add("--acceleration", request.acceleration, "m/s2, on all mass besides gravity, e.g. of shaking", "X,Y")
      ->delimiter(',')
      ->allow_extra_args(false);
}

void find_key_blocks(const KeyBlocksRequest& request, std::ostream& out) {
  const ReservedFolder folder(request.folder, {"keyblocks.json", "keyblocks.svg"});
  const SceneParts scene = read_scene_parts(request.scene);
  const KeyBlockQuestion question = question_of(scene, request);
  KeyBlockReport report = key_blocks(scene.model, question);
  report.without_merging = types_without_merging(request);
  std::string text = report_text(report, question, scene.model);
  if (!request.folder.empty()) {
    const std::string picture = keyblocks_picture(report, question, scene.model);
    const std::string numbers = report_json(report, question, scene.model);
    write_file(request.folder / "keyblocks.json", numbers);
    write_file(request.folder / "keyblocks.svg", picture);
    text += fmt::format("written: {}\n", (request.folder / "keyblocks.json").string());
  }
  out << text;
}

}  // namespace dda
