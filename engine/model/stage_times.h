// When stages begin on the scene's clock, by the durations that they are given: to half a step of where a run has come.
#pragma once

#include <cstddef>

#include "engine/model/model.h"

namespace dda {

// s; for one past the last stage, the end of the run.
inline double begin_of_stage(const Model& model, std::size_t stage) {
  double begin = 0;
  for (std::size_t i = 0; i < stage; ++i) begin += model.stages[i].duration;
  return begin;
}

inline double end_of_run(const Model& model) { return begin_of_stage(model, model.stages.size()); }  // s

}  // namespace dda
