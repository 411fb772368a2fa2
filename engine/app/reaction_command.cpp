#include "engine/app/reaction_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstddef>
#include <optional>
#include <ostream>

#include "engine/app/named_opening.h"
#include "engine/app/reaction_picture.h"
#include "engine/app/reaction_report.h"
#include "engine/core/error.h"
#include "engine/record/atomic_file.h"
#include "engine/record/csv.h"
#include "engine/record/reserved_folder.h"
#include "engine/scene/scene_parts.h"

namespace dda {
namespace {

constexpr auto details =
    "Lets the rock settle in situ, takes the opening out, and finds the equilibrium of the rock for shares of what "
    "the\n"
    "opening exerted on it, from 1 to 0: how far the wall comes in at which support pressure. DIR gets reaction.json,\n"
    "reaction.csv and reaction.svg, the curves.\n\n"
    "Examples:\n"
    "  dda reaction tunnel.json --opening tunnel --out reaction\n"
    "  dda reaction tunnel.json --opening tunnel --steps 20\n"
    "  dda reaction tunnel.json --opening tunnel --shares 1,0.5,0.2,0.1,0\n";

constexpr int most_steps = 1000;
constexpr int exit_ended_early = 3;

const std::vector<const char*> file_names{"reaction.json", "reaction.csv", "reaction.svg"};

std::vector<double> equal_steps(int steps) {
  if (!(steps >= 1 && steps <= most_steps))
    throw InputError("", "--steps", std::to_string(steps), fmt::format("a whole number from 1 to {}", most_steps));
  std::vector<double> shares;
  for (int i = steps; i >= 0; --i) shares.push_back(static_cast<double>(i) / steps);
  return shares;
}

// The texts between commas; one behind the last comma is empty where nothing follows.
std::vector<std::string> parts_of(const std::string& list) {
  std::vector<std::string> parts(1);
  for (const char letter : list) {
    if (letter == ',')
      parts.emplace_back();
    else
      parts.back() += letter;
  }
  return parts;
}

std::vector<double> shares_of(const ReactionRequest& request) {
  if (request.shares.empty()) return equal_steps(request.steps);
  std::vector<double> shares;
  for (const std::string& part : parts_of(request.shares)) {
    const std::optional<double> share = csv_number(part);
    const double before = shares.empty() ? 1 : shares.back();
    const bool falls = share && (shares.empty() ? *share <= before : *share < before);
    if (!(falls && *share >= 0))  // nor is what is no number
      throw InputError("", "--shares",
                       fmt::format("{} in place {}", share ? part : "\"" + part + "\"", shares.size() + 1),
                       "numbers from 1 to 0, each less than the one before");
    shares.push_back(*share);
  }
  return shares;
}

void say(const ReactionPoint& point, std::ostream& progress) {
  progress << fmt::format("share {:.4g}: {}\n", point.share,
                          point.settles() ? fmt::format("the wall comes in by {:.4g} mm", 1e3 * point.motion.mean)
                                          : "does not come to rest");
  progress.flush();
}

ReactionCurve answer(const ReactionRequest& request, const ReactionQuestion& question, const Model& model,
                     std::ostream& progress) {
  try {
    return ground_reaction(model, question, [&](const ReactionPoint& point) { say(point, progress); });
  } catch (const InputError& error) {  // of stages that the scene does not have
    throw InputError(request.scene.string(),
                     fmt::format("with \"{}\" taken out by dda reaction, {}", request.opening, error.field()),
                     error.value(), error.expected());
  }
}

void write_files(const std::filesystem::path& folder, const ReactionCurve& curve, const std::string& opening,
                 const Model& model) {
  const std::string numbers = reaction_json(curve, opening, model);
  const std::string table = reaction_csv(curve);
  const std::string picture = reaction_picture(curve);
  std::size_t next = 0;
  for (const std::string& text : {numbers, table, picture}) write_file(folder / file_names[next++], text);
}

}  // namespace

void add_reaction(CLI::App& app, ReactionRequest& request) {
  CLI::App* command = app.add_subcommand("reaction", "Find the ground reaction curve of an opening")->footer(details);
  const auto add = [command](const char* name, auto& value, const char* help, const char* type) {
    return command->add_option(name, value, help)->type_name(type);
  };
  add("scene", request.scene, "scene file (JSON)", "SCENE.json")->required();
  add("--opening", request.opening, "an opening of the rock, or a group of blocks, that is taken out", "NAME")
      ->required();
  add("--out", request.folder, "folder for the results; made if need be", "DIR");
  CLI::Option* steps = add("--steps", request.steps, "equal ones from a share of 1 to 0; default 10", "N");
  add("--shares", request.shares, "in place of equal steps: from 1 to 0, decreasing", "SHARE,...")->excludes(steps);
}

int find_ground_reaction(const ReactionRequest& request, std::ostream& out, std::ostream& progress) {
  const SceneParts scene = read_scene_parts(request.scene);
  const ReactionQuestion question{blocks_of_opening(request.opening, scene), shares_of(request)};
  expect_one_opening(request.opening, question.opening, scene.model);
  const ReservedFolder folder(request.folder, file_names);
  const ReactionCurve curve = answer(request, question, scene.model, progress);
  if (curve.in_situ != Status::ok) {
    progress << fmt::format("dda: the rock does not settle before \"{}\" is taken out: {}\n", request.opening,
                            curve.message);
    return exit_ended_early;
  }
  std::string text = reaction_text(curve, request.opening, scene.model);
  if (!request.folder.empty()) {
    write_files(request.folder, curve, request.opening, scene.model);
    text += fmt::format("written: {}\n", (request.folder / "reaction.json").string());
  }
  out << text;
  return 0;
}

}  // namespace dda
