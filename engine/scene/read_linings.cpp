#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "engine/model/tolerance.h"
#include "engine/scene/lined_wall.h"
#include "engine/scene/places.h"
#include "engine/scene/read_withdrawal.h"
#include "engine/scene/sections.h"

namespace dda {
namespace {

// The Poisson's ratio of concrete, for linings that name none.
constexpr double default_poisson = 0.2;

void read_strength(const Field& field, Lining& lining) {
  const auto compressive = field.find("compressive_strength");
  if (!compressive) {
    refuse(field, {"tensile_strength"}, "without compressive_strength: the section then yields nowhere");
    return;
  }
  lining.compressive_strength = compressive->positive(Dimension::stress);
  lining.tensile_strength =
      value_or(field, "tensile_strength", 0.0, [](const Field& f) { return f.not_negative(Dimension::stress); });
}

// A node in the middle of every face that is no sliver.
void add_nodes(const Field& field, const LinedWall& wall, const Model& model, Lining& lining) {
  for (const Stretch& face : wall.faces) {
    const Vec2 along = face.to - face.from;
    if (along.norm() <= point_tolerance(model)) continue;
    lining.nodes.push_back({face.block, (face.from + face.to) / 2, along.normalized()});
  }
  lining.closed = wall.closed;
  const std::size_t least = lining.closed ? 3 : 2;
  if (lining.nodes.size() < least)
    field.fail(
        fmt::format("along {} face{} of blocks", lining.nodes.size(), lining.nodes.size() == 1 ? "" : "s"),
        fmt::format("a wall of at least {}, as the beam runs from the middle of one to that of the next", least));
}

void read_lining(const Field& field, const Walls& walls, Model& model) {
  Lining lining;
  lining.name = value_or(field, "name", fmt::format("lining {}", model.linings.size() + 1),
                         [](const Field& f) { return f.name(); });
  if (std::ranges::count(model.linings, lining.name, &Lining::name) > 0)
    field.at("name").fail("a name that no other lining has");
  lining.thickness = field.at("thickness").positive(Dimension::length);
  lining.young = field.at("young").positive(Dimension::stress);
  lining.poisson = value_or(field, "poisson", default_poisson, [](const Field& f) { return f.within(0, 0.4999); });
  lining.first_stage = value_or(field, "from_stage", 0, [&](const Field& f) { return read_stage_reference(f, model); });
  lining.withdrawal = read_withdrawal(field, lining.first_stage, model);
  read_strength(field, lining);
  add_nodes(field, walls.of(field, static_cast<std::size_t>(lining.first_stage)), model, lining);
  model.linings.push_back(std::move(lining));
}

}  // namespace

void read_linings(const Field& scene, const std::vector<std::string>& groups, const std::vector<PlanOpening>& openings,
                  Model& model) {
  const auto linings = scene.find("linings");
  if (!linings) return;
  const Walls walls(groups, openings, model);
  for (const Field& lining : linings->items()) read_lining(lining, walls, model);
}

}  // namespace dda
