#include "engine/linear/block_order.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

using Graph = std::vector<std::vector<int>>;

Graph neighbours_of(const BlockMatrix& matrix) {
  Graph neighbours(at(matrix.size()));
  for (int j = 0; j < matrix.size(); ++j) {
    for (int k = matrix.column_starts()[at(j)] + 1; k < matrix.column_starts()[at(j) + 1]; ++k) {
      const int i = matrix.block_rows()[at(k)];
      neighbours[at(i)].push_back(j);
      neighbours[at(j)].push_back(i);
    }
  }
  return neighbours;
}

// Numbers `start` and all that can be reached from it, generation by generation; within one by number of neighbours.
void number_from(int start, const Graph& graph, std::vector<bool>& numbered, std::vector<int>& order) {
  std::size_t next = order.size();
  order.push_back(start);
  numbered[at(start)] = true;
  for (; next < order.size(); ++next) {
    const auto first = static_cast<std::ptrdiff_t>(order.size());
    for (const int each : graph[at(order[next])]) {
      if (numbered[at(each)]) continue;
      numbered[at(each)] = true;
      order.push_back(each);
    }
    std::stable_sort(order.begin() + first, order.end(),
                     [&](int a, int b) { return graph[at(a)].size() < graph[at(b)].size(); });
  }
}

// A block far out: the last that is reached from the last that is reached from `start`.
int far_end(int start, const Graph& graph, const std::vector<bool>& numbered) {
  for (int turn = 0; turn < 2; ++turn) {
    std::vector<bool> reached = numbered;
    std::vector<int> order;
    number_from(start, graph, reached, order);
    start = order.back();
  }
  return start;
}

}  // namespace

std::vector<int> cuthill_mckee_order(const BlockMatrix& matrix) {
  const Graph graph = neighbours_of(matrix);
  std::vector<bool> numbered(graph.size(), false);
  std::vector<int> order;
  for (int i = 0; i < matrix.size(); ++i) {
    if (graph[at(i)].size() <= static_cast<std::size_t>(hub_degree)) continue;
    numbered[at(i)] = true;
    order.push_back(i);
  }
  for (int i = 0; i < matrix.size(); ++i) {
    if (numbered[at(i)]) continue;
    number_from(far_end(i, graph, numbered), graph, numbered, order);
  }
  std::reverse(order.begin(), order.end());
  return order;
}

Halves cut_in_halves(const BlockMatrix& matrix, std::vector<int>& order) {
  const std::size_t middle = order.size() / 2;
  std::vector<std::size_t> position(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) position[at(order[k])] = k;
  std::vector<bool> couples(order.size(), false);  // by position: of the second half, with neighbours in the first
  for (int j = 0; j < matrix.size(); ++j) {
    for (int k = matrix.column_starts()[at(j)] + 1; k < matrix.column_starts()[at(j) + 1]; ++k) {
      const auto [low, high] = std::minmax(position[at(matrix.block_rows()[at(k)])], position[at(j)]);
      if (low < middle && high >= middle) couples[high] = true;
    }
  }
  const auto between = static_cast<std::size_t>(std::ranges::count(couples, true));
  if (8 * between > order.size()) return {};
  std::vector<int> cut(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(middle));
  for (std::size_t k = order.size(); k-- > middle;)
    if (!couples[k]) cut.push_back(order[k]);
  for (std::size_t k = middle; k < order.size(); ++k)
    if (couples[k]) cut.push_back(order[k]);
  order = std::move(cut);
  return {middle, order.size() - between};
}

}  // namespace dda
