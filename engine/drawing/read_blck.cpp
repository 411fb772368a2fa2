// Blocks as dc of the original DDA writes them and df reads them, in the layout that "DDA for Windows" of the
// University of California, Berkeley, has (ntdda, src/blocks.c and src/blockreader.c):
//
//   number of blocks, of bolts, of entries of the list of vertices
//   number of fixed, load and measured points
//   block material, first and last entry of each block
//   joint material of the edge that begins there, x and y of each entry; behind the last vertex of a block its first
//   once more, and three entries that are no vertices
//   x, y and block of each point; DDA for Windows writes a number for its kind in front
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "engine/core/error.h"
#include "engine/drawing/layers.h"
#include "engine/drawing/number_list.h"
#include "engine/drawing/read_formats.h"
#include "engine/drawing/rounded_corners.h"
#include "engine/drawing/straighten.h"

namespace dda {
namespace {

constexpr double rounding = 2e-6;  // of coordinates with six decimals, of a corner and of both ends of an edge it is on
constexpr double off_the_edge = 1e-5;  // of the diameter: where points on an edge are put, so that one block has them
constexpr const char* other_version = "the layout of dc; files of other versions have another";

struct Entry {
  double joint = 0;
  Vec2 at = Vec2::Zero();
  std::string origin;
};

struct Range {
  int material = 0;
  int first = 0, last = 0;  // of the entries, from 1 on
  std::string origin;
};

// Where an edge begins and ends; from the smaller end for both blocks that it is between.
using Ends = std::array<double, 4>;

// A point on the edge of two blocks is in both, and on that of one it may be outside by the rounding. Put inside of the
// block by `aside` (m), where it has room for that, it belongs to this one alone.
Vec2 inside_of(const Ring& block, const Vec2& at, double aside) {
  const Polygon shape{block, {}};
  if (locate(shape, at, aside / 2) == Location::inside) return at;
  constexpr int directions = 16;
  for (int i = 0; i < directions; ++i) {
    const double angle = 2 * std::numbers::pi * i / directions;
    Vec2 place = at + aside * Vec2(std::cos(angle), std::sin(angle));
    if (locate(shape, place, aside / 4) == Location::inside) return place;
  }
  return at;
}

class BlckReader {
 public:
  BlckReader(std::string_view text, const std::string& name, double metres) : numbers_(text, name), metres_(metres) {
    drawing_.name = name;
  }

  LineDrawing read() {
    const int blocks = numbers_.whole("the number of blocks", 1);
    if (const int bolts = numbers_.whole("the number of bolts"); bolts > 0)
      throw InputError("", numbers_.here(), fmt::format("{} bolts", bolts),
                       "none: give bolts in the scene, as versions of dc differ in how they write them");
    const int entries = numbers_.whole("the number of vertices");
    std::array<int, 3> points{};
    for (int& count : points) count = numbers_.whole("the number of points of a kind");
    for (int i = 0; i < blocks; ++i) read_range();
    for (int i = 0; i < entries; ++i) read_entry();
    std::vector<Ring> rings;
    for (const Range& range : ranges_) rings.push_back(ring_of(range));
    put_corners_on_edges(rounding * metres_, rings);
    for (std::size_t i = 0; i < rings.size(); ++i) add_block(ranges_[i], rings[i]);
    add_joints(rings);
    add_points(points, rings);
    return std::move(drawing_);
  }

 private:
  void read_range() {
    Range range;
    range.material = std::max(numbers_.whole("the material of a block"), 1);  // dc leaves 0 where no line says it
    range.first = numbers_.whole("the first vertex of a block", 1);
    range.last = numbers_.whole("the last vertex of a block", 1);
    range.origin = numbers_.here();
    ranges_.push_back(std::move(range));
  }

  void read_entry() {
    Entry entry;
    entry.joint = numbers_.number("the joint material of an edge");
    const double x = numbers_.number("the x of a vertex");
    entry.at = metres_ * Vec2(x, numbers_.number("the y of a vertex"));
    entry.origin = numbers_.here();
    entries_.push_back(std::move(entry));
  }

  [[nodiscard]] const Entry& entry(int number) const { return entries_[static_cast<std::size_t>(number) - 1]; }

  // A block of another layout would not close here.
  void check(const Range& range) const {
    const auto count = static_cast<int>(entries_.size());
    if (range.last - range.first < 2 || range.last >= count)
      throw InputError("", range.origin, fmt::format("a block of the vertices {} to {}", range.first, range.last),
                       fmt::format("three or more of the {} vertices, and one behind them", count));
    if (entry(range.last + 1).at != entry(range.first).at)
      throw InputError("", entry(range.last + 1).origin, "at " + written(entry(range.last + 1).at),
                       fmt::format("the first vertex of the block once more, {}: {}", written(entry(range.first).at),
                                   other_version));
  }

