// For tests: small models put together by hand.
#pragma once

#include <vector>

#include "engine/geometry/polygon.h"
#include "engine/geometry/rotation.h"
#include "engine/model/model.h"

namespace dda {

inline Ring box_ring(double left, double bottom, double right, double top) {
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

inline Material rock() { return {"rock", 2600, 1e9, 0.25, PlaneState::stress}; }

// Finished unless it has no blocks yet.
inline Model model_of(const std::vector<Polygon>& shapes, const Material& material = rock()) {
  Model model;
  model.materials = {material};
  for (const Polygon& shape : shapes) model.blocks.emplace_back().shape = shape;
  if (!shapes.empty()) finish_model(model);
  return model;
}

// All blocks turned about the origin by `angle` (rad) and then moved.
inline void place(Model& model, double angle, const Vec2& shift = Vec2::Zero()) {
  for (Block& block : model.blocks) {
    for (Vec2& vertex : block.shape.outer) vertex = rotation(angle) * vertex + shift;
    for (Ring& hole : block.shape.holes)
      for (Vec2& vertex : hole) vertex = rotation(angle) * vertex + shift;
  }
  finish_model(model);
}

}  // namespace dda
