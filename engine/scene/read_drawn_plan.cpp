#include "engine/scene/read_drawn_plan.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "engine/core/error.h"
#include "engine/drawing/drawn_units.h"
#include "engine/drawing/plan_of_drawing.h"
#include "engine/drawing/read_drawing.h"
#include "engine/scene/places.h"

namespace dda {
namespace {

// m; those in which drawings are made, and those of a scene's lengths besides.
double read_unit(const Field& field) {
  std::vector<std::string> symbols;
  std::vector<double> metres;
  for (const DrawnUnit& unit : drawn_units) {
    symbols.emplace_back(unit.symbol);
    metres.push_back(unit.metres);
  }
  for (const Unit& unit : units(Dimension::length)) {
    if (std::ranges::find(symbols, unit.symbol) != symbols.end()) continue;
    symbols.emplace_back(unit.symbol);
    metres.push_back(unit.numerator / unit.denominator);
  }
  return metres[field.choice(symbols)];
}

LayerUse read_layer_use(const Field& field, const Model& model) {
  LayerUse use;
  const Field role = field.is_object() ? field.at("as") : field;
  use.role = static_cast<LayerRole>(role.choice(role_names()));
  const auto name = field.is_object() ? field.find("joint") : std::nullopt;
  if (!name) return use;
  const JointMaterial& joint = model.joints[static_cast<std::size_t>(read_joint_reference(*name, model))];
  use.joint = joint.name;
  use.construction = joint.bonded;
  return use;
}

std::set<std::string> bare_layers_of(const LineDrawing& drawing) {
  std::set<std::string> drawn;
  for (const DrawnLine& line : drawing.lines) drawn.insert(bare_layer(line.layer));
  for (const DrawnPoint& point : drawing.points) drawn.insert(bare_layer(point.layer));
  return drawn;
}

// A misspelt layer would leave the drawing's own without a meaning, or with another. One of joints may just have none
// this time; the lines of a misspelt one are refused.
std::map<std::string, LayerUse> read_layers(const Field& layers, const LineDrawing& drawing, const Model& model,
                                            std::vector<std::string>& remarks) {
  const std::set<std::string> drawn = bare_layers_of(drawing);
  std::map<std::string, LayerUse> uses;
  for (const auto& [name, field] : layers.members()) {
    const LayerUse& use = uses[name] = read_layer_use(field, model);
    if (drawn.contains(bare_layer(name))) continue;
    if (use.role != LayerRole::rock) field.fail("for a layer on which nothing is drawn", "a layer of " + drawing.name);
    remarks.push_back(
        fmt::format("{}: no line is on the layer \"{}\", which is said to have joints", drawing.name, name));
  }
  return uses;
}

DrawingOptions read_options(const Field& field, const LineDrawing& drawing, const Model& model,
                            std::vector<std::string>& remarks) {
  DrawingOptions options;
  options.chords.length =
      value_or(field, "chord_tolerance", 0.0, [](const Field& f) { return f.positive(Dimension::length); });
  if (const auto layers = field.find("layers")) options.layers = read_layers(*layers, drawing, model, remarks);
  return options;
}

// Names of groups come from layers.
void check_name(const std::string& group, const std::string& origin) {
  const nlohmann::json name = group;
  static_cast<void>(Field(name, origin).name());
}

// Finds the joint that the line names, or else the only one whose name differs in capitals alone; refuses all others.
const JointMaterial& joint_of(const PlanLine& line, const Model& model) {
  const auto same = std::ranges::find(model.joints, line.joint, &JointMaterial::name);
  if (same != model.joints.end()) return *same;
  const auto lower = [](const JointMaterial& joint) { return in_lower_case(joint.name); };
  const std::string wanted = in_lower_case(line.joint);
  if (std::ranges::count(model.joints, wanted, lower) == 1) return *std::ranges::find(model.joints, wanted, lower);
  std::vector<std::string> names;
  for (const JointMaterial& joint : model.joints) names.push_back(joint.name);
  throw InputError("", line.origin, "of the joint \"" + line.joint + "\"",
                   fmt::format("one of the scene's joints: {}", fmt::join(names, ", ")));
}

// Names of joints that come from layers are those of the scene.
void take_joints(const Model& model, std::vector<PlanLine>& lines) {
  std::map<std::string, const JointMaterial*> known;
  for (PlanLine& line : lines) {
    if (line.joint.empty()) continue;
    const JointMaterial*& joint = known[line.joint];
    if (joint == nullptr) joint = &joint_of(line, model);
    line.joint = joint->name;
    line.construction = joint->bonded;
  }
}

void check_blocks(const Model& model, const std::vector<PlanBlock>& blocks) {
  std::set<std::string> names;
  for (const Material& material : model.materials) names.insert(material.name);
  for (const PlanBlock& block : blocks) {
    check_name(block.group, block.origin);
    if (!block.material.empty() && !names.contains(block.material))
      throw InputError("", block.origin, "of the material \"" + block.material + "\"",
                       fmt::format("one of the scene's materials: {}", fmt::join(names, ", ")));
  }
}

// Entities of DXF that cut rock if they were drawn as others.
const std::set<std::string> unread_lines{"3DFACE", "HELIX", "MLINE", "RAY", "XLINE"};

// Lines that are ignored without anybody having said so.
std::string remark_on_points_of_dimensions(const LineDrawing& drawing, const DrawingOptions& options) {
  const auto is_there = [](const std::string& layer) { return bare_layer(layer) == "defpoints"; };
  const auto count = std::ranges::count_if(drawing.lines, is_there, &DrawnLine::layer);
  const bool is_said = std::ranges::any_of(options.layers, is_there, [](const auto& entry) { return entry.first; });
  if (count == 0 || is_said) return "";
  return fmt::format(
      "{}: {} lines on Defpoints, the layer of dimensions, are left out; an entry of \"layers\" "
      "(--layer) reads them",
      drawing.name, count);
}

// Two units differ by more than this share: a foot and that of US surveys by twice as much.
constexpr double same_unit = 1e-6;

std::vector<std::string> remarks_on(const LineDrawing& drawing, double metres) {
  std::vector<std::string> remarks;
  if (metres == 0 && drawing.unit.empty())
    remarks.push_back(drawing.name + " does not say its unit: coordinates are taken in m");
  if (metres == 0 && !drawing.unit.empty())
    remarks.push_back(fmt::format("{}: coordinates in {}, as it says", drawing.name, drawing.unit));
  if (metres > 0 && !drawing.unit.empty() && std::abs(metres / drawing.metres_of_unit - 1) > same_unit)
    remarks.push_back(
        fmt::format("{} says that its coordinates are in {}; they are taken in units of {:.6g} m, as is "
                    "asked for",
                    drawing.name, drawing.unit, metres));
  for (const auto& [other, name] : drawing.other_spellings)
    if (named_layer(name))
      remarks.push_back(fmt::format("{}: the layers \"{}\" and \"{}\" are one", drawing.name, name, other));
  std::vector<std::string> kinds, lines;
  for (const auto& [kind, count] : drawing.passed_over)
    (unread_lines.contains(kind) ? lines : kinds).push_back(fmt::format("{} x {}", count, kind));
  if (!kinds.empty())
    remarks.push_back(
        fmt::format("{}: passed over, being no lines or points: {}", drawing.name, fmt::join(kinds, ", ")));
  if (!lines.empty())
    remarks.push_back(fmt::format("{}: left out, lines of kinds that are not read: {}; draw them as lines or polylines",
                                  drawing.name, fmt::join(lines, ", ")));
  return remarks;
}

}  // namespace

DrawnPlan read_drawn_plan(const Field& field, const std::filesystem::path& folder, const Model& model, double reach) {
  const std::string file = (field.is_object() ? field.at("file") : field).text();
  const double metres = field.is_object() ? value_or(field, "unit", 0.0, read_unit) : 0;
  const LineDrawing drawing = read_drawing(folder / file, file, metres);
  DrawnPlan drawn;
  drawn.name = drawing.name;
  drawn.has_hatches = drawing.passed_over.contains("HATCH");
  for (const DrawnLine& line : drawing.lines) drawn.layers.insert(line.layer);
  for (const DrawnPoint& point : drawing.points) drawn.layers.insert(point.layer);
  drawn.remarks = remarks_on(drawing, metres);
  DrawingOptions options = field.is_object() ? read_options(field, drawing, model, drawn.remarks) : DrawingOptions{};
  options.reach = reach;
  drawn.plan = plan_of(drawing, options);
  if (std::string remark = remark_on_points_of_dimensions(drawing, options); !remark.empty())
    drawn.remarks.push_back(std::move(remark));
  for (const PlanOpening& opening : drawn.plan.openings) check_name(opening.name, opening.origin);
  take_joints(model, drawn.plan.lines);
  check_blocks(model, drawn.plan.blocks);
  if (!drawn.plan.blocks.empty())
    drawn.remarks.push_back(
        fmt::format("{}: {} blocks, taken as they are drawn", drawing.name, drawn.plan.blocks.size()));
  return drawn;
}

void refuse_without_boundary(const DrawnPlan& drawn) {
  constexpr std::size_t most = 12;  // names that a sentence may have
  std::vector<std::string> layers;
  for (const std::string& layer : drawn.layers) layers.push_back("\"" + layer + "\"");
  if (layers.size() > most) {
    layers.resize(most);
    layers.emplace_back("...");
  }
  const char* hatches = drawn.has_hatches ? ", and it has hatches, whose outlines are to be drawn as lines" : "";
  throw InputError(
      "", drawn.name,
      fmt::format("without a line on a layer boundary; its layers are {}{}", fmt::join(layers, ", "), hatches),
      "lines around the rock that close, on a layer boundary or on one that is said to be it: --layer "
      "\"NAME=boundary\", in a scene \"layers\": {\"NAME\": \"boundary\"}");
}

DrawnNames drawn_names(const std::filesystem::path& file, const std::string& name) {
  DrawnNames names;
  const LineDrawing drawing = read_drawing(file, name);
  if (drawing.encloses) return names;  // joints have numbers there, which a scene's table may give names
  for (const DrawnLine& line : drawing.lines) {
    if (!line.material.empty()) names.materials.insert(line.material);
    const auto named = named_layer(line.layer);
    if (named && named->role == LayerRole::rock && named->name != default_joint_name) names.joints.insert(named->name);
  }
  return names;
}

DrawnNames drawn_names(const Field& field, const std::filesystem::path& folder) {
  const std::string file = (field.is_object() ? field.at("file") : field).text();
  return drawn_names(folder / file, file);
}

std::vector<Field> layer_entries(const Field& drawing) {
  std::vector<Field> entries;
  const auto layers = drawing.is_object() ? drawing.find("layers") : std::nullopt;
  if (!layers) return entries;
  for (const auto& [name, use] : layers->members()) {
    if (use.is_object()) entries.push_back(use);
  }
  return entries;
}

}  // namespace dda
