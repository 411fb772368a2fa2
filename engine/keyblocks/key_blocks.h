// Which blocks at free faces can come out of the rock, how, and what holds them.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/keyblocks/first_motion.h"
#include "engine/keyblocks/obstacles.h"
#include "engine/keyblocks/rock_bodies.h"
#include "engine/keyblocks/turning.h"

namespace dda {

struct KeyBlockQuestion {
  std::vector<bool> is_void;             // of each block: taken out
  std::vector<Polygon> opening;          // bodies with a free face towards one of these are asked for; empty: all
  double wanted_safety = 1.5;            // factor of safety that bolts are to give
  std::optional<double> bolt_direction;  // rad, in which bolts pull; none: square into the free faces
  Vec2 acceleration = Vec2::Zero();      // m/s2, besides gravity
};

// The types of Goodman and Shi (1985); their type V, infinite blocks, is RockBody::surroundings.
enum class BlockType {
  key,            // I: moves unless it is held
  friction_held,  // II: friction or cohesion holds it: a potential key block
  stable,         // III: removable, but what acts on it does not take it out
  tapered,        // IV: cannot be removed
};
std::string_view numeral(BlockType type);      // "I"
std::string_view description(BlockType type);  // "key block"

struct KeyBlock {
  RockBody body;
  Resultant acting;
  BlockType type = BlockType::tapered;
  FirstMotion motion;
  bool turns = false;
  std::vector<Ways> ways;
  std::vector<Obstacle> obstacles;     // on its way, where it slides or falls
  Vec2 bolt_direction = Vec2::Zero();  // unit
  std::optional<double> bolt_force;    // N per m of thickness; none: no force in this direction is enough
  Vec2 least_bolt_force = Vec2::Zero();
};

using TypeCounts = std::array<int, 4>;  // bodies of each type

struct KeyBlockReport {
  std::vector<KeyBlock> blocks;  // with a free face that was asked for, by factor of safety, then by name
  int surroundings = 0;          // bodies
  int buried = 0;                // bodies without such a face
  int taken_out = 0;             // blocks
  std::vector<std::string> left_out;
  std::optional<TypeCounts> without_merging;  // of rock that merges small blocks: what was there before
};

TypeCounts count_types(const std::vector<KeyBlock>& blocks);

KeyBlockReport key_blocks(const Model& model, const KeyBlockQuestion& question);

// "rock 3", or "rock 3 + rock 4" for blocks that are one.
std::string name_of(const RockBody& body, const Model& model);

// For people and for programs; the latter with null where there is no finite number.
std::string report_text(const KeyBlockReport& report, const KeyBlockQuestion& question, const Model& model);
std::string report_json(const KeyBlockReport& report, const KeyBlockQuestion& question, const Model& model);

}  // namespace dda
