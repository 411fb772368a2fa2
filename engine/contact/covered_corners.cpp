#include "engine/contact/covered_corners.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <utility>

#include "engine/contact/contact_sharing.h"
#include "engine/contact/entrance_cover.h"
#include "engine/contact/pair_motion.h"
#include "engine/core/parallel.h"
#include "engine/geometry/segment.h"

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Where a vertex comes nearest to another one on the way that is foreseen for the step.
struct Encounter {
  double distance;  // m
  Vec2 way;         // m, that the vertex has gone by then, as the other sees it
};

Encounter encounter_of(const Outlines& outlines, int vertex, int other) {
  const Vec2 apart = outlines.current[at(vertex)] - outlines.current[at(other)];
  const Vec2 way = outlines.coming[at(vertex)] - outlines.coming[at(other)];
  const double squared = way.squaredNorm();
  const double share = squared > 0 ? std::clamp(-apart.dot(way) / squared, 0.0, 1.0) : 0;
  return {(apart + share * way).norm(), share * way};
}

// What corners may be apart, and sides off their line, m, but for what strains make of it.
double near_of(const ContactSearch& search, const VertexContact& contact) {
  return in_line * std::min(search.size_of(contact.edge_block), search.size_of(contact.vertex_block));
}

// Length (m) along which two edges lie on each other, or nearly, when the other has gone its `way`; 0 where they do not
// face each other.
double length_beside(const Outlines& outlines, int edge, int other, const Vec2& way) {
  const Vec2 line = outlines.along(edge), facing = outlines.along(other);
  const double length = line.norm();
  if (line.dot(facing) > -same_direction * length * facing.norm()) return 0;
  const auto place = [&](int vertex) {
    return (outlines.current[at(vertex)] + way - outlines.current[at(edge)]).dot(line) / length;
  };
  return std::min(place(other), length) - std::max(place(outlines.next[at(other)]), 0.0);
}

// Whether the blocks share a longer stretch where a vertex of one, at the end of its `way`, meets a vertex of the
// other: from afar the upright sides of two corners that do not lean alike seem to be beside each other. Vertices may
// lie within straight faces, so that either edge of both can be part of it.
bool share_a_face(const Outlines& outlines, int vertex, int corner, const Vec2& way, double near) {
  for (const int edge : {corner, outlines.previous[at(corner)]})
    for (const int other : {vertex, outlines.previous[at(vertex)]})
      if (length_beside(outlines, edge, other, way) > near) return true;
  return false;
}

// The end of the contact's edge that its vertex is at, or comes past, where the blocks share no more than corners; else
// -1. An edge may be so short that both ends are near: then the nearer one, since which comes first depends on the side
// from which the scene is looked at.
int shared_corner(const Outlines& outlines, const VertexContact& contact, double near) {
  int shared = -1;
  double least = near;
  for (const int corner : {contact.edge, outlines.next[at(contact.edge)]}) {
    const Encounter met = encounter_of(outlines, contact.vertex, corner);
    if (met.distance > least || share_a_face(outlines, contact.vertex, corner, met.way, near)) continue;
    least = met.distance;
    shared = corner;
  }
  return shared;
}

// The largest jump of each block's joints, m.
std::vector<double> largest_jumps(const std::vector<Carrier>& joints, int blocks) {
  std::vector<double> largest(at(blocks), 0);
  for (const Carrier& joint : joints)
    for (const int block : {joint.block_a, joint.block_b})
      largest[at(block)] = std::max(largest[at(block)], joint.strain_jump);
  return largest;
}

// The corner that a contact shares if strains make as much of it as they do of anything in its blocks.
int corner_to_ask(const ContactSearch& search, const VertexContact& contact, const std::vector<double>& jumps) {
  const double by_strain = jumps[at(contact.edge_block)] + jumps[at(contact.vertex_block)];
  return shared_corner(search.outlines(), contact, near_of(search, contact) + by_strain);
}

class CoveredCorners {
 public:
  // `contacts`: how many will be added at most. `jumps`: the largest of each block's joints.
  CoveredCorners(const ContactSearch& search, const std::vector<Carrier>& joints, const std::vector<double>& jumps,
                 std::size_t contacts)
      : search_(search), outlines_(search.outlines()), jumps_(jumps) {
    carriers_.reserve(joints.size() + contacts);
    const auto coming = [&](int block) { return outlines_.coming[at(outlines_.starts[at(block)])]; };
    for (const Carrier& joint : joints) carriers_.push_back({joint, coming(joint.block_a), coming(joint.block_b)});
  }

