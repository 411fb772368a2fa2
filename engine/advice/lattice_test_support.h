// For tests: scenes of blocks that repeat themselves.
#pragma once

#include "engine/advice/lattice.h"
#include "engine/contact/contact_models.h"
#include "engine/contact/make_contacts.h"

namespace dda {

inline JointMaterial bonded(InterfaceLaw law) {
  JointMaterial joint;
  joint.law = law;
  joint.bonded = true;
  return joint;
}

inline Stage steps(const Integrator& integrator, double dt) {
  Stage stage;
  stage.dt = stage.duration = dt;
  stage.integrator = integrator;
  stage.kinematics = Kinematics::small;
  return stage;
}

inline Model finished(Model model) {
  model.stages = {steps(trapezoidal_integrator(), 1e-4)};
  finish_model(model);
  return model;
}

inline Model row_of_blocks(const JointMaterial& joint, double length = 1, int blocks = 6) {
  Model model;
  model.materials = {rock()};
  model.joints = {joint};
  for (int i = 0; i < blocks; ++i)
    model.blocks.emplace_back().shape.outer = box_ring(i * length, 0, (i + 1) * length, 0.8);
  return finished(std::move(model));
}

// `shift` of every second course: 0 for squares, 0.5 for a running bond.
inline Model courses(const JointMaterial& joint, double shift, double height = 1) {
  Model model;
  model.materials = {rock()};
  model.joints = {joint};
  for (int row = 0; row < 4; ++row)
    for (int i = 0; i < 4; ++i) {
      const double left = i + (row % 2 == 1 ? shift : 0);
      model.blocks.emplace_back().shape.outer = box_ring(left, row * height, left + 1, (row + 1) * height);
    }
  return finished(std::move(model));
}

inline Lattice lattice_of(const Model& model) { return find_lattice(model, make_contacts(model), 0).value(); }

}  // namespace dda
