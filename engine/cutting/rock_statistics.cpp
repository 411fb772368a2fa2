#include "engine/cutting/rock_statistics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>

#include "engine/cutting/drawn_traces.h"
#include "engine/geometry/box.h"

namespace dda {
namespace {

constexpr double sound_piece = 0.1;  // m
constexpr int scan_lines = 20;

// Scan lines that divide the rock evenly: they run along an axis, each at a height on the other one.
struct ScanLines {
  int along = 0;  // 0: x, 1: y
  std::vector<double> heights;

  [[nodiscard]] double place(const Vec2& point) const { return point(along); }
  [[nodiscard]] double height(const Vec2& point) const { return point(1 - along); }
};

ScanLines lines_along(int along, const std::vector<CutBlock>& blocks) {
  ScanLines lines{along, {}};
  Box box;
  for (const CutBlock& block : blocks)
    for (const Vec2& vertex : block.shape.outer) box = expanded(box, vertex);
  for (int i = 0; i < scan_lines; ++i) {
    const double share = (static_cast<double>(i) + 0.5) / scan_lines;
    lines.heights.push_back(lines.height(box.lower) + share * (lines.height(box.upper) - lines.height(box.lower)));
  }
  return lines;
}

// Calls act(line, height) for the lines from `low` on, below `high`.
template <typename Act>
void for_lines_between(const ScanLines& lines, double low, double high, const Act& act) {
  for (std::size_t i = 0; i < lines.heights.size(); ++i)
    if (low <= lines.heights[i] && lines.heights[i] < high) act(i, lines.heights[i]);
}

double crossing_of(const Vec2& a, const Vec2& b, double height, const ScanLines& lines) {
  return lines.place(a) +
         (height - lines.height(a)) / (lines.height(b) - lines.height(a)) * (lines.place(b) - lines.place(a));
}

// Places where the ring crosses the line; an edge has its lower end and not its upper one.
void append_crossings(const Ring& ring, double height, const ScanLines& lines, std::vector<double>& places) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2& a = ring[i];
    const Vec2& b = ring[(i + 1) % ring.size()];
    if ((lines.height(a) <= height) != (lines.height(b) <= height)) places.push_back(crossing_of(a, b, height, lines));
  }
}

struct Piece {
  double from = 0, to = 0;
};

// By line, in the order of blocks. Most blocks are between two lines.
std::vector<std::vector<Piece>> pieces_on(const ScanLines& lines, const std::vector<CutBlock>& blocks) {
  std::vector<std::vector<Piece>> pieces(lines.heights.size());
  std::vector<double> places;
  for (const CutBlock& block : blocks) {
    const auto [low, high] = std::ranges::minmax(block.shape.outer, {}, [&](const Vec2& v) { return lines.height(v); });
    for_lines_between(lines, lines.height(low), lines.height(high), [&](std::size_t line, double height) {
      places.clear();
      append_crossings(block.shape.outer, height, lines, places);
      for (const Ring& hole : block.shape.holes) append_crossings(hole, height, lines, places);
      std::sort(places.begin(), places.end());
      for (std::size_t i = 1; i < places.size(); i += 2) pieces[line].push_back({places[i - 1], places[i]});
    });
  }
  return pieces;
}

// Returns by line where traces cross it, in order.
std::vector<std::vector<double>> crossings_of(const ScanLines& lines, const std::vector<Segment>& traces) {
  std::vector<std::vector<double>> places(lines.heights.size());
  for (const Segment& trace : traces) {
    const auto [low, high] = std::minmax({lines.height(trace.start), lines.height(trace.end)});
    for_lines_between(lines, low, high, [&](std::size_t line, double height) {
      places[line].push_back(crossing_of(trace.start, trace.end, height, lines));
    });
  }
  for (std::vector<double>& each : places) std::sort(each.begin(), each.end());
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

double quality_of(const std::vector<std::vector<Piece>>& pieces, const std::vector<std::vector<double>>& parted_at) {
  double sound = 0;
  double all = 0;
  for (std::size_t line = 0; line < pieces.size(); ++line) {
    for (const Piece& piece : pieces[line]) {
      all += piece.to - piece.from;
      sound += sound_length(piece, parted_at[line]);
    }
  }
  return all > 0 ? sound / all : 0;
}

struct Quality {
  double of_blocks = 0, of_traces = 0;
};

Quality quality_along(int along, const std::vector<CutBlock>& blocks, const std::vector<Segment>& traces) {
  const ScanLines lines = lines_along(along, blocks);
  const auto pieces = pieces_on(lines, blocks);
  return {quality_of(pieces, crossings_of(lines, {})), quality_of(pieces, crossings_of(lines, traces))};
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
  const auto pieces = pieces_on({0, {height}}, blocks);
  for (const Piece& piece : pieces.front()) lengths.push_back(piece.to - piece.from);
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
  const Quality level = quality_along(0, rock.blocks, drawn.pieces);
  const Quality upright = quality_along(1, rock.blocks, drawn.pieces);
  statistics.rqd_level = level.of_blocks;
  statistics.rqd_upright = upright.of_blocks;
  statistics.rqd_level_traces = level.of_traces;
  statistics.rqd_upright_traces = upright.of_traces;
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