  // Contacts that carry. Asks are answered after sort() alone.
  void add(const VertexContact& contact) {
    carriers_.push_back(
        {{contact.edge_block, contact.vertex_block, outlines_.current[at(contact.vertex)], contact.normal, contact.gap},
         outlines_.coming[at(contact.edge)],
         outlines_.coming[at(contact.vertex)]});
  }

  void sort() {
    if (!starts_.empty() && of_blocks_.size() == 2 * carriers_.size()) return;
    starts_.assign(at(outlines_.blocks()) + 2, 0);
    for_each_side([&](int block, std::size_t) { ++starts_[at(block) + 2]; });
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    of_blocks_.resize(2 * carriers_.size());
    for_each_side([&](int block, std::size_t carrier) { of_blocks_[starts_[at(block) + 1]++] = carrier; });
  }

  [[nodiscard]] bool cover(const VertexContact& contact) const {
    const int end = corner_to_ask(search_, contact, jumps_);
    return end >= 0 && cover(contact, end);
  }

  // `end`: the corner that the contact's vertex is at, of its edge. Corners may be further from each other by what
  // strains make of it, which is no way that blocks have gone against each other.
  [[nodiscard]] bool cover(const VertexContact& contact, int end) const {
    const double near = near_of(search_, contact);
    if (cover(contact, end, near)) return true;
    const double by_strain =
        jump_at(contact.vertex_block, contact.vertex, near) + jump_at(contact.edge_block, end, near);
    return by_strain > 0 && cover(contact, end, near + by_strain);
  }

 private:
  [[nodiscard]] bool cover(const VertexContact& contact, int end, double near) const {
    if (encounter_of(outlines_, contact.vertex, end).distance > near) return false;
    const Vec2 along = outlines_.along(contact.edge).normalized();
    const Vec2 way = end == contact.edge ? along : Vec2(-along);
    // The vertex goes along the edge, away from its end, or the end against that along the vertex' block.
    return is_out(contact, contact.vertex_block, contact.vertex, end, way, near) ||
           is_out(contact, contact.edge_block, end, contact.vertex, -way, near);
  }

  // The largest jump of the block's joints that end at its corner; that of the other block may lie off by twice as
  // much.
  [[nodiscard]] double jump_at(int block, int corner, double near) const {
    if (jumps_[at(block)] == 0) return 0;
    double largest = 0;
    std::ignore = any_of_carriers(block, [&](const MovingCarrier& carrier, int, const Vec2&) {
      const double jump = carrier.there.strain_jump;
      const double off = (carrier.there.point - outlines_.current[at(corner)]).norm();
      if (jump > largest && off <= near + 2 * jump) largest = jump;
      return false;
    });
    return largest;
  }

  // Whether a third block that carries `block` at its corner keeps it off the cover, which leads from the other corner
  // along `way`: beneath that block's surface.
  [[nodiscard]] bool is_out(const VertexContact& contact, int block, int corner, int other_corner, const Vec2& way,
                            double near) const {
    const int other = block == contact.vertex_block ? contact.edge_block : contact.vertex_block;
    const Vec2& point = outlines_.current[at(corner)];
    const Vec2 from_other = point - outlines_.current[at(other_corner)];
    return any_of_carriers(block, [&](const MovingCarrier& carrier, int third, const Vec2& up) {
      if (third == other || up.dot(way) >= -entrance_slack || (carrier.there.point - point).norm() > 2 * near)
        return false;
      // How far the other corner lies from the surface, now and after the step.
      const double below = from_other.dot(up) - carrier.there.gap;
      const Vec2 coming = third == carrier.there.block_a ? carrier.coming_a : carrier.coming_b;
      const Vec2 apart = coming - outlines_.coming[at(other_corner)];
      if (std::abs(below) > near || std::abs(below + apart.dot(up)) > near) return false;
      return !is_carried_alike(other, block, other_corner, up, near);
    });
  }

  // Whether some block but `not_by` carries a block at its corner on a surface that faces the same way.
  [[nodiscard]] bool is_carried_alike(int block, int not_by, int corner, const Vec2& direction, double near) const {
    return any_of_carriers(block, [&](const MovingCarrier& carrier, int third, const Vec2& up) {
      return third != not_by && up.dot(direction) >= same_direction &&
             (carrier.there.point - outlines_.current[at(corner)]).norm() <= 2 * near;
    });
  }

