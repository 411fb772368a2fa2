#include "verification/rocks/rocks_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "engine/record/atomic_file.h"
#include "engine/record/progress.h"
#include "verification/rocks/rocks_report.h"

namespace verify {
namespace {

void keep_scene(const RandomRock& rock, const std::filesystem::path& folder) {
  dda::write_file(folder / "scenes" / fmt::format("seed_{}.json", rock.seed), rock.scene);
}

// One picture a kind: the first rock of it that has come to its end.
void keep_picture(const RockResult& result, const RockPicture& picture, const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "images" / picture_of(result.kind);
  if (result.outcome == RockOutcome::right && !std::filesystem::exists(file)) dda::write_file(file, to_svg(picture));
}

void tell(const RockResult& result, std::ostream& errors) {
  errors << fmt::format("dda-verify: seed {}, {}: {}: {}\n", result.seed, name_of(result.kind), name_of(result.outcome),
                        result.reason());
}

}  // namespace

int run_rocks(const RocksCommand& command, std::ostream& out, std::ostream& errors) {
  std::filesystem::create_directories(command.folder / "scenes");
  std::filesystem::create_directories(command.folder / "images");
  std::vector<RockResult> results;
  dda::Progress progress(0, command.count, dda::terminal());
  for (int i = 0; i < command.count; ++i) {
    const RandomRock rock = random_rock(command.seed + static_cast<std::uint64_t>(i), command.family);
    RockPicture picture;
    results.push_back(run_rock(rock, command.seconds, &picture));
    keep_picture(results.back(), picture, command.folder);
    if (results.back().outcome != RockOutcome::right) {
      keep_scene(rock, command.folder);
      tell(results.back(), errors);
    }
    progress.update(i + 1, i + 1);
  }
  dda::write_file(command.folder / "rocks.json", to_json(results));
  dda::write_file(command.folder / "rocks.md", to_page(results));
  for (const RockOutcome outcome : all_rock_outcomes)
    out << fmt::format("{:5} {}\n", std::ranges::count(results, outcome, &RockResult::outcome), name_of(outcome));
  return std::ranges::count(results, RockOutcome::wrong, &RockResult::outcome) > 0 ? 1 : 0;
}

}  // namespace verify
