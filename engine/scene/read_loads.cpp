#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "engine/core/error.h"
#include "engine/geometry/segment.h"
#include "engine/model/check_parts.h"
#include "engine/model/tolerance.h"
#include "engine/scene/face_pressure.h"
#include "engine/scene/fading_faces.h"
#include "engine/scene/joint_faces.h"
#include "engine/scene/laid_bare.h"
#include "engine/scene/places.h"
#include "engine/scene/sections.h"

namespace dda {
namespace {

StageSpan read_stages_of(const Field& field, const Model& model) {
  const auto stage = [&](const Field& f) { return read_stage_reference(f, model); };
  StageSpan stages;
  stages.first = value_or(field, "from_stage", stages.first, stage);
  stages.last = value_or(field, "until_stage", stages.last, stage);
  if (stages.last >= 0 && stages.last < stages.first)
    field.at("until_stage").fail("the stage of from_stage or a later one");
  return stages;
}

void read_point_load(const Field& field, const GroundPlan& plan, RecordFiles& records, Model& model) {
  refuse(field, {"traction", "pressure", "follows"}, "for a point, which takes a force");
  const auto [block, point] = read_point(field, plan, model);
  model.point_loads.push_back({block, point, field.at("force").vector(Dimension::force),
                               read_history(field, Dimension::force, records), read_stages_of(field, model)});
}

double total_length(const std::vector<Stretch>& stretches) {
  double length = 0;
  for (const Stretch& stretch : stretches) length += (stretch.to - stretch.from).norm();
  return length;
}

std::string only_edge_intensity(const Field& field) {
  std::vector<std::string> given;
  for (const char* key : {"traction", "force", "pressure"}) {
    if (field.has(key)) given.emplace_back(key);
  }
  if (given.size() == 1) return given.front();
  throw InputError("", field.path(), fmt::format("given with {} of traction, force and pressure", given.size()),
                   "exactly one of them");
}

bool is_wall_laid_bare(const Field& load) {
  const Field edge = load.at("edge");
  return edge.is_object() && edge.has("opening");
}

std::vector<Stretch> read_loaded_faces(const Field& field, const GroundPlan& plan,
                                       const std::vector<std::string>& groups, const StageSpan& stages,
                                       const Model& model) {
  if (!is_wall_laid_bare(field)) return read_edge(field, plan, model);
  const Field edge = field.at("edge");
  refuse(edge, {"from", "to", "cavity"}, "beside opening");
  std::vector<Stretch> faces =
      faces_laid_bare(edge.at("opening"), groups, stages,
                      "blocks that are away from from_stage to until_stage: a load acts on what they lay bare", model);
  keep_named_block(field, plan, faces);
  return faces;
}

// Whether a pressure stays square to faces that turn, which only stages of finite kinematics see.
bool read_follows(const Field& load, const StageSpan& stages, const Model& model) {
  const auto field = load.find("follows");
  if (!field || !field->truth()) return false;
  for (std::size_t i = 0; i < model.stages.size(); ++i)
    if (stages.has(i) && model.stages[i].kinematics == Kinematics::finite) return true;
  field->fail("true in stages of small kinematics, in which faces stay as drawn", "a stage of finite kinematics");
}

void read_pressure(const Field& field, const std::vector<PressedFace>& faces, const TimeFunction& history,
                   const StageSpan& stages, Model& model) {
  const FacePressure pressure(field.at("pressure"));
  const bool follows = read_follows(field, stages, model);
  const std::size_t before = model.edge_loads.size();
  for (const PressedFace& s : faces)
    for (const PressedPart& part : pressure.on(s))
      model.edge_loads.push_back({s.block, part.from, part.to, (part.at_from + part.at_to) / 2 * s.inward, history,
                                  s.stages, (part.at_to - part.at_from) / 2 * s.inward, follows});
  if (model.edge_loads.size() == before)
    field.at("pressure").fail("nowhere on the edge above 0", "a pressure on some part of it");
}

// Water in joints pushes both of their blocks, so nothing else makes sense there.
void read_pressure_in_joints(const Field& field, const GroundPlan& plan, const StageSpan& stages, RecordFiles& records,
                             Model& model) {
  refuse(field, {"traction", "force"}, "in joints, which take a pressure");
  std::vector<PressedFace> faces = faces_of_joints(field.at("edge"), stages, model);
  keep_named_block(field, plan, faces, "a block with a face in these joints");
  read_pressure(field, faces, read_history(field, Dimension::stress, records), stages, model);
}

// Stretches of edges along which entries of the scene act. Two that do the same there would add up, in silence.
class TakenEdges {
 public:
  void take(const Stretch& stretch, const StageSpan& stages, const std::string& entry) {
    taken_.push_back({stretch, stages, entry});
  }

