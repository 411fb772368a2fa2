// Nodes that nobody drew and that lines only pass.
#pragma once

#include <vector>

#include "engine/cutting/noding.h"

namespace dda {

// Every line that comes to the node from one of the two others goes on to the other one.
struct PassedNode {
  int node = 0;
  int one = 0, other = 0;
};

struct PassedNodes {
  std::vector<PassedNode> passed;  // ascending
  std::vector<bool> is_tip;        // by node: nobody drew it, and links lead to one other node at most
};

// Dropped links do not count. A node to which an end or a corner as drawn was joined is not passed, although it may be
// a crossing: a line that ends there, or has its next leg there, does not go on.
PassedNodes passed_nodes(const Noding& noding, const std::vector<bool>& is_dropped, const std::vector<bool>& is_drawn);

}  // namespace dda
