#include "verification/differential/differential_command.h"

#include <fmt/format.h>

#include <map>
#include <ostream>

#include "engine/record/atomic_file.h"
#include "verification/differential/comparison.h"
#include "verification/differential/random_scene.h"
#include "verification/study/jobs.h"

namespace verify {
namespace {

void keep_scene(const nlohmann::ordered_json& scene, std::uint64_t seed, const std::filesystem::path& folder) {
  if (folder.empty()) return;
  std::filesystem::create_directories(folder);
  dda::write_file(folder / fmt::format("seed_{}.json", seed), scene.dump(1) + "\n");
}

}  // namespace

int compare_scenes(const DifferentialCommand& command, std::ostream& out, std::ostream& errors) {
  std::map<Agreement, std::size_t> counts;
  const auto seed_of = [&](std::size_t i) { return command.seed + i; };
  const auto run = [&](std::size_t i) {
    const Comparison comparison = compare_runs(random_scene(seed_of(i)));
    return nlohmann::ordered_json{{"agreement", comparison.agreement}, {"what", comparison.what}}.dump();
  };
  run_jobs(static_cast<std::size_t>(command.count), command.jobs, run, [&](std::size_t i, const std::string& text) {
    const auto json = nlohmann::ordered_json::parse(text);
    const auto agreement = json.at("agreement").get<Agreement>();
    const std::string what = json.at("what");
    ++counts[agreement];
    if (command.verbose) out << fmt::format("seed {}: {} {}\n", seed_of(i), name_of(agreement), what);
    if (agreement != Agreement::differs) return;
    errors << fmt::format("dda-verify: seed {}: {}\n", seed_of(i), what);
    keep_scene(random_scene(seed_of(i)), seed_of(i), command.folder);
  });
  for (const auto& [agreement, count] : counts) out << fmt::format("{:6} {}\n", count, name_of(agreement));
  return counts[Agreement::differs] > 0 ? 1 : 0;
}

StudyCommand differential_command() {
  return study_command<DifferentialCommand>(
      "differential",
      "Random small scenes of mixed features, run with each linear solver, with a stop half-way and with two threads: "
      "they must agree to 1e-9, or it is said why not.\nExit code 1 if runs of a scene differ; each is told with its "
      "seed.",
      [](DifferentialCommand& a) {
        std::vector<CommandOption> options;
        add_lots(a.seed, "scene", a.count, options);
        options.push_back({"--out", &a.folder, "folder for scenes whose runs differ"});
        options.push_back({"--verbose", &a.verbose, "a line for every scene"});
        options.push_back(jobs_at_once(a.jobs, "scenes at once, each a process of its own; default: 1"));
        return options;
      },
      [](const DifferentialCommand& a, const Surroundings& s) { return compare_scenes(a, s.out, s.errors); });
}

}  // namespace verify
