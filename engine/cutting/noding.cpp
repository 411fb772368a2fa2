#include "engine/cutting/noding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>

#include "engine/core/parallel_sort.h"
#include "engine/core/where.h"
#include "engine/cutting/quadrants.h"
#include "engine/geometry/segment.h"

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Where a node may lie exactly. Of all candidates in a pixel the first counts.
enum class Kind { known, crossing, end_of_piece };

struct Candidate {
  Pixel pixel;
  Kind kind = Kind::known;
  Vec2 position;

  [[nodiscard]] auto key() const { return std::tuple(pixel, kind, position.x(), position.y()); }
};

bool comes_first(const Vec2& a, const Vec2& b) { return std::tuple(a.x(), a.y()) < std::tuple(b.x(), b.y()); }

// From left to right, so that the crossing has the same bits whichever way a line was drawn.
Straight ordered(Straight straight) {
  if (comes_first(straight.to, straight.from)) std::swap(straight.from, straight.to);
  return straight;
}

Vec2 crossing_of_lines(const Straight& one, const Straight& other) {
  Straight a = ordered(one);
  Straight b = ordered(other);
  if (comes_first(b.from, a.from) || (b.from == a.from && comes_first(b.to, a.to))) std::swap(a, b);
  const double from_side = cross(a.to - a.from, Vec2(b.from - a.from));
  const double to_side = cross(a.to - a.from, Vec2(b.to - a.from));
  return b.from + from_side / (from_side - to_side) * (b.to - b.from);
}

// Lines that are almost parallel cross where round-off wants: then the middle of the pixel is as good.
Vec2 place_of_crossing(const Pixel& pixel, const Straight& a, const Straight& b, const PixelGrid& grid) {
  const Vec2 centre = grid.centre_of(pixel);
  const Vec2 computed = crossing_of_lines(a, b);
  return (computed - centre).cwiseAbs().maxCoeff() <= grid.step() ? computed : centre;
}

std::size_t sum_of(const std::vector<std::size_t>& counts) { return std::reduce(counts.begin(), counts.end()); }

// Returns how many pairs were looked at.
std::size_t add_crossings(const std::vector<Piece>& pieces, const std::vector<Straight>& straights,
                          const PixelGrid& grid, std::vector<Candidate>& found) {
  std::vector<std::size_t> looked_at(most_parts_of_plane, 0);
  std::vector<std::vector<Candidate>> parts(most_parts_of_plane);
  visit_crowds(pieces, [&](std::size_t part, const Quadrant& quadrant, std::span<const NearPiece> crowd) {
    looked_at[part] += crowd.size() * (crowd.size() - 1) / 2;
    for (std::size_t i = 0; i < crowd.size(); ++i) {
      for (std::size_t j = i + 1; j < crowd.size(); ++j) {
        const auto pixel = crossing(crowd[i].segment, crowd[j].segment);
        if (!pixel || !quadrant.holds(*pixel)) continue;
        const Straight& a = straights[at(pieces[at(crowd[i].piece)].straight)];
        const Straight& b = straights[at(pieces[at(crowd[j].piece)].straight)];
        parts[part].push_back({*pixel, Kind::crossing, place_of_crossing(*pixel, a, b, grid)});
      }
    }
  });
  const std::vector<Candidate> crossings = in_one_list(std::move(parts));
  found.insert(found.end(), crossings.begin(), crossings.end());
  return sum_of(looked_at);
}

std::vector<Candidate> candidates_of(const std::vector<Piece>& pieces, const std::vector<Straight>& straights,
                                     const std::vector<KnownNode>& known, const PixelGrid& grid,
                                     std::size_t& looked_at) {
  std::vector<Candidate> found;
  for (const KnownNode& node : known) found.push_back({node.pixel, Kind::known, node.position});
  for (const Piece& piece : pieces) {
    for (const Pixel& end : {piece.segment.from, piece.segment.to})
      found.push_back({end, Kind::end_of_piece, grid.centre_of(end)});
  }
  looked_at += add_crossings(pieces, straights, grid, found);
  return found;
}

void fill_nodes(std::vector<Candidate> candidates, Noding& noding) {
  parallel_sort(candidates, [](const Candidate& a, const Candidate& b) { return a.key() < b.key(); });
  for (const Candidate& candidate : candidates) {
    if (!noding.pixels.empty() && noding.pixels.back() == candidate.pixel) continue;
    noding.pixels.push_back(candidate.pixel);
    noding.positions.push_back(candidate.position);
  }
}

