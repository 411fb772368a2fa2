#include "engine/view/contact_sites.h"

#include <cmath>
#include <limits>

#include "engine/geometry/segment.h"

namespace dda {
namespace {

constexpr std::uint32_t whole = 65536;

}  // namespace

std::uint32_t ContactSites::number_of(const DrawnContact& contact) {
  const ContactSite site = site_of(contact);
  const auto [entry, is_new] = numbers_.try_emplace({site.block_a, site.block_b, site.from, site.fraction},
                                                    static_cast<std::uint32_t>(sites_.size()));
  if (is_new) sites_.push_back(site);
  return entry->second;
}

ContactSite ContactSites::site_of(const DrawnContact& contact) const {
  const auto block = static_cast<std::size_t>(contact.block_b);
  ContactSite nearest;
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t ring = drawing_.block_begin[block]; ring < drawing_.block_begin[block + 1]; ++ring) {
    const std::uint32_t begin = drawing_.ring_begin[ring];
    const std::uint32_t end = drawing_.ring_begin[ring + 1];
    for (std::uint32_t from = begin; from < end; ++from) {
      const std::uint32_t to = from + 1 < end ? from + 1 : begin;
      const Segment edge{drawing_.reference[from], drawing_.reference[to]};
      const double away = distance(edge, contact.reference);
      if (away >= least) continue;
      least = away;
      const double share = closest_parameter(edge, contact.reference);
      const auto fraction = static_cast<std::uint32_t>(std::lround(whole * share));
      const std::uint32_t next = to + 1 < end ? to + 1 : begin;
      nearest.from = fraction == whole ? to : from;
      nearest.to = fraction == whole ? next : to;
      nearest.fraction = fraction == whole ? 0 : fraction;
    }
  }
  nearest.block_a = static_cast<std::uint32_t>(contact.block_a);
  nearest.block_b = static_cast<std::uint32_t>(contact.block_b);
  return nearest;
}

}  // namespace dda