  // Asks of all that carry a block: is(carrier, the block that carries, the normal of its surface).
  template <typename Is>
  [[nodiscard]] bool any_of_carriers(int block, Is is) const {
    for (std::size_t i = starts_[at(block)]; i < starts_[at(block) + 1]; ++i) {
      const MovingCarrier& carrier = carriers_[of_blocks_[i]];
      const bool is_b = carrier.there.block_b == block;
      const int third = is_b ? carrier.there.block_a : carrier.there.block_b;
      if (is(carrier, third, is_b ? carrier.there.normal : Vec2(-carrier.there.normal))) return true;
    }
    return false;
  }

  template <typename Act>
  void for_each_side(Act act) const {
    for (std::size_t i = 0; i < carriers_.size(); ++i) {
      act(carriers_[i].there.block_a, i);
      act(carriers_[i].there.block_b, i);
    }
  }

  struct MovingCarrier {
    Carrier there;
    Vec2 coming_a, coming_b;  // m, what is foreseen of either block there
  };

  const ContactSearch& search_;
  const Outlines& outlines_;
  const std::vector<double>& jumps_;
  std::vector<MovingCarrier> carriers_;
  std::vector<std::size_t> of_blocks_;  // what carries the first block, then the second, ...
  std::vector<std::size_t> starts_;     // block -> first of its own there; the last entry but one is their number
};

// Whether they are sorted in.
bool contains(const std::vector<std::pair<int, int>>& pairs, const std::pair<int, int>& pair) {
  return std::binary_search(pairs.begin(), pairs.end(), pair);
}

void sort_each_once(std::vector<std::pair<int, int>>& pairs) {
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

// A corner of a block and the edges that meet there, as increments of the blocks move them.
class MovedCorner {
 public:
  MovedCorner(const Outlines& outlines, int block, int corner, const Vec2& centroid, const Eigen::VectorXd& d) {
    const Vec6 increments = d.segment<6>(6 * block);
    const auto moved = [&](int vertex) -> Vec2 {
      const Vec2& place = outlines.current[at(vertex)];
      return place + displacement_of(increments, place - centroid);
    };
    before_ = moved(outlines.previous[at(corner)]);
    place_ = moved(corner);
    after_ = moved(outlines.next[at(corner)]);
  }

  [[nodiscard]] const Vec2& place() const { return place_; }

  // How deep a point near the corner is in the block, m; negative outside.
  [[nodiscard]] double depth_of(const Vec2& point) const {
    const Vec2 in = place_ - before_, out = after_ - place_;
    const double behind_in = cross(in, point - place_) / in.norm(),
                 behind_out = cross(out, point - place_) / out.norm();
    return cross(in, out) > 0 ? std::min(behind_in, behind_out) : std::max(behind_in, behind_out);
  }

 private:
  Vec2 before_, place_, after_;
};

// Those of `found` that are covered: of `corners`, each its place among them and the corner that it shares. Corners
// carry as well, but for those that are covered by the others.
std::vector<char> find_covered(const std::vector<std::pair<std::size_t, int>>& corners,
                               const std::vector<VertexContact>& found, CoveredCorners& covered) {
  std::vector<char> out(found.size(), 0);
  for (const auto& [i, end] : corners) out[i] = 1;
  for (std::size_t i = 0; i < found.size(); ++i)
    if (out[i] == 0) covered.add(found[i]);
  covered.sort();
  parallel_for_each(corners.size(), contacts_worth_sharing, [&](std::size_t k) {
    const auto [i, end] = corners[k];
    out[i] = covered.cover(found[i], end) ? 1 : 0;
  });
  for (const auto& [i, end] : corners)
    if (out[i] == 0) covered.add(found[i]);
  covered.sort();
  parallel_for_each(corners.size(), contacts_worth_sharing, [&](std::size_t k) {
    const auto [i, end] = corners[k];
    if (out[i] == 0) out[i] = covered.cover(found[i], end) ? 1 : 0;
  });
  return out;
}

bool is_among(const std::vector<VertexContact>& contacts, const VertexContact& contact) {
  return std::binary_search(contacts.begin(), contacts.end(), contact);
}

// Whether a vertex and a corner of another block come to each other, or part, by more than sides in line can differ.
bool go_far(const ContactSearch& search, const VertexContact& contact, int corner) {
  const std::vector<Vec2>& coming = search.outlines().coming;
  return (coming[at(contact.vertex)] - coming[at(corner)]).norm() > near_of(search, contact);
}

// Corners that are drawn in one point are so but for round-off, which must not choose contacts.
constexpr double some_way = 0.01;  // of what sides in line may differ by

// Whether a cover of the same corners may count in the place of one that does not: where they come to each other from
// some way off, or where one did in the last search.
bool may_have_another(const ContactSearch& search, const VertexContact& contact, int end,
                      const std::vector<VertexContact>& known) {
  const Outlines& outlines = search.outlines();
  const double distance = (outlines.current[at(contact.vertex)] - outlines.current[at(end)]).norm();
  if (distance > some_way * near_of(search, contact) || go_far(search, contact, end)) return true;
  const auto was_known = [&](int edge, int vertex) { return is_among(known, contact_named(edge, vertex)); };
  return was_known(end, contact.vertex) || was_known(outlines.previous[at(end)], contact.vertex) ||
         was_known(contact.vertex, end) || was_known(outlines.previous[at(contact.vertex)], end);
}

// Chooses the contacts of pairs of blocks again, without covers that do not count.
void look_again(const ContactSearch& search, const CoveredCorners& covered, const std::vector<VertexContact>& known,
                std::vector<std::pair<int, int>>& pairs, std::vector<VertexContact>& found) {
  sort_each_once(pairs);
  std::vector<VertexContact> others;
  for (const auto& [a, b] : pairs)
    search.find_between(
        a, b, [&](const VertexContact& contact) { return covered.cover(contact); }, others);
  std::erase_if(others, [&](const VertexContact& contact) {
    const bool comes = contact.gap > some_way * near_of(search, contact) || go_far(search, contact, contact.edge);
    return !comes && !is_among(found, contact) && !is_among(known, contact);
  });
  std::erase_if(found, [&](const VertexContact& contact) { return contains(pairs, blocks_of(contact)); });
  found.insert(found.end(), others.begin(), others.end());
  std::sort(found.begin(), found.end());
}

}  // namespace

