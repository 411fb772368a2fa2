#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <set>
#include <string>

#include "engine/model/check_parts.h"
#include "engine/model/checks.h"
#include "engine/model/quantity_names.h"
#include "engine/model/tolerance.h"

namespace dda::model_checks {
namespace {

void check_bolt(const Model& model, const Item& item, const Measurement& measurement) {
  item.index("bolt", measurement.bolt, model.bolts.size());
  const Bolt& bolt = model.bolts[static_cast<std::size_t>(measurement.bolt)];
  if (measurement.link != -1) item.index("link", measurement.link, bolt.links.size());
}

void check_lining(const Model& model, const Item& item, const Measurement& measurement) {
  item.index("lining", measurement.lining, model.linings.size());
  const Lining& lining = model.linings[static_cast<std::size_t>(measurement.lining)];
  if (measurement.element != -1) item.index("element", measurement.element, lining.elements());
}

void check_point(const Model& model, const Item& item, const Measurement& measurement) {
  item.index("block", measurement.block, model.blocks.size());
  const Block& block = model.blocks[static_cast<std::size_t>(measurement.block)];
  const bool at_centroid = (measurement.point - block.moments.centroid).norm() <= point_tolerance(model);
  if (at_centroid) return;  // which may lie in a hole; the block's displacement is defined there all the same
  if (locate(block.shape, measurement.point, point_tolerance(model)) != Location::outside) return;
  item.fail("point", fmt::format("({}, {}) m", measurement.point.x(), measurement.point.y()), "a point of its block");
}

void check_joint(const Model& model, const Item& item, const Measurement& measurement) {
  item.index("other block", measurement.other_block, model.blocks.size());
  if (measurement.other_block == measurement.block) item.fail("other block", "the block itself", "two blocks");
  check_point(model, item, measurement);
}

// They must ascend, which is how they are looked up.
void check_list(const Item& item, const char* field, const std::vector<int>& list, std::size_t size) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    item.index(field, list[i], size);
    if (i > 0 && list[i] <= list[i - 1])
      item.fail(field, fmt::format("{} after {}", list[i], list[i - 1]), "ascending numbers");
  }
}

void check_reaction(const Model& model, const Item& item, const Measurement& measurement) {
  for (const int block : measurement.blocks)
    if (!model.is_held(block)) item.fail("blocks", fmt::format("{}", block), "blocks that are held as a whole");
  if (measurement.blocks.empty() && measurement.supports.empty())
    item.fail("supports", "none", "something that is held");
}

void check_sides(const Item& item, const Measurement& measurement) {
  if (measurement.blocks.empty() || measurement.others.empty()) item.fail("blocks", "none", "blocks on both sides");
  for (const int block : measurement.blocks)
    if (std::binary_search(measurement.others.begin(), measurement.others.end(), block))
      item.fail("blocks", fmt::format("{} on both sides", block), "two sides that have no block in common");
}

void check_line(const Item& item, const Measurement& measurement) {
  item.finite("from", measurement.from);
  item.finite("to", measurement.to);
  if (measurement.from == measurement.to) item.fail("to", "the same point as from", "two different points");
}

void check_excess_shear(const Model& model, const Item& item, const Measurement& measurement) {
  if (measurement.on_line) check_line(item, measurement);
  if (measurement.joint != -1) item.index("joint", measurement.joint, model.joints.size());
  if (!(measurement.friction_angle.value_or(0) >= 0 && measurement.friction_angle.value_or(0) < std::numbers::pi / 2))
    item.fail("friction angle", fmt::format("{} rad", *measurement.friction_angle), "an angle from 0 to below 90 deg");
  item.not_negative("cohesion", measurement.cohesion.value_or(0));
}

void check_measurement(const Model& model, const Item& item, const Measurement& measurement) {
  item.finite("point", measurement.point);
  item.finite("about", measurement.about);
  check_list(item, "blocks", measurement.blocks, model.blocks.size());
  check_list(item, "others", measurement.others, model.blocks.size());
  check_list(item, "supports", measurement.supports, model.supports.size());
  switch (subject_of(measurement.quantity)) {
    case Subject::block:
      if (measurement.blocks.empty()) check_point(model, item, measurement);
      break;
    case Subject::joint: check_joint(model, item, measurement); break;
    case Subject::bolt: check_bolt(model, item, measurement); break;
    case Subject::lining: check_lining(model, item, measurement); break;
    case Subject::reaction: check_reaction(model, item, measurement); break;
    case Subject::contact_force:
      check_sides(item, measurement);
      if (measurement.on_line) check_line(item, measurement);
      break;
    case Subject::resultant: check_line(item, measurement); break;
    case Subject::excess_shear: check_excess_shear(model, item, measurement); break;
    case Subject::contacts: break;
  }
}

}  // namespace

void check_measurements(const Model& model) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < model.measurements.size(); ++i) {
    const Measurement& measurement = model.measurements[i];
    const Item item("measurements", i, measurement.name);
    check_measurement(model, item, measurement);
    for (const HistoryFacts& history : histories_of(measurement.quantity))
      if (!names.insert(measurement.name + std::string(history.suffix)).second)
        item.fail("name", "used before", "a name of its own");
  }
}

}  // namespace dda::model_checks
