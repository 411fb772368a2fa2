#include "engine/cutting/needless_prolongations.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// A link along which a straight is only prolonged.
struct ProlongedLink {
  int link = 0;
  int straight = 0;
  bool at_end = false;  // of the straight, or at its start
  double share = 0;     // of the straight, beyond its end
};

// Beyond the end that was drawn by how much of the straight: 0 between its ends, negative before the first.
double share_beyond(const Link& link, const Noding& noding, const PlanPieces& pieces) {
  const Straight& line = pieces.straights[at(link.straight)];
  const Vec2 along = line.to - line.from;
  const Vec2 middle = (noding.positions[at(link.from)] + noding.positions[at(link.to)]) / 2;
  const double share = along.dot(middle - line.from) / along.squaredNorm();
  return share < 0 ? share : std::max(share - 1, 0.0);
}

// Links that are only prolonged, by straight and outwards at either of its ends.
std::vector<ProlongedLink> prolonged_links(const Noding& noding, const PlanPieces& pieces) {
  std::vector<ProlongedLink> found;
  for (std::size_t i = 0; i < noding.links.size(); ++i) {
    const Link& link = noding.links[i];
    if (!pieces.prolonged[at(link.straight)]) continue;
    if (const double share = share_beyond(link, noding, pieces); share != 0)
      found.push_back({static_cast<int>(i), link.straight, share > 0, std::abs(share)});
  }
  std::sort(found.begin(), found.end(), [](const ProlongedLink& a, const ProlongedLink& b) {
    return std::tie(a.straight, a.at_end, a.share, a.link) < std::tie(b.straight, b.at_end, b.share, b.link);
  });
  return found;
}

// Whether another line was drawn along the link.
bool runs_along_other(int link, const Noding& noding, const PlanPieces& pieces) {
  const auto is_other = [&](std::size_t other) {
    return noding.links[other].straight != noding.links[at(link)].straight &&
           share_beyond(noding.links[other], noding, pieces) == 0;
  };
  const auto same = [&](std::size_t other) {
    return noding.links[other].from == noding.links[at(link)].from &&
           noding.links[other].to == noding.links[at(link)].to;
  };
  for (std::size_t other = at(link); other-- > 0 && same(other);) {
    if (is_other(other)) return true;
  }
  for (std::size_t other = at(link) + 1; other < noding.links.size() && same(other); ++other) {
    if (is_other(other)) return true;
  }
  return false;
}

}  // namespace

std::vector<bool> needless_prolongations(const Noding& noding, const PlanPieces& pieces) {
  std::vector<bool> is_needless(noding.links.size(), false);
  const std::vector<ProlongedLink> links = prolonged_links(noding, pieces);
  for (std::size_t i = 0; i < links.size(); ++i) {
    const ProlongedLink& each = links[i];
    const bool goes_on = i > 0 && links[i - 1].straight == each.straight && links[i - 1].at_end == each.at_end;
    is_needless[at(each.link)] =
        (goes_on && is_needless[at(links[i - 1].link)]) || runs_along_other(each.link, noding, pieces);
  }
  return is_needless;
}

}  // namespace dda
