#include "verification/cases/bonded_beam.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "verification/cases/contact_rig.h"

namespace verify {
namespace {

// Calls f(block, from, to) for every edge of a block that lies at `x`.
template <typename Function>
void for_edges_at(double x, const dda::Model& model, const Function& f) {
  for (std::size_t block = 0; block < model.blocks.size(); ++block) {
    const dda::Ring& ring = model.blocks[block].shape.outer;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const dda::Vec2& from = ring[k];
      const dda::Vec2& to = ring[(k + 1) % ring.size()];
      if (std::abs(from.x() - x) < 1e-9 && std::abs(to.x() - x) < 1e-9) f(static_cast<int>(block), from, to);
    }
  }
}

double mean_shear(const exact::Cantilever& beam, double load, const dda::Vec2& from, const dda::Vec2& to) {
  return exact::mean_shear_stress(beam, load, std::min(from.y(), to.y()), std::max(from.y(), to.y()));
}

int block_at(const dda::Model& model, const dda::Vec2& corner) {
  for (std::size_t i = 0; i < model.blocks.size(); ++i)
    for (const dda::Vec2& vertex : model.blocks[i].shape.outer)
      if ((vertex - corner).norm() < 1e-9) return static_cast<int>(i);
  throw std::logic_error("no block has the corner that is to be held");
}

}  // namespace

dda::Model bonded_beam(const std::vector<dda::Ring>& blocks, const dda::Material& rock) {
  dda::Model model;
  model.materials = {rock};
  dda::JointMaterial joint;
  joint.law = dda::InterfaceLaw::consistent;
  joint.bonded = true;
  model.joints = {joint};
  for (const dda::Ring& ring : blocks) model.blocks.emplace_back().shape.outer = ring;
  return model;
}

void load_free_end(const exact::Cantilever& beam, double load, dda::Model& model) {
  for_edges_at(beam.length, model, [&](int block, const dda::Vec2& from, const dda::Vec2& to) {
    model.edge_loads.push_back({block, from, to, {0, mean_shear(beam, load, from, to)}, {}});
  });
}

void load_held_end(const exact::Cantilever& beam, double load, dda::Model& model) {
  for_edges_at(0, model, [&](int block, const dda::Vec2& from, const dda::Vec2& to) {
    const double fibre = exact::fibre_stress(beam, load, 0, (from.y() + to.y()) / 2);  // linear: its mean
    model.edge_loads.push_back({block, from, to, {-fibre, -mean_shear(beam, load, from, to)}, {}});
  });
}

void keep_in_place(const exact::Cantilever& beam, dda::Model& model) {
  const dda::Vec2 foot(0, -beam.height / 2);
  const dda::Vec2 head(0, beam.height / 2);
  const double stiffness = 1e4 * beam.young;
  model.supports = {{block_at(model, foot), foot, true, true, stiffness, dda::Vec2::Zero(), {}},
                    {block_at(model, head), head, true, false, stiffness, dda::Vec2::Zero(), {}}};
}

dda::Stage two_static_steps() {
  dda::Stage stage = moving_stage(dda::static_integrator(), 1e3, 2e3);
  stage.kinematics = dda::Kinematics::small;
  return stage;
}

double working_deflection(dda::Model model, double load, Outcome& outcome) {
  model.stages = {two_static_steps()};
  WatchedRun run(std::move(model));
  run.run_to_end();
  outcome.counters += run.simulation().counters();
  return run.simulation().energy().external_work / load;
}

}  // namespace verify
