// What is known of each problem without the engine, and how far a run is from it.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/simulation/simulation.h"
#include "verification/stability/setting.h"
#include "verification/study/judged_run.h"

namespace verify {

// Looks at a run at its start, or at the end of the static stage it begins with, and after every step from then on.
class Answer {
 public:
  Answer() = default;
  virtual ~Answer() = default;
  Answer(const Answer&) = delete;
  Answer& operator=(const Answer&) = delete;

  // `sample`: the measurements of the scene.
  virtual void look(const dda::Simulation& simulation, std::span<const double> sample) = 0;
  [[nodiscard]] virtual std::vector<Check> checks(const dda::Simulation& simulation) const = 0;
};

// pulse:   every block's displacement at every moment is within 5 % of the largest, by the row of bars in continuous
// time wall:    what has settled rests: the base carries the weight, and nothing moves incline: both blocks slide as
// one by g (sin a - cos a tan f) t^2/2, but for what blocks and springs give way pile:    nothing moves faster than its
// fall allows, leaves the box, or lies deep in another block
[[nodiscard]] std::unique_ptr<Answer> answer_of(const Setting& setting);

}  // namespace verify
