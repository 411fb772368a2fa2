// How loads and motions get to the end of a static stage that finds its own steps: part by part, the next one when what
// the last one has put out of balance is at rest, or will not come to rest. So what slides, opens or yields under them
// does so at its own load, and their work is that of a slow change. Until steps are long there is no part: inertia is
// nothing in long ones alone, and in short ones would hold blocks back from what they stand on and let them slide.
#pragma once

#include <algorithm>

namespace dda {

struct LoadParts {
  int all = 1;
  int gone = 0;    // by the loads as they are
  int waited = 0;  // steps since the last one that took a part
  bool waits = false;
  double moved = 0;  // by the step that took the last part: of the block that moved most, in its own size

  [[nodiscard]] double share() const { return static_cast<double>(gone) / all; }
  [[nodiscard]] double next_share() const { return static_cast<double>(next()) / all; }

  // Steps taken with the loads of the next step: none where that goes on to another part.
  [[nodiscard]] int steps_of_part() const { return gone == next() ? waited + 1 : 0; }

  void begin(int parts) { *this = {.all = parts, .waits = parts > 1}; }

  // A step was taken that moved blocks by so much. `is_ready`: for the next part.
  void follow(bool is_ready, double motion) {
    constexpr int most_waited = 4;
    const bool took_one = gone != next();
    waited = took_one ? 0 : waited + 1;
    if (took_one) moved = motion;
    gone = next();
    waits = !is_ready && waited < most_waited;
  }

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [all, gone, waited, waits, moved] = self;
    archive(all, gone, waited, waits, moved);
  }

 private:
  [[nodiscard]] int next() const { return waits ? gone : std::min(all, gone + 1); }
};

}  // namespace dda
