#include "engine/scene/read_fills.h"

#include <utility>

#include "engine/core/error.h"
#include "engine/cutting/opening_rings.h"
#include "engine/scene/block_group.h"
#include "engine/scene/places.h"

namespace dda {
namespace {

constexpr double default_growth = 0.2;      // of the size of cells, per length
constexpr int default_relax = 10;           // times
constexpr double default_short_edge = 0.1;  // of the size of cells
constexpr int most_relax = 1000;
constexpr double longest_short_edge = 0.4;  // beyond it cells would vanish, not edges
constexpr int most_rings = 1000;

const std::string& joint_at(const Field& field, const Model& model) {
  return model.joints[static_cast<std::size_t>(read_joint_reference(field.at("joint"), model))].name;
}

double positive_number(const Field& field) { return field.positive(Dimension::dimensionless); }

int whole_number_up_to(const Field& field, int most) {
  const int number = field.whole_number();
  if (number > most) field.fail("at most " + std::to_string(most));
  return number;
}

// The openings that `graded` means: one by its name, or all.
std::vector<Ring> fine_at(const Field& graded, const RockPlan& plan) {
  const auto name = graded.find("opening");
  std::vector<Ring> outlines;
  for (const PlanOpening& opening : plan.openings) {
    if (!name || opening.name == name->text()) outlines.push_back(opening.outline);
  }
  if (outlines.empty() && name) name->fail("the name of an opening of this rock");
  if (outlines.empty()) throw InputError("", graded.path(), "given for rock without openings", "it left out");
  return outlines;
}

void read_grading(const Field& graded, const RockPlan& plan, PlanFill& fill) {
  fill.fine_at = fine_at(graded, plan);
  fill.finest = graded.at("size").positive(Dimension::length);
  if (fill.finest > fill.size) graded.at("size").fail("at most the size of cells elsewhere");
  fill.growth = value_or(graded, "growth", default_growth, positive_number);
  if (fill.growth > 1) graded.at("growth").fail("at most 1");
}

PlanFill read_fill(const Field& field, int seed, const Model& model, const RockPlan& plan) {
  PlanFill fill;
  fill.origin = field.path();
  fill.joint = joint_at(field, model);
  const Field voronoi = field.at("voronoi");
  fill.size = voronoi.at("size").positive(Dimension::length);
  if (const auto graded = voronoi.find("graded")) read_grading(*graded, plan, fill);
  fill.relax =
      value_or(voronoi, "relax", default_relax, [](const Field& f) { return whole_number_up_to(f, most_relax); });
  fill.short_edge = value_or(voronoi, "short_edge", default_short_edge,
                             [](const Field& f) { return f.within(0, longest_short_edge); });
  fill.seed =
      static_cast<std::uint64_t>(value_or(voronoi, "seed", seed, [](const Field& f) { return f.whole_number(); }));
  if (const auto region = field.find("region")) {
    fill.region = read_ring(*region);
    if (const auto why = defect({fill.region, {}})) region->fail(*why, "a closed line that does not meet itself");
  }
  return fill;
}

}  // namespace

void read_fills(const Field& rock, int seed, const Model& model, RockPlan& plan) {
  const auto fills = rock.find("fill");
  if (!fills) return;
  for (const Field& fill : fills->items()) plan.fills.push_back(read_fill(fill, seed, model, plan));
}

std::vector<PlanLine> read_rings(const Field& opening, const Ring& outline, const Model& model) {
  const auto field = opening.find("rings");
  if (!field) return {};
  if (const auto why = defect({outline, {}}))
    throw InputError("", opening.path(), *why, "a closed line that does not meet itself");
  OpeningRings rings;
  rings.origin = field->path();
  rings.joint = joint_at(*field, model);
  rings.count = whole_number_up_to(field->at("count"), most_rings);
  rings.thickness = field->at("thickness").positive(Dimension::length);
  rings.growth = value_or(*field, "growth", 1.0, positive_number);
  rings.cuts = value_or(*field, "cuts", 0, [](const Field& f) { return f.whole_number(); });
  return rings_around(outline, rings);
}

}  // namespace dda