// A piece enters pixels in an order in which neither x nor y ever goes back.
struct Entry {
  int piece = 0;
  std::int64_t way = 0;
  int node = 0;
};

bool operator<(const Entry& a, const Entry& b) {
  return std::tie(a.piece, a.way, a.node) < std::tie(b.piece, b.way, b.node);
}

// The way between two pixels is the sum of the differences in x and y, at most as many times their distance.
constexpr double way_of_diagonal = 1.5;  // more than the root of 2

std::int64_t way_along(const PixelSegment& segment, const Pixel& pixel) {
  const Pixel along = segment.to - segment.from;
  return (along.x < 0 ? -pixel.x : pixel.x) + (along.y < 0 ? -pixel.y : pixel.y);
}

// Whether a segment passes within some pixels of one, or may: with pixels to spare, more than the round-off.
class Passing {
 public:
  explicit Passing(const PixelSegment& segment, double reach)
      : from_(segment.from),
        dx_(static_cast<double>(segment.to.x - segment.from.x)),
        dy_(static_cast<double>(segment.to.y - segment.from.y)),
        length_(std::hypot(dx_, dy_)),
        room_((reach + pixels_to_spare) * length_) {}

  [[nodiscard]] bool by(const Pixel& pixel) const {
    const auto x = static_cast<double>(pixel.x - from_.x);
    const auto y = static_cast<double>(pixel.y - from_.y);
    if (std::abs(x * dy_ - y * dx_) > room_) return false;
    const double along = x * dx_ + y * dy_;
    return along >= -room_ && along <= length_ * length_ + room_;
  }

 private:
  static constexpr double pixels_to_spare = 4;
  Pixel from_;
  double dx_, dy_, length_, room_;
};

struct Entries {
  std::vector<Entry> all;     // which nodes each piece enters, by piece and along it
  std::vector<int> crowded;   // nodes that a piece passes within reach without entering them
  std::size_t looked_at = 0;  // pairs
};

Entries entries_of(const std::vector<Piece>& pieces, const std::vector<Pixel>& pixels, double reach) {
  std::vector<std::vector<Entry>> parts(most_parts_of_plane);
  std::vector<std::vector<int>> near(most_parts_of_plane);
  std::vector<std::size_t> looked_at(most_parts_of_plane, 0);
  visit_meetings(pieces, pixels, reach,
                 [&](std::size_t part, std::span<const NearPiece> crowd, std::span<const NearNode> nodes) {
                   looked_at[part] += crowd.size() * nodes.size();
                   for (const NearPiece& piece : crowd) {
                     const Passing passing(piece.segment, reach);
                     for (const NearNode& node : nodes) {
                       if (!passing.by(node.pixel)) continue;
                       if (enters(piece.segment, node.pixel))
                         parts[part].push_back({piece.piece, way_along(piece.segment, node.pixel), node.node});
                       else
                         near[part].push_back(node.node);
                     }
                   }
                 });
  Entries entries{in_one_list(std::move(parts)), in_one_list(std::move(near)), sum_of(looked_at)};
  parallel_sort(entries.all);
  return entries;
}

void add_link(Noding& noding, int a, int b, int straight) {
  if (a != b) noding.links.push_back({std::min(a, b), std::max(a, b), straight});
}

void drop_repeated(std::vector<Link>& links) { links.erase(std::unique(links.begin(), links.end()), links.end()); }

// One noding after another.
class Again {
 public:
  Again(const Renoding& changed, const std::vector<Straight>& straights, const PixelGrid& grid)
      : changed_(changed), region_(changed.pixels, changed.places, changed.reach) {
    is_near_ = flags_where(changed.links.size(), [&](std::size_t i) {
      return changed.links[i].is_changed || region_.meets(box_of(segment_of(changed.links[i].link)));
    });
    for (std::size_t i = 0; i < is_near_.size(); ++i) {
      const Link& link = changed.links[i].link;
      if (is_near_[i] != 0) near_.push_back({segment_of(link), link.straight});
    }
    std::vector<Candidate> crossings;
    noding_.pairs_looked_at = add_crossings(near_, straights, grid, crossings);
    place_nodes(std::move(crossings));
  }

