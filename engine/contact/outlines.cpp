#include "engine/contact/outlines.h"

#include <algorithm>
#include <cstddef>

#include "engine/contact/pair_motion.h"
#include "engine/core/parallel.h"

namespace dda {
namespace {

void append_ring(const Ring& ring, const Vec2& centroid, Outlines& outlines) {
  const int first = static_cast<int>(outlines.reference.size());
  const int size = static_cast<int>(ring.size());
  for (int i = 0; i < size; ++i) {
    outlines.reference.emplace_back(ring[static_cast<std::size_t>(i)] - centroid);
    outlines.next.push_back(first + (i + 1) % size);
    outlines.previous.push_back(first + (i + size - 1) % size);
  }
}

constexpr std::size_t outlines_worth_sharing = 512;

}  // namespace

Outlines make_outlines(const Model& model, const State& state) {
  Outlines outlines;
  outlines.starts.push_back(0);
  for (const Block& block : model.blocks) {
    append_ring(block.shape.outer, block.moments.centroid, outlines);
    for (const Ring& hole : block.shape.holes) append_ring(hole, block.moments.centroid, outlines);
    outlines.starts.push_back(static_cast<int>(outlines.reference.size()));
  }
  outlines.current.resize(outlines.reference.size());
  outlines.length.resize(outlines.reference.size());
  outlines.coming.assign(outlines.reference.size(), Vec2::Zero());
  outlines.boxes.resize(model.blocks.size());
  update_outlines(model, state, outlines);
  return outlines;
}

void update_outlines(const Model& model, const State& state, Outlines& outlines) {
  parallel_for_each(outlines.boxes.size(), outlines_worth_sharing, [&](std::size_t block) {
    const Vec2 centroid = local_centroid(model, state, static_cast<int>(block));
    Box box;
    for (int i = outlines.starts[block]; i < outlines.starts[block + 1]; ++i) {
      const auto vertex = static_cast<std::size_t>(i);
      outlines.current[vertex] = centroid + state.deformation[block] * outlines.reference[vertex];
      box = expanded(box, outlines.current[vertex]);
    }
    for (int i = outlines.starts[block]; i < outlines.starts[block + 1]; ++i)
      outlines.length[static_cast<std::size_t>(i)] = outlines.along(i).norm();
    outlines.boxes[block] = box;
  });
}

void foresee_motion(const Model& model, const State& state, double time, Outlines& outlines) {
  if (time == 0) {
    std::ranges::fill(outlines.coming, Vec2(0, 0));
    return;
  }
  parallel_for_each(outlines.boxes.size(), outlines_worth_sharing, [&](std::size_t block) {
    const Vec6 increments = time * state.velocity[block];
    const Vec2 centroid = local_centroid(model, state, static_cast<int>(block));
    for (int i = outlines.starts[block]; i < outlines.starts[block + 1]; ++i) {
      const auto vertex = static_cast<std::size_t>(i);
      outlines.coming[vertex] = displacement_of(increments, outlines.current[vertex] - centroid);
    }
  });
}

}  // namespace dda
