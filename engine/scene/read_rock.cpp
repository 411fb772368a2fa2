#include "engine/scene/read_rock.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "engine/core/error.h"
#include "engine/core/parallel.h"
#include "engine/cutting/cut_rock.h"
#include "engine/geometry/diameter.h"
#include "engine/scene/block_group.h"
#include "engine/scene/json_path.h"
#include "engine/scene/places.h"
#include "engine/scene/read_drawn_plan.h"
#include "engine/scene/read_fills.h"
#include "engine/scene/read_joint_sets.h"
#include "engine/scene/read_openings.h"
#include "engine/scene/rock_values.h"

namespace dda {
namespace {

PlanLine read_line(const Field& field, const Model& model) {
  PlanLine line;
  for (const Field& point : field.at("points").items()) line.points.push_back(point.vector(Dimension::length));
  const JointMaterial& joint = model.joints[static_cast<std::size_t>(read_joint_reference(field.at("joint"), model))];
  line.joint = joint.name;
  line.construction = joint.bonded;
  line.origin = field.path();
  return line;
}

void append_lines(const PlainLines& lines, const Model& model, std::vector<PlanLine>& all) {
  std::vector<const JointMaterial*> joints;
  for (const Field& user : lines.joints())
    joints.push_back(&model.joints[static_cast<std::size_t>(read_joint_reference(user.at("joint"), model))]);
  const std::size_t first = all.size();
  all.resize(first + lines.size());
  constexpr std::size_t worth_sharing = 10'000;
  parallel_for_each(lines.size(), worth_sharing, [&](std::size_t i) {
    const auto points = lines.points(i);
    const JointMaterial& joint = *joints[lines.joint(i)];
    all[first + i] = {{points.begin(), points.end()}, joint.name, item_path(lines.path(), i), joint.bonded};
  });
}

void read_lines(const Field& field, const std::vector<PlainLines>& plain, const Model& model,
                std::vector<PlanLine>& all) {
  if (const PlainLines* const lines = lines_at(field.path(), plain))
    append_lines(*lines, model, all);
  else
    for (const Field& line : field.items()) all.push_back(read_line(line, model));
}

PlanRegion read_region(const Field& field, const Model& model) {
  const int material = material_named(field.at("material"), model);
  const Field outline = field.at("outline");
  return {read_ring(outline), model.materials[static_cast<std::size_t>(material)].name, outline.path()};
}

int seed_of(const Field& rock) {
  return value_or(rock, "seed", 1, [](const Field& f) { return f.whole_number(); });
}

void read_sets(const Field& field, const Model& model, Rock& rock) {
  const auto sets = field.find("joint_sets");
  if (!sets) return;
  const std::vector<JointSet> read = read_joint_sets(*sets, model);
  for (const JointSet& set : read) rock.joint_sets.push_back({set.name, set.origin});
  for (PlanLine& trace : traces_of(read, rock.plan.boundary, static_cast<std::uint64_t>(seed_of(field))))
    rock.plan.lines.push_back(std::move(trace));
}

void read_boundary(const Field& field, RockPlan& plan) {
  const auto boundary = field.find("boundary");
  if (boundary && !plan.boundary.empty())
    boundary->fail("given beside that of the drawing, of " + plan.boundary_origin, "one of the two");
  if (!boundary && plan.boundary.empty())
    throw InputError("", field.path() + ".boundary", "missing", "it, or a drawing with a layer boundary");
  if (!boundary) return;
  plan.boundary = read_ring(*boundary);
  plan.boundary_origin = boundary->path();
  if (const auto why = defect({plan.boundary, {}})) boundary->fail(*why, "a closed line that does not meet itself");
}

void refuse_what_cuts(const Field& field) {
  for (const char* key : {"boundary", "holes", "joint_sets", "lines", "openings", "fill", "merge"}) {
    if (const auto found = field.find(key))
      found->fail("given beside a drawing of blocks, which are not cut again",
                  "regions alone, or the drawing that the blocks came from");
  }
}

// Adds to what a drawing says.
void read_plan(const Field& field, const std::vector<PlainLines>& lines, const Model& model, Rock& rock) {
  RockPlan& plan = rock.plan;
  if (plan.blocks.empty())
    read_boundary(field, plan);
  else
    refuse_what_cuts(field);
  if (const auto holes = field.find("holes")) {
    for (const Field& hole : holes->items()) plan.holes.push_back(read_ring(hole));
  }
  read_sets(field, model, rock);
  if (const auto list = field.find("lines")) read_lines(*list, lines, model, plan.lines);
  if (const auto openings = field.find("openings")) {
    for (const Field& opening : openings->items()) {
      plan.openings.push_back(read_opening(opening, model));
      if (plan.openings.back().name == rock.group.name)
        opening.at("name").fail("another name than that of the rock's own group");
      for (PlanLine& line : read_rings(opening, plan.openings.back().outline, model))
        plan.lines.push_back(std::move(line));
    }
  }
  if (const auto regions = field.find("regions")) {
    for (const Field& region : regions->items()) plan.regions.push_back(read_region(region, model));
  }
  read_fills(field, seed_of(field), model, plan);
}

CutOptions read_options(const Field& field) {
  CutOptions options;
  options.tolerance = value_or(field, "tolerance", 0.0, [](const Field& f) { return f.positive(Dimension::length); });
  if (const auto merge = field.find("merge")) {
    options.least_area =
        value_or(*merge, "area", 0.0, [](const Field& f) { return f.positive(Dimension::dimensionless); });
    options.least_angle = value_or(*merge, "angle", 0.0, read_corner);
  }
  return options;
}

int joint_named(const std::string& name, const Model& model) {
  const auto found = std::find_if(model.joints.begin(), model.joints.end(),
                                  [&](const JointMaterial& joint) { return joint.name == name; });
  return found == model.joints.end() ? 0 : static_cast<int>(found - model.joints.begin());
}

int material_of(const CutBlock& block, const BlockGroup& group, const Model& model) {
  const auto found = std::find_if(model.materials.begin(), model.materials.end(),
                                  [&](const Material& material) { return material.name == block.material; });
  return found == model.materials.end() ? group.material : static_cast<int>(found - model.materials.begin());
}

// What a set has in the rock cuts it, runs along something else, or was trimmed as it ends there.
bool has_joint_in_rock(const NamedSet& set, const RockPlan& plan, const CutRock& cut) {
  const auto is_of_set = [&](const auto& part) { return part.origin == set.origin; };
  const auto drawn = std::ranges::count_if(plan.lines, is_of_set);
  std::ptrdiff_t unused = 0;
  for (const Cleaned& cleaned : cut.cleaned) {
    if (!is_of_set(cleaned)) continue;
    if (cleaned.what != Cleaning::line_not_used) return true;
    ++unused;
  }
  return unused < drawn;
}

void remark_on_empty_sets(const Rock& rock, CutRock& cut) {
  for (const NamedSet& set : rock.joint_sets) {
    if (has_joint_in_rock(set, rock.plan, cut)) continue;
    cut.remarks.push_back(fmt::format(
        "{} (\"{}\") has no joint in the rock: its spacing, start, trace length or region leaves none there",
        set.origin, set.name));
  }
}

[[noreturn]] void refuse_tolerance(const Rock& rock, double tolerance) {
  throw InputError("", rock.path + ".tolerance", fmt::format("{:.4g} m", tolerance),
                   "a smaller length: all rock is narrower (width 2 area/perimeter)");
}

// Openings took all of it, or what is narrower than the tolerance was dropped.
[[noreturn]] void refuse_without_blocks(const Rock& rock, const CutRock& cut) {
  constexpr double all = 1 - 1e-9;  // but for round-off
  if (!rock.plan.openings.empty() && cut.left_out_area >= all * cut.boundary_area)
    throw InputError("", rock.path + ".openings", "around all of the rock", "openings that leave some of it");
  if (cut.dropped_area > 0) refuse_tolerance(rock, cut.tolerance);
  throw InputError("", rock.plan.boundary_origin, "around rock without any block", "rock to cut");
}

}  // namespace

Rock read_rock(const Field& field, const std::filesystem::path& folder, const std::vector<PlainLines>& lines,
               const Model& model) {
  Rock rock;
  rock.path = field.path();
  rock.group = read_group(field, "rock", model);
  rock.options = read_options(field);
  if (const auto drawing = field.find("drawing")) {
    DrawnPlan drawn = read_drawn_plan(*drawing, folder, model, rock.options.tolerance);
    if (drawn.plan.boundary.empty() && drawn.plan.blocks.empty() && !field.has("boundary"))
      refuse_without_boundary(drawn);
    rock.plan = std::move(drawn.plan);
    rock.remarks = std::move(drawn.remarks);
  }
  read_plan(field, lines, model, rock);
  return rock;
}

const std::string& group_name(const Rock& rock, const CutBlock& block) {
  if (!block.group.empty()) return block.group;
  return block.opening < 0 ? rock.group.name : rock.plan.openings[static_cast<std::size_t>(block.opening)].name;
}

CutRock cut(const Rock& rock) {
  // Cutting computes with lengths of the size of the tolerance: one beyond all rock is not for it to find out about.
  const std::vector<Vec2>& boundary = rock.plan.boundary;
  if (!boundary.empty() && rock.options.tolerance > diameter(boundary)) refuse_tolerance(rock, rock.options.tolerance);
  CutRock result = cut_rock(rock.plan, rock.options);
  if (result.blocks.empty()) refuse_without_blocks(rock, result);
  remark_on_empty_sets(rock, result);
  return result;
}

void append_rock(const Rock& rock, const CutRock& cut, Model& model, std::vector<std::string>& groups) {
  std::map<std::string, int> counts;
  for (const CutBlock& piece : cut.blocks) {
    const std::string& group = group_name(rock, piece);
    Block block = block_of(rock.group, fmt::format("{} {}", group, ++counts[group]));
    block.shape = piece.shape;
    block.material = material_of(piece, rock.group, model);
    model.blocks.push_back(std::move(block));
    groups.push_back(group);
  }
  for (const CutJoint& run : cut.joints) {
    const int joint = joint_named(run.joint, model);
    if (joint != 0) model.joint_lines.push_back({run.from, run.to, joint});
  }
}

}  // namespace dda
