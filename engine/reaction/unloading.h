// The stages of a scene up to the one that takes an opening out, and in its place a static one that lets what the
// opening exerted on the rock go to a share of it.
#pragma once

#include <string>
#include <vector>

#include "engine/model/model.h"

namespace dda {

// The factor over the time of the last stage, on what the opening exerted: 1 at its start, `share` at its end.
[[nodiscard]] TimeFunction fading_to(double share);

struct Unloading {
  Model model;  // finished; its last stage takes the opening out and has all of its tractions stay
  std::vector<std::string> left_out;  // names of bolts and linings
  std::vector<int> removed_with_it;   // blocks that the scene takes out in the same stage
};

// The scene's own stages before the opening is taken out go on as they are. Where none of them takes it out these are
// the static stages that the scene begins with, or one of its own where there are none. Loads and prescribed motions
// stay what they are when the opening is taken out. Bolts and linings that come with it or later are left out: they are
// the support to be chosen, and those that were there before belong to the rock. Other blocks that the scene takes out
// in the same stage let go to the same share. Throws InputError (without a file) where a stage takes out parts of the
// opening, or as finish_model does.
[[nodiscard]] Unloading unloading_of(Model model, const std::vector<int>& opening);

}  // namespace dda
