// How long the steps of a static stage are that has no dt of the user's.
//
// A static step solves (c_m M + K) d = forces out of balance, c_m = 2/dt^2: the longer it is, the nearer it comes to
// equilibrium, and the more contacts change in it. Unit of all lengths is the transit time T of the scene, its diameter
// over the slowest speed sqrt(E/rho) of its rock: the slowest mode of closely joined blocks has a period of some T, so
// a step of r T divides what is out of balance by about (pi r)^2/2. Where contacts cannot slide and
// blocks keep their geometry a step is a convex problem (or a linear one), which is solved at any length: steps begin
// long. With friction they begin short, grow as the open-close iteration settles easily, and shrink where it does not,
// or only after many passes; so they do where blocks move, as one long step can open many joints at once, after which
// they close elsewhere. They grow fast until one was too long, and from then on slowly: else the next one is as much
// too long again, and again (a wall of 5,000 bricks tried eight times the length that settles in each of 20 steps).
// Where loads come in parts steps must be long again before the next part, and always grow fast.
// What weight alone holds has a slower mode, with a period of some sqrt(D/g), D the diameter: steps may be longer then.
// Where they come at once one long step is tried before the first short one, and taken if next to nothing slips in it
// (hardly_slips.h): what inertia holds back in the short ones makes contacts slip that the whole load presses together.
// Where something yields or breaks it is tried with the first part of loads too, as weight comes at once with that.
#pragma once

#include <cstdint>

#include "engine/core/counters.h"
#include "engine/core/status.h"
#include "engine/model/model.h"
#include "engine/simulation/step.h"

namespace dda {

// s, of the first step that a stage tries: its dt, or its own pace. `contacts_can_change`: some joint can open or
// slide.
double first_step(const Model& model, const Stage& stage, bool contacts_can_change);

class SettlingPace {
 public:
  // Begins a stage that paces itself, with loads in one part or in more.
  void begin(const Model& model, const Stage& stage, bool contacts_can_change, bool in_parts);

  [[nodiscard]] double dt() const { return dt_; }  // s, of the next step

  // Takes a step as long as it can be, by `advance(dt, taken)`.
  template <typename Advance, typename IsSure>
  [[nodiscard]] Status step(const Counters& counters, const Advance& advance, const IsSure& is_sure) {
    while (true) {
      const std::int64_t passes_before = counters.open_close_iterations;
      const Status status = advance(dt_, taken());
      if (tries_) {
        tried(status == Status::ok);
        if (status != Status::ok) continue;  // a try never ends a run
      }
      if (status == Status::ok) settled(counters.open_close_iterations - passes_before, is_sure());
      // In long steps what touches nothing for a moment has so little inertia that the matrix is singular by round-off.
      const bool is_too_long = status == Status::not_converged || status == Status::singular;
      if (!is_too_long || !shorten()) return status;
    }
  }

  // A step of dt() settled in that many passes of the open-close iteration.
  // `is_sure`: at any length (with friction given by its start), so that passes say nothing of that.
  void settled(std::int64_t passes, bool is_sure);
  // One did not; false when there is no shorter one to try.
  [[nodiscard]] bool shorten();
  [[nodiscard]] bool is_shortest() const;
  [[nodiscard]] bool is_long() const;
  // What the next step is taken for.
  [[nodiscard]] Taken taken() const;

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [transit, longest, dt, growth, is_convex, in_parts, tries] = self;
    archive(transit, longest, dt, growth, is_convex, in_parts, tries);
  }

 private:
  // The long step that is tried first was taken, or not.
  void tried(bool was_taken);

  double transit_ = 0;      // s
  double longest_ = 0;      // s, that a step can be
  double dt_ = 0;           // s
  double growth_ = 1;       // of dt_ after a step that settled easily
  bool is_convex_ = false;  // steps settle at any length, whatever it takes
  bool in_parts_ = false;   // loads come in parts
  bool tries_ = false;      // the next step is a long one that is taken only if next to nothing slips
};

}  // namespace dda
