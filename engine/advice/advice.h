// What a scene will be worth before it is run: how wrong its waves will be and why, what it will cost, and how coarse
// it may be for a wanted error.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/advice/explicit_offer.h"
#include "engine/advice/limits.h"
#include "engine/advice/wave_errors.h"
#include "engine/simulation/stage_cost.h"

namespace dda {

struct AdviceQuestion {
  std::optional<double> frequency;  // Hz, of a steady wave; else the scene's load history, or its target_frequency
  std::optional<double> distance;   // m; else from the load to the farthest measurement, or one wavelength
  double error = 0.01;              // wanted, relative
  bool limits = true;               // look for the coarsest dt and blocks, which takes longer than all the rest
};

struct WaveAdvice {
  std::string material, kind;  // "bar", "P" or "S"
  std::string mesh;            // what the errors are those of
  bool own_layers = false;     // of the scene, as they are; else of blocks that repeat themselves
  Vec2 direction = Vec2::UnitX();
  std::string direction_name;
  double speed = 0, wavelength = 0;  // m/s and m, of the continuous material
  double block_size = 0;             // m, along the direction
  double distance = 0;               // m
  std::optional<SteadyErrors> steady;
  std::optional<HistoryErrors> history;
  bool asked_history = false;
  std::string not_foretold;  // a sentence; empty where the history is foretold
  std::optional<WaveLimits> limits;

  // The terms that count: of the load history where there is one.
  [[nodiscard]] const ErrorTerms* speed_error() const;
  [[nodiscard]] const ErrorTerms* amplitude_error() const;
  // "block size", "interfaces", "time steps", "damping" or "sides": the largest term of speed and amplitude; empty
  // where nothing arrives.
  [[nodiscard]] std::string cause() const;
};

struct StageAdvice {
  std::string name, integrator;
  std::string why_integrator;   // a phrase, where the engine chose between implicit and explicit steps
  double first_dt = 0, dt = 0;  // s, of the first steps and of the last: shorter where steps grow
  StiffnessNumbers chi;
  std::string solver;
  StageCost cost;
  double stable_dt = 0;  // s, up to which explicit steps are stable; 0 where steps are implicit
  std::optional<ExplicitOffer> explicit_instead;  // where explicit steps would be cheaper than these
  double damping_ratio = 0;                       // of the material, at the frequency of the waves
  std::vector<WaveAdvice> waves;                  // none in static stages
};

struct Advice {
  std::optional<double> frequency;  // Hz; none: the scene has no wave to speak of
  std::string load;                 // empty: a steady wave is meant
  double wanted_error = 0;
  SceneSize size;
  bool joints_may_open = false;
  bool damped = false;              // some stage damps velocities
  std::vector<std::string> unseen;  // sentences of loads that time steps pass over
  std::vector<std::string> sudden;  // and of loads that jump
  std::string springs;              // a sentence on springs in the way of waves, or empty
  std::vector<StageAdvice> stages;
};

// For people: all of it, and the lines that `dda check` prints.
std::string to_text(const Advice& advice);
std::vector<std::string> to_short_text(const Advice& advice);
// For programs: SI units, errors relative; null where there is none.
std::string to_json_text(const Advice& advice);

}  // namespace dda
