#include "verification/differential/differential_command.h"

#include <fmt/format.h>

#include <map>
#include <ostream>

#include "engine/record/atomic_file.h"
#include "verification/differential/comparison.h"
#include "verification/differential/random_scene.h"

namespace verify {
namespace {

void keep_scene(const nlohmann::ordered_json& scene, std::uint64_t seed, const std::filesystem::path& folder) {
  if (folder.empty()) return;
  std::filesystem::create_directories(folder);
  dda::write_file(folder / fmt::format("seed_{}.json", seed), scene.dump(1) + "\n");
}

}  // namespace

int compare_scenes(const DifferentialCommand& command, std::ostream& out, std::ostream& errors) {
  std::map<Agreement, int> counts;
  for (int i = 0; i < command.count; ++i) {
    const std::uint64_t seed = command.seed + static_cast<std::uint64_t>(i);
    const nlohmann::ordered_json scene = random_scene(seed);
    const Comparison comparison = compare_runs(scene);
    ++counts[comparison.agreement];
    if (command.verbose) out << fmt::format("seed {}: {} {}\n", seed, name_of(comparison.agreement), comparison.what);
    if (comparison.agreement != Agreement::differs) continue;
    errors << fmt::format("dda-verify: seed {}: {}\n", seed, comparison.what);
    keep_scene(scene, seed, command.folder);
  }
  for (const auto& [agreement, count] : counts) out << fmt::format("{:6} {}\n", count, name_of(agreement));
  return counts[Agreement::differs] > 0 ? 1 : 0;
}

}  // namespace verify
