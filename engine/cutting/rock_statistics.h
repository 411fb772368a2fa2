// Figures by which jointed rock is described.
#pragma once

#include <array>
#include <vector>

#include "engine/cutting/cut_rock.h"

namespace dda {

struct RockStatistics {
  double mean_area = 0;                 // m2, of blocks
  std::array<double, 3> area_shares{};  // m2: a tenth, half and nine tenths of the blocks are smaller
  double p20 = 0;                       // 1/m2, runs of joints between blocks, by area of rock
  double p21 = 0;                       // 1/m, their length by area of rock
  double p20_traces = 0;                // 1/m2, traces as drawn, also where they end within a block
  double p21_traces = 0;                // 1/m, their length
  // Rock quality designation: share of a scan line in pieces of 0.1 m and more (Deere 1963), mean over lines that
  // divide the rock evenly.
  double rqd_level = 0;
  double rqd_upright = 0;
  double rqd_level_traces = 0;  // where traces part the rock that cut no block off, too
  double rqd_upright_traces = 0;
};

// Where blocks are given as they are nothing is drawn but them: figures of traces are those of the joints between.
RockStatistics statistics_of(const CutRock& rock, const RockPlan& plan);

// Lengths of the pieces that a level line at this height cuts out of blocks, in no order. Used for RQD.
std::vector<double> pieces_on_level(const std::vector<CutBlock>& blocks, double height);

// Shares of the length of all runs by direction, in wedges of ten degrees from level (to the right) over upright to
// level again. A run on the border of two belongs to the later one. All zero without runs.
std::vector<double> length_rose(const std::vector<CutJoint>& joints);

}  // namespace dda
