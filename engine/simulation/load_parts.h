// How loads and motions get to the end of a static stage that finds its own steps: part by part, the next one when what
// the last one has put out of balance is at rest, or will not come to rest. So what slides, opens or yields under them
// does so at its own load, and their work is that of a slow change.
#pragma once

#include <algorithm>

namespace dda {

struct LoadParts {
  int all = 1;
  int gone = 0;    // by the loads as they are
  int waited = 0;  // steps since the last one that took a part
  bool waits = false;

  [[nodiscard]] double share() const { return static_cast<double>(gone) / all; }
  [[nodiscard]] double next_share() const { return static_cast<double>(next()) / all; }

  // A step was taken.
  void follow(bool is_at_rest) {
    constexpr int most_waited = 4;
    waited = gone == next() ? waited + 1 : 0;
    gone = next();
    waits = !is_at_rest && waited < most_waited;
  }

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [all, gone, waited, waits] = self;
    archive(all, gone, waited, waits);
  }

 private:
  [[nodiscard]] int next() const { return waits ? gone : std::min(all, gone + 1); }
};

}  // namespace dda
