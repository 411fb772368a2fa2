#include "engine/cutting/finish_blocks.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "engine/core/at_once.h"
#include "engine/cutting/block_order.h"
#include "engine/cutting/corner_places.h"
#include "engine/cutting/corners.h"
#include "engine/cutting/joint_runs.h"
#include "engine/cutting/short_edges.h"

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

std::vector<NodeRings> rings_of(const Arrangement& arrangement, const std::vector<Outline>& outlines,
                                const Corners& corners) {
  const auto ring = [&](const std::vector<int>& walk) {
    NodeRing nodes;
    for (const int h : walk) {
      if (!corners.is_superfluous(arrangement.origin(h))) nodes.push_back(arrangement.origin(h));
    }
    return nodes;
  };
  std::vector<NodeRings> blocks;
  blocks.reserve(outlines.size());
  for (const Outline& outline : outlines) {
    NodeRings& rings = blocks.emplace_back();
    rings.push_back(ring(outline.outer));
    for (const auto& hole : outline.holes) rings.push_back(ring(hole));
  }
  return blocks;
}

std::vector<Vec2> positions_of(const Arrangement& arrangement) {
  std::vector<Vec2> positions;
  positions.reserve(at(arrangement.nodes()));
  for (int node = 0; node < arrangement.nodes(); ++node) positions.push_back(arrangement.position(node));
  return positions;
}

void fill_blocks(const std::vector<NodeRings>& rings, const CornerPlaces& places, const std::vector<Outline>& outlines,
                 const std::vector<FacePlace>& face_places, CutRock& rock) {
  constexpr std::size_t worth_sharing = 1000;
  rock.blocks.resize(rings.size());
  parallel_for_each(rings.size(), worth_sharing, [&](std::size_t i) {
    rock.blocks[i].shape = polygon_of(rings[i], places);
    rock.blocks[i].opening = face_places[at(outlines[i].group)].opening;
  });
  put_in_order(rock.blocks);
}

}  // namespace

void finish_blocks(const Arrangement& arrangement, const FaceGroups& groups, const std::vector<FacePlace>& face_places,
                   const std::vector<Outline>& outlines, const PlanPieces& pieces, const RockPlan& plan,
                   CutRock& rock) {
  const Corners corners(arrangement, groups, pieces, plan);
  CornerPlaces places(positions_of(arrangement));
  std::vector<NodeRings> rings;
  std::vector<BorderEdge> edges;
  at_once([&] { edges = border_edges(arrangement, groups, outlines, corners, pieces, plan); },
          [&] {
            rings = rings_of(arrangement, outlines, corners);
            close_short_edges(arrangement, corners, rings, rock.tolerance, places, rock.cleaned);
          });
  fill_blocks(rings, places, outlines, face_places, rock);
  fill_joints(edges, places, pieces, plan, rock);
}

}  // namespace dda
