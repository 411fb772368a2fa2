#include <fmt/format.h>

#include <limits>
#include <set>

#include "engine/model/check_parts.h"
#include "engine/model/checks.h"
#include "engine/model/lining_chord.h"

namespace dda::model_checks {
namespace {

void check_node(const Model& model, const Item& item, const LiningNode& node) {
  check_point(model, item, node.block, node.point);
  item.finite("tangent", node.tangent);
  item.within("tangent length", node.tangent.norm(), 1 - 1e-9, 1 + 1e-9);
}

void check_section(const Item& item, const Lining& lining) {
  item.positive("thickness", lining.thickness);
  item.positive("Young's modulus", lining.young);
  item.within("Poisson's ratio", lining.poisson, 0, 0.4999);
  const bool crushes = lining.compressive_strength != std::numeric_limits<double>::infinity();
  if (crushes) item.positive("compressive strength", lining.compressive_strength);
  if (lining.tensile_strength != std::numeric_limits<double>::infinity())
    item.not_negative("tensile strength", lining.tensile_strength);
  if (lining.yields() && !crushes) item.fail("compressive strength", "missing", "one, beside a tensile strength");
}

void check_lining(const Model& model, const Item& item, const Lining& lining) {
  check_section(item, lining);
  const std::size_t least = lining.closed ? 3 : 2;
  if (lining.nodes.size() < least)
    item.fail("nodes", fmt::format("{}", lining.nodes.size()), fmt::format("at least {} faces of the wall", least));
  for (const LiningNode& node : lining.nodes) check_node(model, item, node);
  for (std::size_t i = 0; i < lining.elements(); ++i)
    if (chord_of(lining, i).norm() <= model.length_tolerance)
      item.fail("nodes", fmt::format("{} and {} in one place", i, i + 1), "faces one behind the other");
  if (lining.first_stage != 0) item.index("first stage", lining.first_stage, model.stages.size());
  check_withdrawal(item, lining.withdrawal, lining.first_stage, model);
}

}  // namespace

void check_linings(const Model& model) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < model.linings.size(); ++i) {
    const Item item("linings", i, model.linings[i].name);
    check_lining(model, item, model.linings[i]);
    if (!names.insert(model.linings[i].name).second) item.fail("name", "used before", "a name of its own");
  }
}

}  // namespace dda::model_checks