  [[nodiscard]] Ring ring_of(const Range& range) const {
    check(range);
    Ring ring;
    for (int i = range.first; i <= range.last; ++i) ring.push_back(entry(i).at);
    return ring;
  }

  void add_block(const Range& range, const Ring& ring) {
    DrawnLine line{layer_for({LayerRole::block, "rock"}),
                   range.origin,
                   ring.front(),
                   {},
                   fmt::format("material {}", range.material)};
    for (std::size_t i = 0; i < ring.size(); ++i) line.pieces.push_back({ring[(i + 1) % ring.size()], nullptr});
    pencil_.add(std::move(line));
  }

  // Edges along which another block lies; an edge of two blocks is one line.
  void add_joints(const std::vector<Ring>& rings) {
    const BlockEdges edges(rings, rounding * metres_);
    for (std::size_t block = 0; block < rings.size(); ++block) {
      for (std::size_t i = 0; i < rings[block].size(); ++i) {
        const Entry& drawn = entry(ranges_[block].first + static_cast<int>(i));
        const int joint = joint_of(drawn);
        const Segment edge = edges.edge(block, i);
        if (!edges.touches_another(block, edge) || !is_first(edge, joint)) continue;
        pencil_.add(DrawnLine{layer_for({LayerRole::rock, fmt::format("joint {}", joint)}),
                              drawn.origin,
                              edge.start,
                              {{edge.end, nullptr}},
                              ""});
      }
    }
  }

  // Whether nobody has drawn the same joint along the same edge.
  bool is_first(const Segment& edge, int joint) {
    Ends ends{edge.start.x(), edge.start.y(), edge.end.x(), edge.end.y()};
    if (std::pair(ends[2], ends[3]) < std::pair(ends[0], ends[1])) ends = {ends[2], ends[3], ends[0], ends[1]};
    const auto known = joints_.insert({ends, joint});
    return known.second || known.first->second != joint;
  }

  [[nodiscard]] static int joint_of(const Entry& entry) {
    const auto joint = static_cast<int>(std::clamp(entry.joint, -1.0, 1e6));
    if (joint != entry.joint || joint < 1)
      throw InputError("", entry.origin, fmt::format("{:g} for the joint material of an edge", entry.joint),
                       "a whole number from 1 to 1000000");
    return joint;
  }

  void add_points(const std::array<int, 3>& counts, const std::vector<Ring>& rings) {
    const int count = counts[0] + counts[1] + counts[2];
    std::vector<std::pair<double, std::string>> rest;
    while (!numbers_.at_end()) {
      const double number = numbers_.number("a point");
      rest.emplace_back(number, numbers_.here());
    }
    const auto columns = count == 0 ? 0 : rest.size() / static_cast<std::size_t>(count);
    const bool is_known = count == 0 ? rest.empty() : rest.size() % static_cast<std::size_t>(count) == 0;
    if (!is_known || (count > 0 && columns != 3 && columns != 4))
      throw InputError("", numbers_.here(), fmt::format("{} numbers of {} points", rest.size(), count),
                       fmt::format("three or four of each: {}", other_version));
    aside_ = off_the_edge * diameter_of(drawing_);
    constexpr std::array layers{"fix point", "load point", "measure point"};
    std::size_t next = 0;
    for (std::size_t kind = 0; kind < counts.size(); ++kind) {
      for (int i = 0; i < counts[kind]; ++i, next += columns) add_point(layers[kind], &rest[next + columns - 3], rings);
    }
  }

  void add_point(const char* layer, const std::pair<double, std::string>* numbers, const std::vector<Ring>& rings) {
    const double block = numbers[2].first;
    if (block != std::floor(block) || block < 1 || block > static_cast<double>(rings.size()))
      throw InputError("", numbers[2].second, fmt::format("{:g} for the block of a point", block),
                       fmt::format("a whole number from 1 to {}", rings.size()));
    const Vec2 at = metres_ * Vec2(numbers[0].first, numbers[1].first);
    pencil_.add(
        DrawnPoint{layer, numbers[0].second, inside_of(rings[static_cast<std::size_t>(block) - 1], at, aside_)});
  }

  NumberList numbers_;
  double metres_;
  double aside_ = 0;  // m
  std::vector<Range> ranges_;
  std::vector<Entry> entries_;
  std::map<Ends, int> joints_;
  LineDrawing drawing_;
  Pencil pencil_{drawing_};
};

}  // namespace

LineDrawing read_blck(std::string_view text, const std::string& name, double metres) {
  return BlckReader(text, name, metres > 0 ? metres : 1).read();
}

}  // namespace dda
