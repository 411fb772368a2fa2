// What cutting a scene came to, for people and for programs.
#pragma once

#include <string>
#include <vector>

#include "engine/cutting/block_shape.h"
#include "engine/cutting/rock_statistics.h"
#include "engine/scene/cut_scene.h"

namespace dda {

// The figures of all rock of a scene together.
struct CutFigures {
  std::size_t blocks = 0;
  double area = 0;            // m2, of the blocks
  double boundary_area = 0;   // m2, boundaries less holes
  double left_out_area = 0;   // m2, of it in openings that are left out
  double dropped_area = 0;    // m2, of it dropped as slivers
  double smallest_area = 0;   // m2
  double smallest_angle = 0;  // rad, between two edges of a block
  double largest_aspect = 0;  // longest over shortest extent of a block
  std::size_t slender = 0;    // blocks with an aspect above 10
  std::size_t lines = 0;
  int dangles_trimmed = 0;
  int merged = 0;
  double seconds = 0;
  std::vector<BlockShape> shapes;          // of the blocks, one rock after the other
  std::vector<RockStatistics> statistics;  // of each rock
};

// To be calculated once: where there are many blocks it takes a while.
CutFigures figures_of(const CutScene& scene, double seconds);
std::string report_json(const CutScene& scene, const CutFigures& figures);
std::string report_text(const CutScene& scene, const CutFigures& figures);

}  // namespace dda