  Noding links() {
    std::vector<char> is_asked = flags_where(noding_.pixels.size(), [&](std::size_t node) {
      return region_.meets({noding_.pixels[node], noding_.pixels[node]});
    });
    for (std::size_t i = 0; i < is_near_.size(); ++i) {
      const Link& link = changed_.links[i].link;
      const int from = new_number_[at(link.from)];
      const int to = new_number_[at(link.to)];
      if (is_near_[i] != 0)
        is_asked[at(from)] = is_asked[at(to)] = 1;
      else
        add_link(noding_, from, to, link.straight);
    }
    add_near_links(is_asked);
    sort_others(noding_.links);
    drop_repeated(noding_.links);
    noding_.pieces_noded = near_.size();
    return std::move(noding_);
  }

 private:
  [[nodiscard]] PixelSegment segment_of(const Link& link) const {
    return {changed_.pixels[at(link.from)], changed_.pixels[at(link.to)]};
  }

  // Nodes that stay, and crossings between them; a node that stays counts before a crossing in its pixel.
  void place_nodes(std::vector<Candidate> crossings) {
    std::vector<int> staying;
    for (std::size_t node = 0; node < changed_.stays.size(); ++node) {
      if (changed_.stays[node]) staying.push_back(static_cast<int>(node));
    }
    const auto candidate = [&](int node) {
      return Candidate{changed_.pixels[at(node)], Kind::known, changed_.positions[at(node)]};
    };
    const auto less = [](const Candidate& a, const Candidate& b) { return a.key() < b.key(); };
    sort_others(staying,
                [&](int a, int b) { return std::pair(candidate(a).key(), a) < std::pair(candidate(b).key(), b); });
    std::sort(crossings.begin(), crossings.end(), less);
    new_number_.assign(changed_.stays.size(), -1);
    auto crossing = crossings.begin();
    for (const int node : staying) {
      for (; crossing != crossings.end() && less(*crossing, candidate(node)); ++crossing) add_node(*crossing);
      add_node(candidate(node));
      new_number_[at(node)] = static_cast<int>(noding_.pixels.size()) - 1;
    }
    for (; crossing != crossings.end(); ++crossing) add_node(*crossing);
  }

  void add_node(const Candidate& candidate) {
    if (!noding_.pixels.empty() && noding_.pixels.back() == candidate.pixel) return;
    noding_.pixels.push_back(candidate.pixel);
    noding_.positions.push_back(candidate.position);
  }

  void add_near_links(const std::vector<char>& is_asked) {
    std::vector<Pixel> pixels;
    std::vector<int> numbers;
    for (std::size_t node = 0; node < is_asked.size(); ++node) {
      if (is_asked[node] == 0) continue;
      pixels.push_back(noding_.pixels[node]);
      numbers.push_back(static_cast<int>(node));
    }
    const Entries found = entries_of(near_, pixels, 0);
    const std::vector<Entry>& entries = found.all;
    noding_.pairs_looked_at += found.looked_at;
    for (std::size_t i = 1; i < entries.size(); ++i) {
      if (entries[i].piece != entries[i - 1].piece) continue;
      add_link(noding_, numbers[at(entries[i - 1].node)], numbers[at(entries[i].node)],
               near_[at(entries[i].piece)].straight);
    }
  }

  const Renoding& changed_;
  PixelRegion region_;
  std::vector<char> is_near_;  // by link
  std::vector<Piece> near_;
  std::vector<int> new_number_;  // by node; -1: it does not stay
  Noding noding_;
};

}  // namespace

Noding node_pieces(const std::vector<Piece>& pieces, const std::vector<Straight>& straights,
                   const std::vector<KnownNode>& known, const PixelGrid& grid, double reach) {
  Noding noding;
  noding.pieces_noded = pieces.size();
  fill_nodes(candidates_of(pieces, straights, known, grid, noding.pairs_looked_at), noding);
  Entries found = entries_of(pieces, noding.pixels, reach);
  noding.pairs_looked_at += found.looked_at;
  const std::vector<Entry>& entries = found.all;
  for (std::size_t i = 1; i < entries.size(); ++i) {
    if (entries[i].piece != entries[i - 1].piece) continue;
    add_link(noding, entries[i - 1].node, entries[i].node, pieces[at(entries[i].piece)].straight);
    if (static_cast<double>(entries[i].way - entries[i - 1].way) <= way_of_diagonal * (reach + 1))
      found.crowded.push_back(entries[i].node);
  }
  parallel_sort(noding.links);
  drop_repeated(noding.links);
  for (const int node : found.crowded) noding.crowded.push_back({noding.pixels[at(node)], noding.pixels[at(node)]});
  return noding;
}

Noding node_again(const Renoding& changed, const std::vector<Straight>& straights, const PixelGrid& grid) {
  return Again(changed, straights, grid).links();
}

}  // namespace dda
