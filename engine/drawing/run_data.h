// What df of the original DDA is given beside the blocks: materials, joints, motions and loads of points, steps. As in
// the file, so in whatever system of units its author had.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/types.h"

namespace dda {

struct BlockMaterialData {
  double density = 0, unit_weight = 0, young = 0, poisson = 0;
  std::array<double, 3> stress{};  // at the start: xx, yy, xy, positive in tension
  Vec2 velocity = Vec2::Zero();    // at the start
  double spin = 0;
  std::string origin;  // "slope.df line 7", for messages
};

struct JointMaterialData {
  double friction_deg = 0, cohesion = 0, tension = 0;
  std::string origin;
};

// Rows of time, x and y: displacements of a fixed point, forces on a load point. Empty: it stands still, or is not
// loaded.
struct PointTable {
  std::vector<std::array<double, 3>> rows;
  std::string origin;
};

struct RunData {
  std::string name;           // of the file, for messages
  double velocity_share = 0;  // of the velocities that a step hands on to the next: 0 static, 1 dynamic
  int steps = 0;
  double displacement_ratio = 0;             // largest displacement of a step over half the height of all blocks
  double longest_step = 0;                   // 0: as long as the displacements allow
  double spring = 0;                         // stiffness of a contact; 0: chosen by the program
  std::vector<BlockMaterialData> materials;  // by their number less one, as joints are
  std::vector<JointMaterialData> joints;
  std::vector<PointTable> points;  // fixed points, then load points; empty where the file has none
};

// Reads the layout of df with springs and tables for the `points` fixed and load points of the blocks, or the shorter
// one of "DDA for Windows" without these. How many numbers the file has tells which it is; it has all and no more, or
// is refused. Throws InputError, without a file, whose field begins with the name.
RunData read_run_data(std::string_view text, const std::string& name, int points);

// The same, of a file.
RunData read_run_data(const std::filesystem::path& file, int points);

}  // namespace dda
