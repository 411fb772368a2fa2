// What accelerations remember of impacts in a step that is cut, when steps are longer again.
//
// The generalized-alpha method balances forces with a mean of the accelerations at both ends of a step. So what a step
// has found goes on in the next ones, and each turns it into velocity in proportion to its dt. After an impact in a
// short part of a step that was cut, the longer ones that follow would make several times the velocity of it that the
// impact has left to give: two free blocks flew apart up to 3.2 times as fast as they had met. So what an impact has
// changed of the accelerations of the blocks that it hit shrinks as the steps grow: it gives what it would have given
// in steps as short as its own. Blocks that nothing has hit keep theirs, whatever the steps were cut for: of a smooth
// motion they would only lose what holds it back (ADR 66).
//
// What contacts have changed of the accelerations of blocks that hang together is in balance. So it shrinks in all of
// them by the same share and in all their unknowns, and where no held block is among them the mean of their
// accelerations stays as it is, that of an earlier impact with others included: else later steps would turn the
// difference into momentum.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/contact/contact_set.h"
#include "engine/core/status.h"
#include "engine/core/types.h"
#include "engine/terms/inertia.h"

namespace dda {

class AccelerationMemory {
 public:
  // Before the first part of a step that is cut. Blocks without mass are held: what acts on them acts on nothing else.
  void begin(const std::vector<Inertia>& inertia, const ContactSet& contacts, const std::vector<Vec6>& acceleration);

  // Before a part of length `dt` (s) is tried; and when it has failed.
  void begin_part(double dt, std::vector<Vec6>& acceleration);
  void take_back(std::vector<Vec6>& acceleration) const { acceleration = before_; }
  // It is done: blocks of which a contact has closed or opened in it have been hit.
  void end_part(double dt, const ContactSet& contacts);

  // A part of length `dt` (s) that `take()` takes.
  template <typename Take>
  [[nodiscard]] Status part(double dt, const ContactSet& contacts, std::vector<Vec6>& acceleration, const Take& take) {
    begin_part(dt, acceleration);
    const Status status = take();
    if (status == Status::ok)
      end_part(dt, contacts);
    else
      take_back(acceleration);
    return status;
  }

  // All parts are done, and the next step has the length `dt`.
  void end(double dt, std::vector<Vec6>& acceleration) { shrink(dt, acceleration); }

 private:
  void shrink(double dt, std::vector<Vec6>& acceleration);
  void join(const ContactSet& contacts);
  void sum_gains(const std::vector<Vec6>& acceleration);
  void shrink_gains(double share, std::vector<Vec6>& acceleration);
  [[nodiscard]] std::size_t body_of(std::size_t block);
  void note_hits();

  enum class Hit : char { none, begun, ended };

  // What hangs together, as far as it was hit.
  struct Body {
    double mass = 0;            // kg per m of thickness
    double gained = 0;          // what a M a, twice an energy over s^2, has grown by since it was hit
    Vec2 taken = Vec2::Zero();  // N per m of thickness, of the inertia forces, by what shrinks
    bool touches_held = false;
  };

  std::vector<Inertia> inertia_;
  std::vector<int> closed_;          // ends of contacts of each block, after the last part
  std::vector<int> was_closed_;      // after the one before it
  std::vector<std::size_t> bodies_;  // of each block another one that it has touched in this step, or itself
  std::vector<Hit> hits_;            // in the last part, of each body
  std::vector<char> was_hit_;        // in this step, of each block
  std::vector<char> touched_held_;   // in this step, of each block
  std::vector<Body> sums_;           // of each body
  std::vector<Vec6> start_;   // of blocks that were hit, before the part in which they were hit first, or the step
  std::vector<Vec6> before_;  // the part that is tried
  double last_dt_ = 0;        // s, of the last part done; 0 before there was one
};

}  // namespace dda
