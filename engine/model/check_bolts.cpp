#include <fmt/format.h>

#include <limits>
#include <set>

#include "engine/model/check_parts.h"
#include "engine/model/checks.h"

namespace dda::model_checks {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

void check_link(const Model& model, const Item& item, const BoltLink& link) {
  check_point(model, item, link.block_a, link.point_a);
  check_point(model, item, link.block_b, link.point_b);
  if (link.block_a == link.block_b) item.fail("link", "between a block and itself", "two blocks");
  item.positive("axial stiffness", link.axial_stiffness);
  item.not_negative("shear stiffness", link.shear_stiffness);
  item.not_negative("reach", link.reach_a);
  item.not_negative("reach", link.reach_b);
}

void check_limits(const Item& item, const Bolt& bolt) {
  item.not_negative("pretension", bolt.pretension);
  for (const auto& [name, limit] :
       {std::pair("yield force", bolt.yield_force), std::pair("shear yield force", bolt.shear_yield_force),
        std::pair("rupture elongation", bolt.rupture_elongation)})
    if (limit != infinite) item.positive(name, limit);
  if (bolt.pretension > bolt.yield_force)
    item.fail("pretension", fmt::format("{} N", bolt.pretension),
              fmt::format("at most the yield force of {} N", bolt.yield_force));
  item.positive("spacing", bolt.spacing);
}

void check_bolt(const Model& model, const Item& item, const Bolt& bolt) {
  item.finite("direction", bolt.direction);
  item.within("direction length", bolt.direction.norm(), 1 - 1e-9, 1 + 1e-9);
  check_limits(item, bolt);
  if (bolt.first_stage != 0) item.index("first stage", bolt.first_stage, model.stages.size());
  check_withdrawal(item, bolt.withdrawal, bolt.first_stage, model);
  if (bolt.links.empty()) item.fail("links", "none", "two blocks that it joins");
  if (!bolt.grouted && bolt.links.size() > 1) item.fail("links", "several", "one, as it is anchored at its ends");
  for (const BoltLink& link : bolt.links) {
    check_link(model, item, link);
    if (bolt.grouted) continue;
    item.positive("length", (link.point_b - link.point_a).norm());
    if (link.shear_stiffness > 0)
      item.fail("shear stiffness", fmt::format("{} N/m", link.shear_stiffness), "0 where it is anchored at its ends");
  }
}

}  // namespace

void check_withdrawal(const Item& item, const Withdrawal& withdrawal, int first_stage, const Model& model) {
  if (withdrawal.last_stage < 0) return;
  item.index("last stage", withdrawal.last_stage, model.stages.size());
  if (withdrawal.last_stage < first_stage)
    item.fail("last stage", fmt::format("{}", withdrawal.last_stage), fmt::format("{} or later", first_stage));
  if (withdrawal.relaxation) check_history(item, *withdrawal.relaxation);
}

void check_bolts(const Model& model) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < model.bolts.size(); ++i) {
    const Bolt& bolt = model.bolts[i];
    const Item item("bolts", i, bolt.name);
    check_bolt(model, item, bolt);
    if (!bolt.name.empty() && !names.insert(bolt.name).second)
      item.fail("name", fmt::format("\"{}\"", bolt.name), "a name that no other bolt has");
  }
}

}  // namespace dda::model_checks
