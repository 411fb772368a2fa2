#include "engine/cutting/finish_blocks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>

#include "engine/core/at_once.h"
#include "engine/cutting/block_order.h"
#include "engine/cutting/corner_places.h"
#include "engine/cutting/corners.h"
#include "engine/cutting/line_report.h"
#include "engine/cutting/short_edges.h"
#include "engine/geometry/segment.h"

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

// An edge between blocks, along a straight.
struct Contact {
  int straight = 0;
  double way = 0;
  int from = 0, to = 0;
};

std::vector<Contact> contacts_of(const Arrangement& arrangement, const FaceGroups& groups, const PlanPieces& pieces,
                                 const RockPlan& plan) {
  std::vector<Contact> contacts;
  for (int edge = 0; edge < arrangement.edges(); ++edge) {
    const int left = groups.of(arrangement.face(2 * edge));
    const int right = groups.of(arrangement.face(2 * edge + 1));
    if (left == right || left == FaceGroups::outside || right == FaceGroups::outside) continue;
    const int straight = counting_straight(arrangement, edge, pieces, plan);
    const Straight& line = pieces.straights[at(straight)];
    const auto way = [&](int node) { return (line.to - line.from).dot(arrangement.position(node) - line.from); };
    int from = arrangement.origin(2 * edge);
    int to = arrangement.target(2 * edge);
    if (way(from) > way(to)) std::swap(from, to);
    contacts.push_back({straight, way(from), from, to});
  }
  std::sort(contacts.begin(), contacts.end(), [](const Contact& a, const Contact& b) {
    return std::tuple(a.straight, a.way, a.from) < std::tuple(b.straight, b.way, b.from);
  });
  return contacts;
}

// Those that no corner of a block parts are one.
std::vector<Contact> along_edges(const std::vector<Contact>& contacts, const Corners& corners) {
  std::vector<Contact> edges;
  for (const Contact& contact : contacts) {
    const bool goes_on = !edges.empty() && edges.back().straight == contact.straight &&
                         edges.back().to == contact.from && corners.is_superfluous(contact.from);
    if (goes_on)
      edges.back().to = contact.to;
    else
      edges.push_back(contact);
  }
  return edges;
}

// m, by which nodes of a run may lie beside its straight: twice what welding moves them with the default tolerance, and
// a fifth of what scenes allow a joint line to leave the blocks along it (point_tolerance).
double aside_allowed(const RockPlan& plan) {
  constexpr double of_diagonal = 2e-8;
  const Box box = bounding_box(plan.boundary);
  return of_diagonal * (box.upper - box.lower).norm();
}

// Contacts that follow each other on a straight make one run, unless a node of theirs is not quite on it any more: a
// run from a node that moved aside to one far away would pass those between.
void fill_joints(const std::vector<Contact>& contacts, const CornerPlaces& places, const PlanPieces& pieces,
                 const RockPlan& plan, CutRock& rock) {
  const double aside = aside_allowed(plan);
  const auto is_on_straight = [&](int node, int straight) {
    const Straight& line = pieces.straights[at(straight)];
    const Vec2 along = (line.to - line.from).normalized();
    return std::abs(cross(along, places.position(node) - line.from)) <= aside;
  };
  for (std::size_t first = 0, last = 0; first < contacts.size(); first = last + 1) {
    last = first;
    const auto goes_on = [&](const Contact& each, const Contact& next) {
      return next.straight == each.straight && next.from == each.to && is_on_straight(each.from, each.straight) &&
             is_on_straight(each.to, each.straight) && is_on_straight(next.to, each.straight);
    };
    while (last + 1 < contacts.size() && goes_on(contacts[last], contacts[last + 1])) ++last;
    const int from = places.node(contacts[first].from);
    const int to = places.node(contacts[last].to);
    if (from == to) continue;  // a short edge that was closed
    rock.joints.push_back(
        {places.position(from), places.position(to), joint_of(pieces.sources[at(contacts[first].straight)], plan)});
  }
}

}  // namespace

void finish_blocks(const Arrangement& arrangement, const FaceGroups& groups, const std::vector<FacePlace>& face_places,
                   const std::vector<Outline>& outlines, const PlanPieces& pieces, const RockPlan& plan,
                   CutRock& rock) {
  const Corners corners(arrangement, groups, pieces, plan);
  CornerPlaces places(positions_of(arrangement));
  std::vector<NodeRings> rings;
  std::vector<Contact> contacts;
  at_once([&] { contacts = along_edges(contacts_of(arrangement, groups, pieces, plan), corners); },
          [&] {
            rings = rings_of(arrangement, outlines, corners);
            close_short_edges(arrangement, corners, rings, rock.tolerance, places, rock.cleaned);
          });
  fill_blocks(rings, places, outlines, face_places, rock);
  fill_joints(contacts, places, pieces, plan, rock);
}

}  // namespace dda
