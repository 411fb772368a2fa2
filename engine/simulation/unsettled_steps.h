// Steps for whose contacts quick passes found no balance, so that it was found from inside or they were taken in parts.
//
// Where friction leaves open how contacts share forces, the quick passes may find one of the answers or none, and which
// of these depends on the way there: on round-off, the numbering of blocks, the solver. Interior passes may find
// another answer, and a step that is taken in parts ends elsewhere than one that is not, by what its length leaves
// unresolved.
#pragma once

#include <cstdint>

namespace dda {

struct UnsettledSteps {
  std::int64_t count = 0;
  double first_time = 0;           // s, at which the first of them begins
  int block_a = -1, block_b = -1;  // at the contact that changed most in its last pass; -1: none did
  std::int64_t last = -1;          // step that was noted last

  // The step with the number `step` is noted once, however many of its parts find no balance either.
  void note(std::int64_t step, double time, int a, int b) {
    if (step == last) return;
    last = step;
    if (count++ > 0) return;
    first_time = time;
    block_a = a;
    block_b = b;
  }

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [count, first_time, block_a, block_b, last] = self;
    archive.blocks_or_none(block_a, block_b);
    archive(count, first_time, last);
  }
};

}  // namespace dda
