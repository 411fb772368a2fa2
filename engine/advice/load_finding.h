// What is found odd of the history of one load or prescribed motion in one stage.
#pragma once

#include <string>
#include <vector>

#include "engine/advice/acting_place.h"
#include "engine/model/time_function.h"

namespace dda {

struct LoadFinding {
  int stage = 0;
  const TimeFunction* history = nullptr;  // of the model that was searched, by which the load is known again
  std::string sentence;                   // for people, without a full stop
  bool leaves_figures = false;            // what is foretold of the wave still means something beside it
  double time = 0;                        // s in the run, of the first jump in the stage, of loads that jump
  std::vector<ActingPlace> places = {};   // where these act
};

}  // namespace dda
