// The wall of an opening whose blocks are taken out of the rock: its faces, and how far it comes in.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "engine/model/model.h"
#include "engine/model/state.h"

namespace dda {

// A stretch of the outline of a block that stays, along which a block of the opening was drawn.
struct WallFace {
  int block = 0;
  Vec2 from, to;               // m, as drawn
  Vec2 inward = Vec2::Zero();  // unit, out of the rock into the opening, as drawn

  [[nodiscard]] double length() const { return (to - from).norm(); }
};

// A material point of a block at the wall.
struct WallPoint {
  int block = 0;
  Vec2 point = Vec2::Zero();  // m, as drawn
};

// Where a ray from the centroid of the opening goes straight up, left, right and down through its wall for the last
// time.
enum class WallPlace : std::size_t { crown, left, right, invert };
constexpr std::array<std::string_view, 4> wall_place_names{"crown", "left", "right", "invert"};
constexpr std::array<WallPlace, 4> wall_places{WallPlace::crown, WallPlace::left, WallPlace::right, WallPlace::invert};
Vec2 outward_at(WallPlace place);  // unit, the direction of its ray

struct OpeningWall {
  std::vector<WallFace> faces;
  double length = 0;             // m, of all faces
  Vec2 centroid = Vec2::Zero();  // m, of the blocks taken out
  // The points of the wall at each place: two where it is on a joint, none where the ray meets no wall.
  std::array<std::vector<WallPoint>, 4> places;
};

// The faces of `model` (finished) between `opening` and the blocks that are neither in it nor absent in the stage that
// takes it out.
[[nodiscard]] OpeningWall wall_of(const std::vector<int>& opening, const std::vector<bool>& absent, const Model& model);

// The wall but for the faces of these blocks; its places are points of the others that lie there. As it is where all of
// it would go.
[[nodiscard]] OpeningWall without(const std::vector<int>& blocks, OpeningWall wall);

// How far a wall has come in between two states, m.
struct WallMotion {
  double mean = 0;                 // inwards, over the length of the wall: area lost over length
  std::array<double, 4> places{};  // of WallPlace, inwards along its ray; no number where there is no such place
  double largest = 0;              // of the middle of a face, inwards
  int block = -1;                  // to which that face belongs
};

[[nodiscard]] WallMotion motion_of(const OpeningWall& wall, const Model& model, const State& before,
                                   const State& after);

}  // namespace dda