  // The entry that acts along a part of this stretch in some of these stages; empty: none.
  [[nodiscard]] std::string taker_of(const Stretch& stretch, const StageSpan& stages, const Model& model) const {
    for (const Taken& each : taken_)
      if (each.stretch.block == stretch.block && meet(each.stages, stages, model) &&
          run_along(each.stretch, stretch, model))
        return each.entry;
    return "";
  }

 private:
  struct Taken {
    Stretch stretch;
    StageSpan stages;
    std::string entry;
  };

  // Edges whose ends are written in few digits may overlap there by a little.
  static bool run_along(const Stretch& a, const Stretch& b, const Model& model) {
    constexpr double negligible = 1e-3;  // of the stretch
    const auto common = collinear_overlap({a.from, a.to}, {b.from, b.to}, point_tolerance(model));
    return common && (common->second - common->first).norm() > negligible * (b.to - b.from).norm();
  }

  static bool meet(const StageSpan& a, const StageSpan& b, const Model& model) {
    for (std::size_t stage = 0; stage < model.stages.size(); ++stage)
      if (a.has(stage) && b.has(stage)) return true;
    return false;
  }

  std::vector<Taken> taken_;
};

const std::string& name_of(int block, const Model& model) { return model.blocks[static_cast<std::size_t>(block)].name; }

// What acts with the traction in situ on edges: loads, and removed blocks while their force fades, by the names of the
// stages that remove them.
struct InSituEdges {
  TakenEdges loads, fades;
};

TakenEdges fading_edges(const Field& scene, const GroundPlan& plan, const Model& model) {
  TakenEdges fades;
  if (!scene.has("loads")) return fades;
  for (const FadingFace& each : fading_faces(plan, model))
    fades.take(each.face, each.stages, model.stages[each.stage].name);
  return fades;
}

// A history may take off what another load puts on.
void take_in_situ(const Field& load, const Stretch& s, const StageSpan& stages, const Model& model,
                  InSituEdges& taken) {
  if (load.has("history")) return;
  const std::string along = fmt::format("\"in-situ\" along \"{}\", on which ", name_of(s.block, model));
  if (const std::string taker = taken.loads.taker_of(s, stages, model); !taker.empty())
    load.at("traction").fail(along + taker + " puts it already", "one of the two, as both would double it");
  if (const std::string stage = taken.fades.taker_of(s, stages, model); !stage.empty())
    load.at("traction")
        .fail(fmt::format("{}what stage \"{}\" removes still acts while it fades", along, stage),
              "one of the two, as both would double it: this load, or \"over\" or \"table\" in \"remove\"");
  taken.loads.take(s, stages, load.path());
}

// A level surface bears nothing even where the rock below it does.
void require_stress(const Field& traction, const std::vector<Stretch>& edge, const StressField& stresses,
                    const Model& model) {
  const auto has_none = [](const Block& block) { return block.initial_stress.isZero(0); };
  const auto bears_none = [&](const Stretch& stretch) { return stresses.traction_on(stretch, model).isZero(0); };
  if (std::ranges::all_of(edge, bears_none) && std::ranges::all_of(model.blocks, has_none))
    traction.fail("\"in-situ\" in rock without any stress at the start, a load of nothing",
                  "a stress_field, or initial_stress of blocks, beside it");
}

void read_edge_load(const Field& field, const GroundPlan& plan, const std::vector<std::string>& groups,
                    const StressField& stresses, RecordFiles& records, InSituEdges& taken, Model& model) {
  const StageSpan stages = read_stages_of(field, model);
  if (is_of_joints(field.at("edge"))) return read_pressure_in_joints(field, plan, stages, records, model);
  const std::vector<Stretch> stretches = read_loaded_faces(field, plan, groups, stages, model);
  const std::string kind = only_edge_intensity(field);
  const Field value = field.at(kind);
  const TimeFunction history = read_history(field, kind == "force" ? Dimension::force : Dimension::stress, records);
  if (kind == "pressure") {
    std::vector<PressedFace> faces;
    for (const Stretch& stretch : stretches) faces.push_back({stretch, stages});
    read_pressure(field, faces, history, stages, model);
    return;
  }
  refuse(field, {"follows"}, "beside a traction or force, which keeps its direction");
  const bool in_situ = kind == "traction" && value.is_text();  // the schema knows one text
  Vec2 traction = Vec2::Zero();
  if (in_situ) require_stress(value, stretches, stresses, model);
  if (kind == "traction" && !in_situ) traction = value.vector(Dimension::stress);
  if (kind == "force") traction = value.vector(Dimension::force) / total_length(stretches);
  for (const Stretch& s : stretches) {
    if (in_situ) take_in_situ(field, s, stages, model, taken);
    const Vec2 own = in_situ ? stresses.traction_on(s, model) : traction;
    model.edge_loads.push_back({s.block, s.from, s.to, own, history, stages});
  }
}

double read_normal_speed(const Field& field, const Material& material) {
  const auto speed = field.find("normal_speed");
  if (!speed) return p_wave_speed(material);
  if (speed->is_text() && speed->text() == "p") return p_wave_speed(material);
  if (speed->is_text() && speed->text() == "bar") return bar_wave_speed(material);
  return speed->positive(Dimension::velocity);
}

double read_shear_speed(const Field& field, const Material& material) {
  const auto speed = field.find("shear_speed");
  if (!speed || (speed->is_text() && speed->text() == "s")) return s_wave_speed(material);
  return speed->positive(Dimension::velocity);
}

double read_impedance(const Field& field, const char* key, double otherwise) {
  return value_or(field, key, otherwise, [](const Field& f) { return f.not_negative(Dimension::impedance); });
}

// Lists the faces of blocks along a free-field side from below, without those of held blocks, on which the side stands.
std::vector<Stretch> read_free_side(const Field& field, const GroundPlan& plan, const Model& model) {
  refuse(field, {"carries_initial_stress"}, "beside free_field, which brings the stress of its column");
  std::vector<Stretch> stretches = read_edge(field, plan, model);
  std::erase_if(stretches, [&](const Stretch& s) { return model.is_held(s.block); });
  if (stretches.empty()) field.at("edge").fail("an edge of blocks that are not held");
  const Vec2 inward = stretches.front().inward;
  for (const Stretch& s : stretches)
    if (std::abs(s.inward.y()) > 1e-6 || s.inward.x() * inward.x() < 0)
      field.at("edge").fail(fmt::format("along the side of \"{}\" that is not vertical or faces the other way",
                                        model.blocks[static_cast<std::size_t>(s.block)].name),
                            "one vertical side for a free field");
  std::sort(stretches.begin(), stretches.end(),
            [](const Stretch& a, const Stretch& b) { return a.from.y() + a.to.y() < b.from.y() + b.to.y(); });
  return stretches;
}

// The edges on which loads put the traction in situ, whenever they do.
TakenEdges in_situ_loads(const Field& scene, const GroundPlan& plan, const Model& model) {
  TakenEdges found;
  const auto loads = scene.find("loads");
  if (!loads) return found;
  for (const Field& load : loads->items()) {
    const auto traction = load.find("traction");
    if (!traction || !traction->is_text() || is_wall_laid_bare(load)) continue;
    for (const Stretch& stretch : read_edge(load, plan, model)) found.take(stretch, {}, load.path());
  }
  return found;
}

void append_free_field_side(const std::vector<Stretch>& stretches, Model& model) {
  FreeFieldSide side;
  const std::size_t first = model.viscous_edges.size() - stretches.size();
  for (std::size_t i = 0; i < stretches.size(); ++i) side.viscous_edges.push_back(static_cast<int>(first + i));
  side.outward = stretches.front().inward.x() > 0 ? -1 : 1;
  model.free_field_sides.push_back(std::move(side));
}

void carry_initial_stress(const Field& boundary, const Stretch& s, const StressField& stresses,
                          const TakenEdges& in_situ, Model& model) {
  if (const std::string load = in_situ.taker_of(s, {}, model); !load.empty())
    boundary.at("carries_initial_stress")
        .fail(fmt::format("true along \"{}\", on which {} puts the traction in situ already", name_of(s.block, model),
                          load),
              "one of the two, as both would double it");
  model.edge_loads.push_back({s.block, s.from, s.to, stresses.traction_on(s, model), Constant{}});
}

void take_absorbing(const Field& boundary, const Stretch& s, const Model& model, TakenEdges& absorbing) {
  if (const std::string taker = absorbing.taker_of(s, {}, model); !taker.empty())
    boundary.at("edge").fail(fmt::format("along \"{}\", where {} absorbs already", name_of(s.block, model), taker),
                             "one of the two, as both would add up");
  absorbing.take(s, {}, boundary.path());
}

void read_viscous_boundary(const Field& field, const GroundPlan& plan, const StressField& stresses,
                           const TakenEdges& in_situ, TakenEdges& absorbing, Model& model) {
  if (field.has("normal_impedance")) refuse(field, {"normal_speed"}, "beside normal_impedance");
  if (field.has("shear_impedance")) refuse(field, {"shear_speed"}, "beside shear_impedance");
  const double ratio =
      value_or(field, "ratio", 1.0, [](const Field& f) { return f.positive(Dimension::dimensionless); });
  const int first_stage =
      value_or(field, "from_stage", 0, [&](const Field& f) { return read_stage_reference(f, model); });
  const bool carries = value_or(field, "carries_initial_stress", false, [](const Field& f) { return f.truth(); });
  const bool free_field = value_or(field, "free_field", false, [](const Field& f) { return f.truth(); });
  const std::vector<Stretch> stretches =
      free_field ? read_free_side(field, plan, model) : read_edge(field, plan, model);
  for (const Stretch& s : stretches) {
    take_absorbing(field, s, model, absorbing);
    const Material& material = model.material_of(s.block);
    const double normal =
        read_impedance(field, "normal_impedance", material.density * read_normal_speed(field, material));
    const double shear = read_impedance(field, "shear_impedance", material.density * read_shear_speed(field, material));
    model.viscous_edges.push_back({s.block, s.from, s.to, ratio * normal, ratio * shear, first_stage});
    if (carries) carry_initial_stress(field, s, stresses, in_situ, model);
  }
  if (free_field) append_free_field_side(stretches, model);
}

// Only when all that acts has been read; what is wrong is said of the edge that asked for a free field.
void check_free_field(const std::vector<Field>& edges, const Model& model) {
  for (std::size_t i = 0; i < edges.size(); ++i) {
    try {
      model_checks::check_free_field_side(model, i);
    } catch (const InputError& error) {
      edges[i].fail(error.value(), error.expected());
    }
  }
}

template <typename Read>
void read_each(const Field& scene, const char* key, Read read) {
  const auto list = scene.find(key);
  if (!list) return;
  for (const Field& entry : list->items()) read(entry);
}

}  // namespace

void read_loads(const Field& scene, const GroundPlan& plan, const std::vector<std::string>& groups,
                const StressField& stresses, RecordFiles& records, Model& model) {
  InSituEdges in_situ{{}, fading_edges(scene, plan, model)};
  read_each(scene, "loads", [&](const Field& load) {
    if (load.has("point")) {
      read_point_load(load, plan, records, model);
    } else {
      read_edge_load(load, plan, groups, stresses, records, in_situ, model);
    }
  });
}

void read_viscous_boundaries(const Field& scene, const GroundPlan& plan, const StressField& stresses, Model& model) {
  std::vector<Field> free_edges;
  const TakenEdges in_situ = in_situ_loads(scene, plan, model);
  TakenEdges absorbing;
  read_each(scene, "viscous_boundaries", [&](const Field& edge) {
    const std::size_t before = model.free_field_sides.size();
    read_viscous_boundary(edge, plan, stresses, in_situ, absorbing, model);
    if (model.free_field_sides.size() > before) free_edges.push_back(edge.at("edge"));
  });
  check_free_field(free_edges, model);
}

}  // namespace dda
