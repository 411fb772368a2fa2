// Whether jointed rock stands: it is loaded while contacts stick, then its joints get their strength, and it must find
// an equilibrium without moving far.
#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "engine/core/status.h"
#include "engine/model/model.h"

namespace dda {

struct Standing {
  bool stands = false;
  bool is_loaded = false;      // it carries its loads while contacts stick; where it does not, no strength is enough
  Status status = Status::ok;  // how the search for equilibrium ended
  std::string reason;          // why the rock does not stand, for people; empty where it does

  // What the blocks did once the joints had their strength (m), and how far that is in their own sizes, the square
  // root of their areas.
  std::vector<Vec2> movement;
  double largest_movement = 0;
};

// A block that has moved this share of its size once joints have their strength does not stand: rock that finds a hold
// after that has failed. (What stands moves by what its joints give, orders of magnitude less.)
constexpr double movement_of_failure = 0.05;

// The model's own stages give way to two static ones that find their own steps; loads and motions are those of `time`
// (s). What its stages remove is removed when the first of the two is over. Throws InputError as finish_model does.
// Once it is asked to `stop` it gives up after the step under way, with an answer that says nothing.
[[nodiscard]] Standing standing_of(Model model, double time, const std::stop_token& stop = {});

}  // namespace dda
