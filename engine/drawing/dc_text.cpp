#include "engine/drawing/dc_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include "engine/geometry/box.h"

namespace dda {
namespace {

struct DcLine {
  Vec2 from, to;
  int material = 1;
};

using Place = std::pair<double, double>;

Place place(const Vec2& point) { return {point.x(), point.y()}; }

std::vector<std::pair<Vec2, Vec2>> edges_of(const BlockDrawing& drawing) {
  std::vector<std::pair<Vec2, Vec2>> edges;
  const auto add = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) edges.emplace_back(ring[i], ring[(i + 1) % ring.size()]);
  };
  for (const ExportedBlock& block : drawing.blocks) {
    add(block.shape.outer);
    for (const Ring& hole : block.shape.holes) add(hole);
  }
  return edges;
}

// Neighbours share the bits of their edges: one that has no other the other way round bounds the rock.
std::vector<DcLine> outline_of(const std::vector<std::pair<Vec2, Vec2>>& edges) {
  std::set<std::pair<Place, Place>> directed;
  for (const auto& [from, to] : edges) directed.insert({place(from), place(to)});
  std::vector<DcLine> lines;
  for (const auto& [from, to] : edges) {
    if (!directed.contains({place(to), place(from)})) lines.push_back({from, to, 1});
  }
  return lines;
}

// dc takes nodes for one when they are nearer than about this share of the size of the rock.
double least_distance(const std::vector<std::pair<Vec2, Vec2>>& edges) {
  constexpr double usual = 0.001;
  constexpr double of_shortest = 0.1;
  Box box;
  double shortest = std::numeric_limits<double>::infinity();
  for (const auto& [from, to] : edges) {
    box = expanded(box, from);
    shortest = std::min(shortest, (to - from).norm());
  }
  return std::min(usual, of_shortest * shortest / (box.upper - box.lower).norm());
}

}  // namespace

std::string dc_text(const BlockDrawing& drawing) {
  const auto edges = edges_of(drawing);
  std::vector<DcLine> lines = outline_of(edges);
  std::map<std::string, int> materials;
  for (const ExportedJoint& joint : drawing.joints) {
    const int next = static_cast<int>(materials.size()) + 1;
    lines.push_back({joint.from, joint.to, materials.try_emplace(joint.layer, next).first->second});
  }
  std::string text = fmt::format("{}\n{} 0\n0\n0\n0\n0\n0\n0\n", least_distance(edges), lines.size());
  for (const DcLine& line : lines)
    fmt::format_to(std::back_inserter(text), "{} {} {} {} {}\n", line.from.x(), line.from.y(), line.to.x(), line.to.y(),
                   line.material);
  return text;
}

}  // namespace dda
