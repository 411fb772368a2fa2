#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>
#include <vector>

#include "engine/drawing/line_drawing.h"
#include "engine/scene/json_path.h"
#include "engine/scene/places.h"
#include "engine/scene/read_drawn_plan.h"
#include "engine/scene/rock_values.h"
#include "engine/scene/sections.h"

namespace dda {
namespace {

PlaneState read_plane(const Field& owner, PlaneState otherwise) {
  return value_or(owner, "plane", otherwise, [](const Field& field) {
    return field.choice({"stress", "strain"}) == 0 ? PlaneState::stress : PlaneState::strain;
  });
}

Material read_material(const std::string& name, const Field& field, PlaneState plane) {
  Material material;
  material.name = name;
  material.density = field.at("density").positive(Dimension::mass_density);
  material.young = field.at("young").positive(Dimension::stress);
  material.plane = read_plane(field, plane);
  material.poisson = read_poisson(field.at("poisson"), material.plane);
  return material;
}

// Joints of these laws alone give way by a given stiffness while they are closed.
void take_springs_for(const Field& stiffness, const Field& owner, JointMaterial& joint) {
  if (!owner.has("law")) joint.law = InterfaceLaw::classical;
  if (joint.law != InterfaceLaw::classical && joint.law != InterfaceLaw::projected)
    stiffness.fail("\"auto\", or to be left out unless law is \"classical\" or \"projected\"");
}

void read_stiffness(const Field& field, JointMaterial& joint) {
  const auto shear = field.find("shear_stiffness");
  const auto normal = field.find("normal_stiffness");
  const bool automatic = normal && normal->is_text() && normal->text() == "auto";
  if (shear && (!normal || automatic)) shear->fail("to be left out unless normal_stiffness is given in Pa/m");
  if (!normal) return;
  refuse(field, {"normal_spring", "spring_over_young"}, "beside normal_stiffness");
  joint.automatic_stiffness = automatic;
  if (automatic) return;
  joint.normal_stiffness = normal->positive(Dimension::stiffness_per_area);
  take_springs_for(*normal, field, joint);
  if (!shear) return;
  refuse(field, {"shear_to_normal"}, "beside shear_stiffness");
  joint.shear_stiffness = shear->positive(Dimension::stiffness_per_area);
}

void read_springs(const Field& field, JointMaterial& joint) {
  if (const auto spring = field.find("normal_spring")) {
    refuse(field, {"spring_over_young"}, "beside normal_spring");
    joint.normal_spring = spring->positive(Dimension::force_per_length);
  }
  joint.spring_over_young = value_or(field, "spring_over_young", joint.spring_over_young,
                                     [](const Field& f) { return f.positive(Dimension::dimensionless); });
  joint.shear_to_normal = value_or(field, "shear_to_normal", joint.shear_to_normal,
                                   [](const Field& f) { return f.not_negative(Dimension::dimensionless); });
  joint.contact_damping = value_or(field, "contact_damping", joint.contact_damping,
                                   [](const Field& f) { return f.not_negative(Dimension::dimensionless); });
}

void read_consistent_law(const Field& field, JointMaterial& joint) {
  if (joint.law == InterfaceLaw::classical) refuse(field, {"penalty", "stabilisation"}, "with the classical law");
  if (const auto penalty = field.find("penalty")) {
    joint.penalty = penalty->quantity(Dimension::dimensionless);
    if (joint.penalty <= 1) penalty->fail("a number above 1, below which the law is unstable");
  }
  if (const auto stabilisation = field.find("stabilisation"))
    joint.stabilisation = stabilisation->not_negative(Dimension::dimensionless);
}

void read_strength(const Field& field, JointMaterial& joint) {
  const auto strength = [](const Field& f) { return f.not_negative(Dimension::stress); };
  joint.bonded = value_or(field, "bonded", false, [](const Field& f) { return f.truth(); });
  joint.friction_angle = value_or(field, "friction_angle", 0.0, read_friction_angle);
  joint.cohesion = value_or(field, "cohesion", 0.0, strength);
  joint.tensile_strength = value_or(field, "tensile_strength", 0.0, strength);
}

// Reads what is left of a strength after failure: not more than before.
void read_residual_strength(const Field& field, JointMaterial& joint) {
  if (const auto angle = field.find("residual_friction_angle")) {
    joint.residual_friction_angle = read_friction_angle(*angle);
    if (*joint.residual_friction_angle > joint.friction_angle) angle->fail("at most friction_angle");
  }
  if (const auto cohesion = field.find("residual_cohesion")) {
    joint.residual_cohesion = cohesion->not_negative(Dimension::stress);
    if (joint.residual_cohesion > joint.cohesion) cohesion->fail("at most cohesion");
  }
}

void read_dilation(const Field& field, JointMaterial& joint) {
  if (const auto angle = field.find("dilation_angle")) {
    joint.dilation_angle = read_friction_angle(*angle);
    if (joint.dilation_angle > joint.residual_friction_angle.value_or(joint.friction_angle))
      angle->fail("at most the residual friction angle, beyond which sliding would create energy");
  }
  joint.zero_dilation_slip = value_or(field, "zero_dilation_slip", joint.zero_dilation_slip,
                                      [](const Field& f) { return f.positive(Dimension::length); });
  if (joint.dilation_angle == 0) refuse(field, {"zero_dilation_slip"}, "without a dilation_angle above 0");
}

// Refuses a penalty beside the projected law, which chooses its own, and all else that it has no use for.
void check_projected_law(const Field& field, const JointMaterial& joint) {
  if (joint.law != InterfaceLaw::projected) return;
  refuse(field, {"penalty", "stabilisation", "normal_spring", "spring_over_young"}, "with the projected law");
  if (!field.has("normal_stiffness")) refuse(field, {"shear_to_normal"}, "with the projected law");
  if (joint.bonded) field.at("bonded").fail("false, or to be left out: bonded joints have the consistent law");
  if (joint.automatic_stiffness) field.at("normal_stiffness").fail("in Pa/m, or to be left out with the projected law");
  if (joint.dilation_angle > 0) field.at("dilation_angle").fail("0, or to be left out: the projected law has none yet");
}

// A joint that carried its load by the stress of the blocks has springs from when it breaks, and they begin with the
// whole of that load: what they store of it, force squared over twice the stiffness, was brought by nothing. So they
// are chosen stiff, as for "auto", unless the scene has springs of its own.
void choose_springs_of_broken_ends(const Field& field, JointMaterial& joint) {
  const bool has_own = field.has("normal_spring") || field.has("spring_over_young");
  if (passes_stress(joint.law) && can_break(joint) && !has_own) joint.automatic_stiffness = true;
}

InterfaceLaw read_law(const Field& field) {
  using enum InterfaceLaw;
  const std::vector laws = {consistent, cubic, classical, projected};
  return laws.at(field.choice({"consistent", "cubic", "classical", "projected"}));
}

JointMaterial read_joint(const std::string& name, const Field& field, const Scheme& scheme) {
  JointMaterial joint = preset_joint(scheme);
  joint.name = name;
  joint.law = value_or(field, "law", joint.law, read_law);
  read_strength(field, joint);
  read_residual_strength(field, joint);
  read_dilation(field, joint);
  read_stiffness(field, joint);
  read_springs(field, joint);
  read_consistent_law(field, joint);
  check_projected_law(field, joint);
  choose_springs_of_broken_ends(field, joint);
  return joint;
}

void add_rings(const Field& rock, std::vector<Field>& users) {
  const auto openings = rock.find("openings");
  if (!openings) return;
  for (const Field& opening : openings->items()) {
    if (const auto rings = opening.find("rings")) users.push_back(*rings);
  }
}

// Lists everything in a scene that names a joint in a key "joint".
std::vector<Field> joint_users(const Field& scene, const std::vector<PlainLines>& lines) {
  std::vector<Field> users;
  const auto add_entries = [&](const Field& owner, const char* key) {
    const auto entries = owner.find(key);
    if (!entries) return;
    for (const Field& entry : entries->items()) users.push_back(entry);
  };
  for (const char* key : {"joint_pairs", "joint_lines"}) add_entries(scene, key);
  const Field blocks = scene.at("blocks");
  for (const Field& entry : blocks.is_array() ? blocks.items() : std::vector<Field>{blocks}) {
    const auto rock = entry.find("rock");
    if (!rock) continue;
    const PlainLines* const plain = lines_at(member_path(rock->path(), "lines"), lines);
    if (plain == nullptr)
      add_entries(*rock, "lines");
    else
      std::ranges::copy(plain->joints(), std::back_inserter(users));
    for (const char* key : {"joint_sets", "openings", "fill"}) add_entries(*rock, key);
    add_rings(*rock, users);
    if (const auto drawing = rock->find("drawing"))
      std::ranges::copy(layer_entries(*drawing), std::back_inserter(users));
  }
  return users;
}

// Returns the names that drawings give to joints by themselves.
std::set<std::string> joints_of_drawings(const Field& scene, const std::filesystem::path& folder) {
  std::set<std::string> names;
  const Field blocks = scene.at("blocks");
  for (const Field& entry : blocks.is_array() ? blocks.items() : std::vector<Field>{blocks}) {
    const auto rock = entry.find("rock");
    const auto drawing = rock ? rock->find("drawing") : std::nullopt;
    if (drawing) names.merge(drawn_names(*drawing, folder).joints);
  }
  return names;
}

// Adds to `used` those of `names` that drawings have, whatever their capitals.
void use_joints_of_drawings(const Field& scene, const std::filesystem::path& folder,
                            const std::vector<std::string>& names, std::set<std::string>& used) {
  std::set<std::string> drawn;
  for (const std::string& name : joints_of_drawings(scene, folder)) drawn.insert(in_lower_case(name));
  for (const std::string& name : names)
    if (drawn.contains(in_lower_case(name))) used.insert(name);
}

bool has_drawing(const Field& scene) {
  const Field blocks = scene.at("blocks");
  const std::vector<Field> entries = blocks.is_array() ? blocks.items() : std::vector<Field>{blocks};
  return std::ranges::any_of(entries, [](const Field& entry) {
    const auto rock = entry.find("rock");
    return rock && rock->has("drawing");
  });
}

// Names of joints in entries of the scene. Misspelt ones are refused.
std::set<std::string> names_in_use(const Field& scene, const std::vector<PlainLines>& lines,
                                   const std::vector<std::string>& names) {
  std::set<std::string> used = {"default"};
  for (const Field& user : joint_users(scene, lines)) {
    if (const auto joint = user.find("joint")) used.insert(names[joint->choice(names)]);
  }
  return used;
}

// A joint under another name than "default" that nothing uses would silently do nothing. In a drawing it may have no
// line this time, which is worth a remark; without one it is misspelt, and refused. Misspelt references come first:
// they are why joints seem to be without use. Drawings are read only where it is of use.
std::vector<std::string> look_at_unused_joints(const Field& scene, const Field& joints,
                                               const std::filesystem::path& folder,
                                               const std::vector<PlainLines>& lines) {
  std::vector<std::string> names = {"default"};
  for (const auto& [name, field] : joints.members())
    if (name != "default") names.push_back(name);
  std::set<std::string> used = names_in_use(scene, lines, names);
  const auto is_used = [&](const auto& member) { return used.contains(member.first); };
  if (!std::ranges::all_of(joints.members(), is_used)) use_joints_of_drawings(scene, folder, names, used);
  std::vector<std::string> remarks;
  for (const auto& [name, field] : joints.members()) {
    if (used.contains(name)) continue;
    if (!has_drawing(scene))
      field.fail("in no entry of joint_pairs, joint_lines or rock", "\"default\" or a name that they use");
    remarks.push_back(
        fmt::format("{} is in no entry of joint_pairs, joint_lines or rock, and no line of the drawing "
                    "is on a layer \"joint {}\"",
                    field.path(), name));
  }
  return remarks;
}

}  // namespace

void read_materials(const Field& scene, Model& model) {
  const PlaneState plane = read_plane(scene, PlaneState::stress);
  for (const auto& [name, field] : scene.at("materials").members()) {
    model.materials.push_back(read_material(name, field, plane));
  }
}

std::vector<std::string> read_joints(const Field& scene, const Scheme& scheme, const std::filesystem::path& folder,
                                     const std::vector<PlainLines>& lines, Model& model) {
  model.joints = {preset_joint(scheme)};
  model.joints[0].name = "default";
  const auto joints = scene.find("joints");
  if (!joints) return {};
  std::vector<std::string> remarks = look_at_unused_joints(scene, *joints, folder, lines);
  for (const auto& [name, field] : joints->members()) {
    const JointMaterial joint = read_joint(name, field, scheme);
    if (name == "default") {
      model.joints[0] = joint;
    } else {
      model.joints.push_back(joint);
    }
  }
  return remarks;
}

}  // namespace dda
