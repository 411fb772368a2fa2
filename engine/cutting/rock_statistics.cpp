#include "engine/cutting/rock_statistics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>

#include "engine/core/parallel.h"
#include "engine/cutting/drawn_traces.h"
#include "engine/geometry/box.h"

namespace dda {
namespace {

constexpr double sound_piece = 0.1;  // m
constexpr int scan_lines = 20;

// Places where the ring crosses the level; an edge has its lower end and not its upper one.
void append_crossings(const Ring& ring, double height, std::vector<double>& places) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2& a = ring[i];
    const Vec2& b = ring[(i + 1) % ring.size()];
    if ((a.y() <= height) == (b.y() <= height)) continue;
    places.push_back(a.x() + (height - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
  }
}

struct Piece {
  double from = 0, to = 0;
};

std::vector<Piece> pieces_on(const std::vector<CutBlock>& blocks, double height) {
  std::vector<Piece> pieces;
  std::vector<double> places;
  for (const CutBlock& block : blocks) {
    places.clear();
    append_crossings(block.shape.outer, height, places);
    for (const Ring& hole : block.shape.holes) append_crossings(hole, height, places);
    std::sort(places.begin(), places.end());
    for (std::size_t i = 1; i < places.size(); i += 2) pieces.push_back({places[i - 1], places[i]});
  }
  return pieces;
}

// Returns where traces cross the level, from left to right.
std::vector<double> crossings_of(const std::vector<Segment>& traces, double height) {
  std::vector<double> places;
  for (const auto& [a, b] : traces) {
    if ((a.y() <= height) == (b.y() <= height)) continue;
    places.push_back(a.x() + (height - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
  }
  std::sort(places.begin(), places.end());
  return places;
}

// Returns how much of a piece between joints is sound, m: the parts between traces in it, but for those that are short.
double sound_length(const Piece& piece, const std::vector<double>& traces) {
  double sound = 0;
  double from = piece.from;
  const auto part = [&](double to) {
    if (to - from >= sound_piece) sound += to - from;
    from = to;
  };
  const auto first = std::upper_bound(traces.begin(), traces.end(), piece.from);
  for (auto place = first; place != traces.end() && *place < piece.to; ++place) part(*place);
  part(piece.to);
  return sound;
}

double quality_on_levels(const std::vector<CutBlock>& blocks, const std::vector<Segment>& traces) {
  Box box;
  for (const CutBlock& block : blocks) {
    for (const Vec2& vertex : block.shape.outer) box = expanded(box, vertex);
  }
  struct Level {
    std::vector<Piece> pieces;
    std::vector<double> parted_at;
  };
  std::vector<Level> levels(scan_lines);
  parallel_for_each(levels.size(), 1, [&](std::size_t i) {
    const double share = (static_cast<double>(i) + 0.5) / scan_lines;
    const double height = box.lower.y() + share * (box.upper.y() - box.lower.y());
    levels[i] = {pieces_on(blocks, height), crossings_of(traces, height)};
  });
  double sound = 0;
  double all = 0;
  for (const auto& [pieces, parted_at] : levels) {
    for (const Piece& piece : pieces) {
      all += piece.to - piece.from;
      sound += sound_length(piece, parted_at);
    }
  }
  return all > 0 ? sound / all : 0;
}

// Returns the same rock with x and y exchanged.
std::vector<CutBlock> on_its_side(std::vector<CutBlock> blocks) {
  const auto swap_ring = [](Ring& ring) {
    for (Vec2& vertex : ring) std::swap(vertex.x(), vertex.y());
  };
  for (CutBlock& block : blocks) {
    swap_ring(block.shape.outer);
    for (Ring& hole : block.shape.holes) swap_ring(hole);
  }
  return blocks;
}

std::vector<Segment> on_its_side(std::vector<Segment> traces) {
  for (auto& [start, end] : traces) {
    std::swap(start.x(), start.y());
    std::swap(end.x(), end.y());
  }
  return traces;
}

void add_densities(const CutRock& rock, const RockPlan& plan, const DrawnTraces& drawn, double area,
                   RockStatistics& statistics) {
  double length = 0;
  for (const CutJoint& run : rock.joints) length += (run.to - run.from).norm();
  statistics.p20 = statistics.p20_traces = static_cast<double>(rock.joints.size()) / area;
  statistics.p21 = statistics.p21_traces = length / area;
  if (!plan.blocks.empty()) return;
  length = 0;
  for (const Segment& piece : drawn.pieces) length += (piece.end - piece.start).norm();
  statistics.p20_traces = drawn.traces / area;
  statistics.p21_traces = length / area;
}

}  // namespace

std::vector<double> pieces_on_level(const std::vector<CutBlock>& blocks, double height) {
  std::vector<double> lengths;
  for (const Piece& piece : pieces_on(blocks, height)) lengths.push_back(piece.to - piece.from);
  return lengths;
}

RockStatistics statistics_of(const CutRock& rock, const RockPlan& plan) {
  RockStatistics statistics;
  std::vector<double> areas;
  for (const CutBlock& block : rock.blocks) areas.push_back(area_moments(block.shape).area);
  if (areas.empty()) return statistics;
  std::sort(areas.begin(), areas.end());
  const double area = std::accumulate(areas.begin(), areas.end(), 0.0);
  const auto count = static_cast<double>(areas.size());
  statistics.mean_area = area / count;
  std::size_t number = 0;
  for (const double share : {0.1, 0.5, 0.9})
    statistics.area_shares.at(number++) = areas[static_cast<std::size_t>(share * (count - 1))];
  const DrawnTraces drawn = traces_in_rock(plan);
  add_densities(rock, plan, drawn, area, statistics);
  const std::vector<CutBlock> upright = on_its_side(rock.blocks);
  statistics.rqd_level = quality_on_levels(rock.blocks, {});
  statistics.rqd_upright = quality_on_levels(upright, {});
  statistics.rqd_level_traces = quality_on_levels(rock.blocks, drawn.pieces);
  statistics.rqd_upright_traces = quality_on_levels(upright, on_its_side(drawn.pieces));
  return statistics;
}

std::vector<double> length_rose(const std::vector<CutJoint>& joints) {
  constexpr std::size_t wedges = 18;
  std::vector<double> shares(wedges, 0.0);
  double sum = 0;
  for (const CutJoint& run : joints) {
    const Vec2 way = run.to - run.from;
    double angle = std::atan2(way.y(), way.x());
    if (angle < 0) angle += std::numbers::pi;
    // What should be on the border of two wedges may be off it by round-off.
    const auto wedge = static_cast<std::size_t>(std::floor(angle / std::numbers::pi * wedges + 1e-9));
    shares[wedge % wedges] += way.norm();
    sum += way.norm();
  }
  for (double& share : shares) share = sum > 0 ? share / sum : 0;
  return shares;
}

}  // namespace dda
