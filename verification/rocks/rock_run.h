// Runs a rock as `dda run` does and judges it by what does not come from the rules that it was run by.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/model/state.h"
#include "verification/harness/check.h"
#include "verification/rocks/random_rock.h"

namespace verify {

enum class RockOutcome {
  right,    // went through, and every check holds
  stopped,  // ended early, and said why
  refused,  // was not begun, and said why
  late,     // did not come to its end in the time that it was given
  warned,   // went through, a check fails, and something was said
  wrong     // went through, a check fails, and nothing was said
};

inline constexpr std::array all_rock_outcomes{RockOutcome::right, RockOutcome::stopped, RockOutcome::refused,
                                              RockOutcome::late,  RockOutcome::warned,  RockOutcome::wrong};

[[nodiscard]] std::string name_of(RockOutcome outcome);

struct RockResult {
  std::uint64_t seed = 0;
  RockKind kind = RockKind::two_sets;
  RockOutcome outcome = RockOutcome::right;
  std::string message;
  std::vector<Check> checks;
  std::vector<std::string> said;  // warnings
  std::size_t blocks = 0, loose = 0;
  std::int64_t steps = 0, passes = 0;
  double settling_s = 0, cpu_s = 0;

  // Of what is not right: what the run said, or the first check that fails.
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
