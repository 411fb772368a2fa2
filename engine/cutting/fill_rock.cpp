#include "engine/cutting/fill_rock.h"

#include <cstddef>
#include <iterator>

#include "engine/cutting/cell_sites.h"
#include "engine/cutting/cell_walls.h"
#include "engine/cutting/materials.h"

namespace dda {
namespace {

// Streams of fills are beyond those of joint sets, which have the numbers of the sets.
constexpr std::uint64_t first_stream = std::uint64_t{1} << 32U;

// The later one counts.
int fill_around(const std::vector<PlanFill>& fills, const Vec2& place) {
  int found = -1;
  for (std::size_t i = 0; i < fills.size(); ++i) {
    if (fills[i].region.empty() || contains({fills[i].region, {}}, place)) found = static_cast<int>(i);
  }
  return found;
}

void fill_block(const Polygon& block, const PlanFill& fill, RandomStream& random, FilledPlan& filled, CutFill& report) {
  const SiteGrid grid(bounding_box(block));
  const std::vector<Pixel> sites = sites_of(block, fill, grid, random);
  if (sites.empty()) return;
  CellWalls cells = walls_between(sites, grid, block, fill);
  ++report.blocks;
  report.sites += sites.size();
  report.short_edges_closed += cells.closed.size();
  for (const Segment& wall : cells.walls)
    filled.plan.lines.push_back({{wall.start, wall.end}, fill.joint, fill.origin, true});
  std::ranges::move(cells.closed, std::back_inserter(filled.cleaned));
}

}  // namespace

RockPlan without_fills(const RockPlan& plan) {
  RockPlan outlined = plan;
  outlined.fills.clear();
  for (const PlanFill& fill : plan.fills) {
    if (fill.region.empty()) continue;
    std::vector<Vec2> outline = fill.region;
    outline.push_back(outline.front());
    outlined.lines.push_back({std::move(outline), fill.joint, fill.origin + ".region", true});
  }
  return outlined;
}

FilledPlan with_cells(const RockPlan& plan, const std::vector<CutBlock>& blocks) {
  FilledPlan filled;
  filled.plan = without_fills(plan);
  std::vector<RandomStream> streams;
  for (std::size_t i = 0; i < plan.fills.size(); ++i) {
    streams.emplace_back(plan.fills[i].seed, first_stream + i);
    filled.fills.push_back({plan.fills[i].origin, 0, 0, 0});
  }
  for (const CutBlock& block : blocks) {
    const int number = fill_around(plan.fills, point_inside(block.shape));
    if (number < 0) continue;
    const auto fill = static_cast<std::size_t>(number);
    fill_block(block.shape, plan.fills[fill], streams[fill], filled, filled.fills[fill]);
  }
  return filled;
}

}  // namespace dda
