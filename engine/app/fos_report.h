// What `dda fos` found, for people, for programs, and as a picture (SVG) of the blocks that move first.
#pragma once

#include <string>

#include "engine/safety/factor_of_safety.h"

namespace dda {

// A block that moves when the rock fails.
struct MovingBlock {
  int block = 0;
  Vec2 movement = Vec2::Zero();  // m
  double share = 0;              // of its size
};

// Blocks that moved by a tenth of the largest movement or more (in their sizes), the fastest first.
[[nodiscard]] std::vector<MovingBlock> moving_blocks(const Standing& failure, const Model& model);

// `kept` is the factor of joints that keep their strength as they slide, where that is more (factor_of_kept_strength).
[[nodiscard]] std::string fos_text(const SafetyReport& report, const SafetyReport& kept, const SafetyQuestion& question,
                                   const Model& model);
[[nodiscard]] std::string fos_json(const SafetyReport& report, const SafetyReport& kept, const SafetyQuestion& question,
                                   const Model& model);
[[nodiscard]] std::string fos_picture(const SafetyReport& report, const Model& model);

}  // namespace dda
