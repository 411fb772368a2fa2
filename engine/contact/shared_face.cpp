#include "engine/contact/shared_face.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>

#include "engine/contact/covered_corners.h"
#include "engine/geometry/segment.h"

namespace dda {
namespace {

constexpr double round_off = 1e-9;  // of the smaller block's size: places nearer to each other are the same
constexpr double straight = 1e-7;   // sine of the angle between edges of one face, as points may lie off their edges

std::size_t at(int i) { return static_cast<std::size_t>(i); }

bool are_in_line(const Vec2& along, const Vec2& other) {
  return std::abs(cross(along, other)) <= straight * along.norm() * other.norm() && along.dot(other) > 0;
}

bool is_within_face(const Outlines& outlines, int vertex) {
  return are_in_line(outlines.along(vertex), outlines.along(outlines.previous[at(vertex)]));
}

// The line of a contact's edge.
struct Line {
  Vec2 origin, along;  // along: unit

  [[nodiscard]] double place(const Vec2& point) const { return (point - origin).dot(along); }
};

// An edge with those beside it that are in line with it.
class Face {
 public:
  Face(const Outlines& outlines, int edge) : outlines_(outlines), first_(edge), last_(edge) {
    const Vec2 along = outlines.along(edge);
    const auto goes_on = [&](int other) { return other != edge && are_in_line(along, outlines.along(other)); };
    while (goes_on(outlines.previous[at(first_)])) first_ = outlines.previous[at(first_)];
    while (goes_on(outlines.next[at(last_)])) last_ = outlines.next[at(last_)];
  }

  [[nodiscard]] bool has(int edge) const {
    for (int each = first_;; each = outlines_.next[at(each)]) {
      if (each == edge) return true;
      if (each == last_) return false;
    }
  }

  // Returns where the face begins and ends along the line, the lower place first, m.
  [[nodiscard]] std::pair<double, double> on(const Line& line) const {
    return std::minmax(
        {line.place(outlines_.current[at(first_)]), line.place(outlines_.current[at(outlines_.next[at(last_)])])});
  }

 private:
  const Outlines& outlines_;
  int first_, last_;
};

// The contacts of one pair of blocks.
class PairOfBlocks {
 public:
  PairOfBlocks(const Outlines& outlines, double smaller, std::span<const VertexContact* const> contacts)
      : outlines_(outlines), smaller_(smaller), contacts_(contacts) {}

  [[nodiscard]] double share_of(const VertexContact& contact) {
    const Face own(outlines_, contact.edge), facing(outlines_, facing_edge(outlines_, contact));
    const Line line = list_places(contact, own, facing);
    const auto [low, high] = own.on(line);
    const auto [facing_low, facing_high] = facing.on(line);
    const double from = std::max(low, facing_low), to = std::min(high, facing_high);
    const double place = line.place(outlines_.current[at(contact.vertex)]);
    return to > from ? (to - from) / 2 * (part_of_end(from, place) + part_of_end(to, place)) : 0;
  }

  [[nodiscard]] bool has_others_on_both_sides(const VertexContact& contact) {
    const Line line =
        list_places(contact, Face(outlines_, contact.edge), Face(outlines_, facing_edge(outlines_, contact)));
    const double place = line.place(outlines_.current[at(contact.vertex)]);
    const auto [low, high] = std::ranges::minmax(places_);
    return low < place - round_off * smaller_ && high > place + round_off * smaller_;
  }

 private:
  // Fills places_ with where the contacts of the same face lie along the line that it returns.
  Line list_places(const VertexContact& contact, const Face& own, const Face& facing) {
    Line line{outlines_.current[at(contact.edge)], outlines_.along(contact.edge).normalized()};
    places_.clear();
    for (const VertexContact* each : contacts_)
      if (each->edge_block == contact.edge_block ? own.has(each->edge) : facing.has(each->edge))
        places_.push_back(line.place(outlines_.current[at(each->vertex)]));
    return line;
  }

  // An end belongs to the contact that is there, or came in the place of what was there.
  [[nodiscard]] double part_of_end(double end, double place) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const double other : places_) nearest = std::min(nearest, std::abs(other - end));
    const double farthest = nearest + round_off * smaller_;
    if (nearest > in_line * smaller_ || std::abs(place - end) > farthest) return 0;
    const auto as_near =
        std::ranges::count_if(places_, [&](double other) { return std::abs(other - end) <= farthest; });
    return 1 / static_cast<double>(as_near);
  }

  const Outlines& outlines_;
  double smaller_;  // m, size of the smaller block
  std::span<const VertexContact* const> contacts_;
  std::vector<double> places_;  // m
};

// Calls act(index, contact, pair) for every contact.
template <typename Act>
void for_each_pair(const Outlines& outlines, const std::vector<double>& size,
                   const std::vector<VertexContact>& contacts, Act act) {
  std::vector<const VertexContact*> by_pair;
  for (const VertexContact& contact : contacts) by_pair.push_back(&contact);
  std::ranges::stable_sort(by_pair, {}, [](const VertexContact* each) { return blocks_of(*each); });
  for (auto first = by_pair.begin(); first != by_pair.end();) {
    const std::pair<int, int> blocks = blocks_of(**first);
    const auto last = std::find_if(first, by_pair.end(), [&](const auto* each) { return blocks_of(*each) != blocks; });
    PairOfBlocks pair(outlines, std::min(size[at(blocks.first)], size[at(blocks.second)]), std::span(first, last));
    for (auto each = first; each != last; ++each) act(static_cast<std::size_t>(*each - contacts.data()), **each, pair);
    first = last;
  }
}

}  // namespace

bool edges_lie_on_each_other(const Outlines& outlines, const VertexContact& contact) {
  constexpr double most_lean = 0.05;  // sine of the angle, by which stretches of the projected law may gape, too
  const Vec2 along = outlines.along(contact.edge), facing = outlines.along(facing_edge(outlines, contact));
  return std::abs(cross(along, facing)) <= most_lean * along.norm() * facing.norm() && along.dot(facing) < 0;
}

void drop_within_faces(const Outlines& outlines, const std::vector<double>& size,
                       const std::function<bool(const VertexContact&)>& concerns, std::vector<VertexContact>& found) {
  const auto is_within = [&](const VertexContact& contact) {
    return is_within_face(outlines, contact.vertex) && concerns(contact);
  };
  if (std::ranges::none_of(found, is_within)) return;
  std::vector<char> out(found.size());
  for_each_pair(outlines, size, found, [&](std::size_t i, const VertexContact& contact, PairOfBlocks& pair) {
    out[i] = is_within(contact) && pair.has_others_on_both_sides(contact) ? 1 : 0;
  });
  take_out(out, found);
}

std::vector<double> shares_of_faces(const Outlines& outlines, const std::vector<double>& size,
                                    const std::vector<VertexContact>& contacts) {
  std::vector<double> shares(contacts.size());
  for_each_pair(outlines, size, contacts, [&](std::size_t i, const VertexContact& contact, PairOfBlocks& pair) {
    shares[i] = pair.share_of(contact);
  });
  return shares;
}

}  // namespace dda
