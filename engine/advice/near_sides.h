// What the sides of a mesh do to a wave in its middle. A mesh without sides carries a plane wave, and so do sides that
// give the wave its motion, as rollers do. Springs at joints let blocks turn and slide past each other, which rollers
// do not; and sides that are free, or absorb, take from a wave. Either is felt in the middle once a wave from there has
// had the time to come. What is then seen is found by steps, as a run takes them, for as long as the wave is read (ADR
// 76).
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/advice/load_history.h"
#include "engine/advice/plane_wave.h"
#include "engine/advice/wave_errors.h"
#include "engine/contact/contact_set.h"
#include "engine/model/model.h"

namespace dda {

struct MeshPlace {
  Vec2 direction = Vec2::UnitX();  // unit, of the wave
  WaveKind kind = WaveKind::p;
  double distance = 0;  // m, along the way, to the joint that is looked at
  double unit = 1;      // Pa: that what is seen there is told over
};

// A stage that waves are foretold in.
struct Course {
  Stage stage;
  std::size_t index = 0;  // of the model
  double stable_dt = 0;   // s, up to which explicit steps are stable; else 0
  double step_cost = 0;   // s of CPU time
};

// What is read off a trace of the stress at the place, which has the stage's dt.
using ReadTrace = std::function<std::optional<ArrivalErrors>(const std::vector<double>&)>;

struct BetweenSides {
  HistoryErrors history;
  std::string why_not;  // a clause for people, where the history cannot be foretold
};

class NearSides {
 public:
  // `drawn`: contacts of the model as drawn.
  NearSides(const Model& model, const ContactSet& drawn, const SceneLoad& load, const Course& course)
      : model_(model), drawn_(drawn), load_(load), stage_(course.stage), course_(course) {}

  // `history` is foretold as if there were no sides, and looked at for `window` (s). Steps that take longer than a
  // second are not taken; then sides that are farther away than the wave runs count for nothing, nor rollers beside a
  // P wave, and what lies between the sides and is none of the mesh (a hole, a block that is held) is said.
  [[nodiscard]] BetweenSides count(const HistoryErrors& history, const MeshPlace& place, double window,
                                   const ReadTrace& read) const;

 private:
  // m, across the way to the nearer one.
  [[nodiscard]] double distance(const MeshPlace& place) const;
  // Whether anything that begins at them can be seen at the place within `window` (s) of the load's begin.
  [[nodiscard]] bool are_felt(const MeshPlace& place, double window) const;
  // The stress at the place at 0, dt, 2 dt, ... after the load's begin, by steps of the scene's own blocks, whose
  // joints stay closed and stuck. Nothing where the scene has what belongs to several stages.
  [[nodiscard]] std::optional<std::vector<double>> stepped(const MeshPlace& place, double window) const;
  // A clause on what holds or is free between the sides, and is met in time to be seen; empty where nothing is.
  [[nodiscard]] std::string met_inside(const MeshPlace& place, double window) const;
  [[nodiscard]] double fastest() const;  // m/s
  [[nodiscard]] bool has_springs() const;
  [[nodiscard]] bool are_rollers(const MeshPlace& place) const;
  [[nodiscard]] double start_along(const MeshPlace& place) const;
  [[nodiscard]] std::optional<std::size_t> interface_at(const MeshPlace& place) const;
  [[nodiscard]] std::optional<Model> closed_scene(double duration) const;

  const Model& model_;
  const ContactSet& drawn_;
  const SceneLoad& load_;
  const Stage& stage_;
  const Course& course_;
};

}  // namespace dda
