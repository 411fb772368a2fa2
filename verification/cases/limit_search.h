// Whether a scene stands, and the strength or size at which it just does.
#pragma once

#include <functional>
#include <string>

#include "engine/model/model.h"
#include "verification/suite/case.h"
#include "verification/suite/expect.h"

namespace verify {

// Springs of 1000 E at every corner of a block, the default of scenes, that follow displacement * history: abutments
// whose giving way must not count.
void hold_firmly(dda::Model& model, int block, const dda::Vec2& displacement = dda::Vec2::Zero(),
                 const dda::TimeFunction& history = dda::Constant{});

// Two static stages of `step`: weight and loads come on while contacts stick, then joints have their strength and
// equilibrium to 1e-9 of the largest load is sought in at most `steps` steps.
void let_stand(dda::Model& model, double step, int steps);

// True when every stage ends in the equilibrium it asks for; false as soon as a centroid has moved by `far` (m), or at
// the end without equilibrium. Throws std::runtime_error when a step fails.
[[nodiscard]] bool stands(dda::Model model, double far, Outcome& outcome);

// Values of a parameter between which a scene ceases to stand.
struct Bracket {
  double falls = 0;
  double stands = 0;

  [[nodiscard]] double middle() const { return (falls + stands) / 2; }
};

// Halves the bracket until it is narrower than `width`. Both ends are tried first: throws std::runtime_error when they
// do not do what they are said to.
[[nodiscard]] Bracket bisect(Bracket bracket, double width, const std::function<bool(double)>& stands_at);

// The middle of the bracket against the reference, with the error of both ends of a bracket that encloses it, or of the
// end that has passed it: the larger.
[[nodiscard]] Expectation bracketed(const Quantity& quantity, const Bracket& bracket, double reference,
                                    const std::string& source);

}  // namespace verify
