#include "engine/scene/laid_bare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "engine/geometry/polygon.h"
#include "engine/scene/places.h"
#include "engine/scene/present_blocks.h"

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

void expect_away(const Field& name, const std::vector<int>& blocks, const StageSpan& stages, const char* expected,
                 const Model& model) {
  for (std::size_t stage = 0; stage < model.stages.size(); ++stage) {
    if (!stages.has(stage)) continue;
    const std::vector<bool> absent = model.absent_in(stage);
    const auto there = std::ranges::find_if(blocks, [&](int block) { return absent.empty() || !absent[at(block)]; });
    if (there == blocks.end()) continue;
    name.fail(fmt::format("\"{}\", of which \"{}\" is there in stage \"{}\"", name.text(),
                          model.blocks[at(*there)].name, model.stages[stage].name),
              expected);
  }
}

// Appends the faces of blocks that are there across this edge of a block that is away.
void append_faces_along(const Segment& edge, const GroundPlan& plan, std::vector<Stretch>& faces) {
  const Vec2 along = edge.end - edge.start;
  const Vec2 own_inward(-along.y(), along.x());
  for (const Stretch& face : plan.stretches_along(edge))
    if (face.inward.dot(own_inward) < 0) faces.push_back(face);
}

void append_faces(const Ring& ring, const GroundPlan& plan, std::vector<Stretch>& faces) {
  for (std::size_t i = 0; i < ring.size(); ++i) append_faces_along({ring[i], ring[(i + 1) % ring.size()]}, plan, faces);
}

}  // namespace

std::vector<Stretch> faces_laid_bare(const Field& name, const std::vector<std::string>& groups, const StageSpan& stages,
                                     const char* expected, const Model& model) {
  const std::vector<int> blocks = blocks_called(name, groups, model);
  expect_away(name, blocks, stages, expected, model);
  const PresentBlocks present(model, at(stages.first));
  const GroundPlan plan(present.model);
  std::vector<Stretch> faces;
  for (const int block : blocks) {
    const Polygon& shape = model.blocks[at(block)].shape;
    append_faces(shape.outer, plan, faces);
    for (const Ring& hole : shape.holes) append_faces(hole, plan, faces);
  }
  if (faces.empty()) name.fail("blocks that lay faces of others bare");
  return present.in_whole(faces);
}

std::vector<Stretch> faces_around(const Ring& outline, std::size_t stage, const Model& model) {
  const PresentBlocks present(model, stage);
  std::vector<Stretch> faces;
  append_faces(normalized(Polygon{outline, {}}).outer, GroundPlan(present.model), faces);
  return present.in_whole(faces);
}

}  // namespace dda
