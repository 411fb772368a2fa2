// Runs a rock as `dda run` does and judges it by what does not come from the rules that it was run by.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/model/state.h"
#include "verification/rocks/random_rock.h"
#include "verification/study/judged_run.h"

namespace verify {

[[nodiscard]] const OutcomeNames& rock_outcomes();
[[nodiscard]] inline const std::string& name_of(RunOutcome outcome) { return name_of(outcome, rock_outcomes()); }

struct RockResult : JudgedRun {
  std::uint64_t seed = 0;
  RockKind kind = RockKind::two_sets;
  std::size_t blocks = 0, loose = 0;
  std::int64_t steps = 0, passes = 0;
  double settling_s = 0;

  // Why it is not right: what the run said, or the first check that fails.
  [[nodiscard]] std::string reason() const { return message.empty() ? first_failure(checks) : message; }
};

// What pictures are made of: outlines as drawn, and where their corners were at the end.
struct RockPicture {
  std::vector<dda::Polygon> drawn, moved;
  std::vector<bool> is_loose, is_held, is_removed;  // the last of them by the end
};

// Ends as `late` after `seconds` of CPU time. Fills `picture` where it is given.
[[nodiscard]] RockResult run_rock(const RandomRock& rock, double seconds, RockPicture* picture = nullptr);

}  // namespace verify
