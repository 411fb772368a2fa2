// What is asked about the strongest motion of blocks in one stage: which of them fly, and how it fades with distance.
#pragma once

#include <limits>
#include <optional>
#include <string>

#include "engine/core/types.h"

namespace dda {

// A block is ejected when, relative to the rest, it has gone this far or is this fast.
struct EjectionRequest {
  double distance = std::numeric_limits<double>::infinity();  // m
  double speed = std::numeric_limits<double>::infinity();     // m/s
  std::string opening;                                        // whose wall the energy is spread over; empty: none
  double wall = 0;                                            // m, that rock which stays has there, as drawn
};

// Speeds against the distance from a source, for v = K (R/sqrt(W))^-n.
struct AttenuationRequest {
  Vec2 source = Vec2::Zero();                                 // m
  double charge = 1;                                          // W, kg per m of thickness
  double nearest = 0;                                         // m; blocks from here ...
  double farthest = std::numeric_limits<double>::infinity();  // ... to here count
};

struct PeakRequest {
  int stage = 0;  // not a static one
  std::optional<EjectionRequest> ejection;
  std::optional<AttenuationRequest> attenuation;
};

}  // namespace dda
