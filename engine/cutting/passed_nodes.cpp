#include "engine/cutting/passed_nodes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>

namespace dda {
namespace {

constexpr int none = -1;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// By node, up to three others that links lead to.
using Neighbours = std::vector<std::array<int, 3>>;

Neighbours neighbours_of(const Noding& noding, const std::vector<bool>& is_dropped) {
  Neighbours found(noding.pixels.size(), {none, none, none});
  const auto add = [&](int node, int other) {
    auto& others = found[at(node)];
    const auto place =
        std::find_if(others.begin(), others.end(), [&](int each) { return each == none || each == other; });
    if (place != others.end()) *place = other;
  };
  for (std::size_t i = 0; i < noding.links.size(); ++i) {
    if (is_dropped[i]) continue;
    add(noding.links[i].from, noding.links[i].to);
    add(noding.links[i].to, noding.links[i].from);
  }
  return found;
}

// A line that comes to a node.
struct Arrival {
  int node = 0;
  int straight = 0;
  int from = 0;
};

// At the nodes that have two neighbours, by node and straight.
std::vector<Arrival> arrivals_of(const Noding& noding, const std::vector<bool>& is_dropped,
                                 const std::vector<bool>& has_two) {
  std::vector<Arrival> arrivals;
  for (std::size_t i = 0; i < noding.links.size(); ++i) {
    if (is_dropped[i]) continue;
    const Link& link = noding.links[i];
    if (has_two[at(link.from)]) arrivals.push_back({link.from, link.straight, link.to});
    if (has_two[at(link.to)]) arrivals.push_back({link.to, link.straight, link.from});
  }
  std::sort(arrivals.begin(), arrivals.end(), [](const Arrival& a, const Arrival& b) {
    return std::tie(a.node, a.straight, a.from) < std::tie(b.node, b.straight, b.from);
  });
  return arrivals;
}

// Nodes with two neighbours at which a line comes from one of them only.
std::vector<bool> ends_of_lines(const std::vector<Arrival>& arrivals, std::size_t nodes) {
  std::vector<bool> is_end(nodes, false);
  for (std::size_t i = 0; i < arrivals.size(); ++i) {
    const auto goes_on = [&](std::size_t other) {
      return arrivals[other].node == arrivals[i].node && arrivals[other].straight == arrivals[i].straight;
    };
    const bool is_one_of_two = (i > 0 && goes_on(i - 1)) || (i + 1 < arrivals.size() && goes_on(i + 1));
    if (!is_one_of_two) is_end[at(arrivals[i].node)] = true;
  }
  return is_end;
}

}  // namespace

PassedNodes passed_nodes(const Noding& noding, const std::vector<bool>& is_dropped, const std::vector<bool>& is_drawn) {
  const std::size_t nodes = noding.pixels.size();
  const Neighbours near = neighbours_of(noding, is_dropped);
  PassedNodes found{{}, std::vector<bool>(nodes, false)};
  std::vector<bool> has_two(nodes, false);
  for (std::size_t node = 0; node < nodes; ++node) {
    const auto& [one, other, third] = near[node];
    found.is_tip[node] = !is_drawn[node] && other == none;
    has_two[node] = !is_drawn[node] && other != none && third == none;
  }
  const std::vector<bool> is_end = ends_of_lines(arrivals_of(noding, is_dropped, has_two), nodes);
  for (std::size_t node = 0; node < nodes; ++node) {
    if (has_two[node] && !is_end[node]) found.passed.push_back({static_cast<int>(node), near[node][0], near[node][1]});
  }
  return found;
}

}  // namespace dda