std::vector<VertexContact> take_out_covered(const ContactSearch& search, const std::vector<Carrier>& joints,
                                            const std::vector<std::pair<int, int>>& uncovered,
                                            const std::vector<VertexContact>& known,
                                            std::vector<VertexContact>& found) {
  const std::vector<double> jumps = largest_jumps(joints, search.outlines().blocks());
  std::vector<int> ends(found.size());
  parallel_for_each(found.size(), contacts_worth_sharing,
                    [&](std::size_t i) { ends[i] = corner_to_ask(search, found[i], jumps); });
  std::vector<std::pair<std::size_t, int>> corners;
  for (std::size_t i = 0; i < found.size(); ++i)
    if (ends[i] >= 0 && !contains(uncovered, blocks_of(found[i]))) corners.emplace_back(i, ends[i]);
  std::vector<VertexContact> taken;
  if (corners.empty()) return taken;
  CoveredCorners covered(search, joints, jumps, found.size());
  const std::vector<char> out = find_covered(corners, found, covered);
  std::vector<std::pair<int, int>> others;
  for (const auto& [i, end] : corners) {
    if (out[i] == 0) continue;
    taken.push_back(found[i]);
    if (may_have_another(search, found[i], end, known)) others.push_back(blocks_of(found[i]));
  }
  take_out(out, found);
  if (!others.empty()) look_again(search, covered, known, others, found);
  return taken;
}

std::vector<std::pair<int, int>> pressed_into_each_other(const ContactSearch& search,
                                                         const std::vector<VertexContact>& covered, const Model& model,
                                                         const State& state, const Eigen::VectorXd& d,
                                                         const JumpAt& jump_at) {
  const Outlines& outlines = search.outlines();
  const auto corner_of = [&](int block, int corner) {
    return MovedCorner(outlines, block, corner, local_centroid(model, state, block), d);
  };
  std::vector<std::pair<int, int>> pairs;
  for (const VertexContact& contact : covered) {
    const MovedCorner of_vertex = corner_of(contact.vertex_block, contact.vertex);
    const MovedCorner of_edge = corner_of(contact.edge_block, nearer_end(outlines, contact));
    const double depth = std::max(of_edge.depth_of(of_vertex.place()), of_vertex.depth_of(of_edge.place()));
    const double near = near_of(search, contact);
    if (depth <= near) continue;
    const double by_strain =
        jump_at(contact.vertex_block, of_vertex.place(), near) + jump_at(contact.edge_block, of_edge.place(), near);
    if (depth > near + by_strain) pairs.push_back(blocks_of(contact));
  }
  sort_each_once(pairs);
  return pairs;
}

}  // namespace dda
