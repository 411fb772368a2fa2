#include "verification/rocks/rocks_command.h"

#include <fmt/format.h>

#include <ostream>

#include "engine/record/atomic_file.h"
#include "verification/rocks/rocks_report.h"
#include "verification/study/jobs.h"

namespace verify {
namespace {

void keep_scene(const RandomRock& rock, const std::filesystem::path& folder) {
  dda::write_file(folder / "scenes" / fmt::format("seed_{}.json", rock.seed), rock.scene);
}

// What a job hands over: its result, and its picture where it is right.
std::string text_of(const RandomRock& rock, double seconds) {
  RockPicture picture;
  const RockResult result = run_rock(rock, seconds, &picture);
  nlohmann::ordered_json json = json_of(result);
  if (result.outcome == RunOutcome::right) json["picture"] = to_svg(picture);
  return json.dump();
}

// One picture a kind: the first rock of it that has come to its end.
void keep_picture(const RockResult& result, const nlohmann::ordered_json& json, const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "images" / picture_of(result.kind);
  if (json.contains("picture") && !std::filesystem::exists(file))
    dda::write_file(file, json.at("picture").get<std::string>());
}

void tell(const RockResult& result, std::ostream& errors) {
  errors << fmt::format("dda-verify: seed {}, {}: {}: {}\n", result.seed, name_of(result.kind), name_of(result.outcome),
                        result.reason());
}

// Kinds of joints are flags on the command line.
struct RocksArguments {
  RocksCommand command;
  bool dilating = false, springs = false, compliant = false;
};

std::vector<CommandOption> options_of(RocksArguments& a) {
  std::vector<CommandOption> options{out_folder(a.command.folder)};
  add_lots(a.command.seed, "rock", a.command.count, options);
  options.push_back({"--dilating", &a.dilating, "smaller rocks, with joints that ride up as they slide"});
  options.push_back({"--springs", &a.springs, "joints with springs, the classical law"});
  options.push_back({"--compliant", &a.compliant, "joints that give way by a stiffness per area of their own"});
  options.push_back({.name = "--extent",
                     .target = &a.command.family.extent,
                     .help = "times as wide and high, with joints as far apart: its square times as many blocks",
                     .shows_default = true,
                     .range = {{0.5, 20.0}}});
  options.push_back({.name = "--seconds",
                     .target = &a.command.seconds,
                     .help = "of CPU time, the most that a rock is given",
                     .shows_default = true,
                     .positive = true});
  options.push_back(jobs_at_once(a.command.jobs, "rocks at once, each a process of its own; default: 1"));
  return options;
}

}  // namespace

int run_rocks(const RocksCommand& command, std::ostream& out, std::ostream& errors) {
  std::filesystem::create_directories(command.folder / "scenes");
  std::filesystem::create_directories(command.folder / "images");
  std::vector<RockResult> results;
  const auto rock = [&](std::size_t i) { return random_rock(command.seed + i, command.family); };
  const auto run = [&](std::size_t i) { return text_of(rock(i), command.seconds); };
  run_jobs(static_cast<std::size_t>(command.count), command.jobs, run, [&](std::size_t i, const std::string& text) {
    const auto json = nlohmann::ordered_json::parse(text);
    const RockResult& result = results.emplace_back(rock_result_from(json));
    keep_picture(result, json, command.folder);
    if (result.outcome == RunOutcome::right) return;
    keep_scene(rock(i), command.folder);
    tell(result, errors);
  });
  dda::write_file(command.folder / "rocks.json", to_json(results));
  dda::write_file(command.folder / "rocks.md", to_page(results));
  out << counts_of(results, rock_outcomes());
  return count_of(results, RunOutcome::silent) > 0 ? 1 : 0;
}

StudyCommand rocks_command() {
  return study_command<RocksArguments>(
      "rocks",
      "Rock cut by lot - joint sets, traces, grains, openings, excavations, slopes, shaken walls - settles and moves, "
      "and is judged by outlines, weights, Coulomb's law and speeds.\nWrites rocks.json, rocks.md, images/ and the "
      "scenes that are not right. Exit code 1 if a rock is wrong in silence.",
      options_of, [](const RocksArguments& a, const Surroundings& s) {
        RocksCommand command = a.command;
        if (a.dilating) command.family.joints = RockJoints::dilating;
        if (a.springs) command.family.joints = RockJoints::springs;
        if (a.compliant) command.family.joints = RockJoints::compliant;
        return run_rocks(command, s.out, s.errors);
      });
}

}  // namespace verify
