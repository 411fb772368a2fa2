// Rock of the public scene format, cut and loaded by lot: the same seed gives the same rock everywhere.
#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace verify {

enum class RockKind {
  two_sets,    // of full lines, between held walls
  three_sets,  // of full lines: slivers and needles at every crossing
  traces,      // joints that end in the rock or at each other
  grains,      // cells with some cohesion between joints
  tunnel,      // three sets and an opening from the start
  excavated,   // an opening that is taken out of rock that has settled
  slope,       // a free face, on a held base and against a held back
  shaken       // settled rock whose held walls then move
};

inline constexpr std::array all_rock_kinds{RockKind::two_sets, RockKind::three_sets, RockKind::traces,
                                           RockKind::grains,   RockKind::tunnel,     RockKind::excavated,
                                           RockKind::slope,    RockKind::shaken};

[[nodiscard]] std::string name_of(RockKind kind);

// Kinds take turns: rock of seed s is of kind s modulo their number.
[[nodiscard]] RockKind rock_kind(std::uint64_t seed);

enum class RockJoints {
  dry,       // as every scene has them that does not ask for more, or with some cohesion
  dilating,  // they ride up as they slide, those of half of the rocks without end; a third as many blocks
  springs,   // the same rocks as dry ones, on springs
  compliant  // the same rocks as dry ones, with joints that give way by a stiffness per area of their own
};

// What a population is of.
struct RockFamily {
  RockJoints joints = RockJoints::dry;
  double extent = 1;  // times as wide and high, with joints as far apart: its square times as many blocks
};

struct RandomRock {
  std::uint64_t seed = 0;
  RockKind kind = RockKind::two_sets;
  double unit = 1;    // m: rock of units of a centimetre to a hundred metres, with moduli that grow with it
  double motion = 0;  // s, of the last stage: 0.1 s for units of a metre, and as the root of the unit
  std::string scene;  // its text
};

// Every rock settles in a static stage whose steps the engine finds, and moves for a time in which what is loose falls
// by a twentieth of a unit.
[[nodiscard]] RandomRock random_rock(std::uint64_t seed, const RockFamily& family = {});

}  // namespace verify
