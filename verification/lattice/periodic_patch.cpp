#include "verification/lattice/periodic_patch.h"

namespace verify {
namespace {

void add_cell(const PeriodicMesh& mesh, const dda::Vec2& shift, dda::Model& model) {
  for (dda::Ring ring : mesh.cell) {
    for (dda::Vec2& vertex : ring) vertex += shift;
    model.blocks.emplace_back().shape.outer = ring;
  }
}

}  // namespace

dda::Model periodic_patch(const PeriodicMesh& mesh, int around, const dda::Material& rock,
                          const dda::JointMaterial& bond) {
  dda::Model model;
  model.materials = {rock};
  model.joints = {bond};
  for (int i = -around; i <= around; ++i)
    for (int j = -around; j <= around; ++j) add_cell(mesh, i * mesh.first + j * mesh.second, model);
  dda::Stage stage;
  stage.dt = stage.duration = 1;
  stage.kinematics = dda::Kinematics::small;
  model.stages = {stage};
  dda::finish_model(model);
  return model;
}

}  // namespace verify
