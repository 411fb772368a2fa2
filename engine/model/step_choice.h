// The time step of dynamic stages that leave it to the engine ("dt": "auto").
//
// Chosen once for a stage, from the model alone, as the smallest of what follows, rounded down to 1, 2 or 5 times a
// power of ten; what happens within a step (contacts that do not settle, blocks that turn far) is the halving of steps'
// to mend.
//
//   waves     time steps may change speed and amplitude of a wave of the highest frequency of loads and prescribed
//             motions (or of `target_frequency`) by 0.2 % on its way across the scene, by the integrator's own
//             amplification of an oscillator. In a table a rise or fall, as steep all along as it is at its steepest,
//             is a quarter of a period; so in a recording, where those of less than half of its peak count for nothing
//   records   no longer than the interval of a recording's samples
//   fall      where blocks can part: 1 % of the time sqrt(size/g) in which a block topples or falls by its size
//   flight    where blocks can part: 1 % of the time in which the fastest block flies its size; blocks start with their
//             initial velocity, or are set moving by the pressure at hand, at p/(rho c)
//   release   where rock is removed or supports let go at once, stress begins to act, or joints get their own strength
//             after a stage of unlimited strength: an eighth of the time of a wave through a block. Rock around an
//             opening of 2 m got 14 % of its energy from nowhere in steps of five such times, which is what falling
//             blocks ask for, and steps of half of one took up to a half of the energy of blocks that are thrown. That
//             limits the first steps only: they grow with the time since then (first_steps.h) up to what the others
//             ask for
//   transit   where none of these says anything: half the time of a wave through a block
//
// at least a twentieth of the time of a wave through a block, and at least 100 steps a stage. `size` is the side of the
// square of a block's area; blocks smaller than it make up 5 % of the rock, so that a sliver slows no scene down.
#pragma once

#include <optional>
#include <string>

#include "engine/model/model.h"

namespace dda {

struct StepErrors {
  double speed = 0;      // relative, of a wave with continuous blocks: the period error's opposite
  double amplitude = 0;  // lost in one period, relative
};

// The errors of an oscillator stepped at theta = 2 pi dt/period.
StepErrors step_errors(const Integrator& integrator, double theta);

// The fastest change of loads and prescribed motions (or `target_frequency`) as a wave; nothing where none changes.
struct FastestWave {
  double frequency = 0;  // Hz; a rise or fall of a table, as if steepest all along, is a quarter of a period
  StepErrors errors;     // by the integrator and dt of a stage
};
std::optional<FastestWave> fastest_wave(const Model& model, const Stage& stage, double dt);

// Sets dt, its first steps and its reason in stages whose dt is chosen (chosen.dt.automatic).
void choose_time_steps(Model& model);

// "2e-05 s", or "2e-05 to 0.0004 s" where steps grow from `first_dt` to `dt` (s).
std::string in_words(double first_dt, double dt);

}  // namespace dda
