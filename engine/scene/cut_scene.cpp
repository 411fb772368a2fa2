#include "engine/scene/cut_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <future>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <utility>

#include "engine/core/error.h"
#include "engine/drawing/read_drawing.h"
#include "engine/scene/json_path.h"
#include "engine/scene/scene.h"
#include "engine/scene/scene_document.h"
#include "engine/scene/scene_parts.h"
#include "engine/scene/schema_check.h"
#include "engine/scene/sections.h"
#include "engine/scene/written_scene.h"

namespace dda {
namespace {

using nlohmann::json;

json point(const Vec2& place) { return {place.x(), place.y()}; }

json ring(const Ring& vertices) {
  json points = json::array();
  for (const Vec2& vertex : vertices) points.push_back(point(vertex));
  return points;
}

// A block of cut rock as an entry of its own; what it shares with the rock's others is copied from there.
json polygon_entry(const Block& block, const std::string& group, const json& rock, const Model& model) {
  json polygon = {{"name", block.name}, {"group", group}, {"vertices", ring(block.shape.outer)}};
  for (const Ring& hole : block.shape.holes) polygon["holes"].push_back(ring(hole));
  if (model.materials.size() > 1) polygon["material"] = model.materials[static_cast<std::size_t>(block.material)].name;
  for (const char* key : {"initial_stress", "initial_velocity", "initial_spin"}) {
    if (rock.contains(key)) polygon[key] = rock[key];
  }
  return {{"polygon", std::move(polygon)}};
}

json joint_line_entry(const JointLine& line, const Model& model) {
  return {{"points", {point(line.from), point(line.to)}},
          {"joint", model.joints[static_cast<std::size_t>(line.joint)].name}};
}

// Records are named relative to the scene that names them.
void move_records(json& value, const std::filesystem::path& from, const std::filesystem::path& to) {
  if (!value.is_structured()) return;
  for (const auto& [key, part] : value.items()) {
    if (key == "record" && part.is_object() && part.contains("file")) {
      const std::filesystem::path file = part["file"].get<std::string>();
      if (file.is_relative()) part["file"] = std::filesystem::proximate(from / file, to).generic_string();
    }
    move_records(part, from, to);
  }
}

struct NewScene {
  CutScene scene;                  // but for its text
  json document;                   // with the first block only of each rock below
  std::vector<GivenBlocks> rocks;  // their blocks
  std::future<void> gone;          // when the document that was read is given back, which takes a while
};

class Cutter {
 public:
  // `finish` adds to the new scene what the blocks of its first rock ask for; it may be empty.
  using Finish = std::function<void(const Rock&, const std::vector<Block>&, json&)>;
  Cutter(SceneDocument scene, Finish finish, const std::function<void(std::string_view)>& progress)
      : document_(std::move(scene.document)),
        lines_(std::move(scene.lines)),
        finish_(std::move(finish)),
        progress_(progress) {}

  NewScene cut(const std::filesystem::path& from, const std::filesystem::path& to) {
    const Field scene(document_, "");
    read_materials(scene, model_);
    const std::vector<std::string> remarks = read_joints(scene, read_scheme(scene), from, lines_, model_);
    const Field blocks = scene.at("blocks");
    for (const Field& entry : blocks.is_array() ? blocks.items() : std::vector<Field>{blocks}) add_rock_of(entry, from);
    if (result_.entries.empty()) blocks.fail("without rock", "an entry \"rock\" to cut");
    std::ranges::copy(remarks, std::back_inserter(result_.entries.front().rock.remarks));
    for (const JointMaterial& joint : model_.joints) result_.joint_names.push_back(joint.name);
    for (const Material& material : model_.materials) result_.material_names.push_back(material.name);
    json cut = with_polygons();
    if (finish_) finish_(result_.entries.front().rock, drawn_blocks_, cut);
    move_records(cut, from, to);
    return {std::move(result_), std::move(cut), std::move(rocks_), std::move(gone_)};
  }

 private:
  void add_rock_of(const Field& entry, const std::filesystem::path& from) {
    const auto rock = entry.find("rock");
    if (!rock) return;
    CutEntry cut_entry;
    cut_entry.rock = read_rock(*rock, from, lines_, model_);
    cut_entry.rock.options.progress = progress_;
    cut_entry.cut = dda::cut(cut_entry.rock);
    std::ranges::copy(cut_entry.cut.remarks, std::back_inserter(cut_entry.rock.remarks));
    result_.entries.push_back(std::move(cut_entry));
  }

  // Takes the document that was read apart: there may be a million lines in it, which the new one has no use for.
  [[nodiscard]] json with_polygons() {
    json old = std::exchange(document_["blocks"], json::array());
    json cut = std::move(document_);
    json lines = json::array();
    std::size_t number = 0;
    const auto take = [&](const json& entry) {
      if (entry.contains("rock"))
        append(result_.entries[number++], entry["rock"], cut["blocks"], lines);
      else
        cut["blocks"].push_back(entry);
    };
    if (old.is_array())
      for (const json& entry : old) take(entry);
    else
      take(old);
    if (cut.contains("joint_lines")) {
      for (const json& line : cut["joint_lines"]) lines.push_back(line);
    }
    if (!lines.empty()) cut["joint_lines"] = std::move(lines);
    drop_unused_joints(cut);
    gone_ = std::async(std::launch::async, [all = std::move(old)]() mutable { all = nullptr; });
    return cut;
  }

  // Those whose lines all were outside or trimmed; a scene may not have joints that nothing uses.
  static void drop_unused_joints(json& scene) {
    if (!scene.contains("joints")) return;
    std::set<std::string> used{"default"};
    for (const char* key : {"joint_lines", "joint_pairs"}) {
      if (!scene.contains(key)) continue;
      for (const json& entry : scene[key]) used.insert(entry["joint"].get<std::string>());
    }
    json kept = json::object();
    for (const auto& [name, joint] : scene["joints"].items()) {
      if (used.contains(name)) kept[name] = joint;
    }
    scene["joints"] = std::move(kept);
  }

  void append(const CutEntry& entry, const json& rock, json& blocks, json& lines) {
    Model part;
    part.materials = model_.materials;
    part.joints = model_.joints;
    std::vector<std::string> groups;
    append_rock(entry.rock, entry.cut, part, groups);
    // Run data of a drawing say the state of each block, for which all of them have to be in the document.
    const std::size_t written_out = finish_ ? part.blocks.size() : 1;
    const std::size_t first = blocks.size();
    for (std::size_t i = 0; i < written_out; ++i)
      blocks.push_back(polygon_entry(part.blocks[i], groups[i], rock, part));
    for (const JointLine& line : part.joint_lines) lines.push_back(joint_line_entry(line, part));
    if (finish_)
      std::ranges::move(part.blocks, std::back_inserter(drawn_blocks_));
    else
      rocks_.push_back({first, std::move(part.blocks), std::move(groups)});
  }

  json document_;
  std::vector<PlainLines> lines_;
  Finish finish_;
  const std::function<void(std::string_view)>& progress_;
  Model model_;
  CutScene result_;
  std::vector<GivenBlocks> rocks_;
  std::vector<Block> drawn_blocks_;  // where `finish_` asks for them
  std::future<void> gone_;
};

NewScene cut_document(const std::filesystem::path& file, const std::filesystem::path& folder,
                      const std::function<void(std::string_view)>& progress) {
  std::string text = scene_text(file);
  try {
    SceneDocument scene = read_scene_document(text);
    text = {};
    return Cutter(std::move(scene), {}, progress).cut(file.parent_path(), folder);
  } catch (const InputError& error) {
    throw error.in_file(file.string());
  }
}

// The scene around a drawing is nobody's: what is wrong in it is an option, or the drawing.
InputError in_words_of_drawing(const InputError& error, const std::string& drawing, const DrawingWords& words) {
  const std::string& field = error.field();
  const auto as = [&](const std::string& name) { return InputError("", name, error.value(), error.expected()); };
  for (const auto& [layer, use] : words.layers)
    if (field == member_path("blocks.rock.drawing.layers", layer)) return as("--layer " + layer);
  if (field == "blocks.rock.drawing.unit") return as("--unit");
  return field.starts_with("blocks.rock") ? as(drawing) : error;
}

// Errors name the drawing and a line of it by themselves.
NewScene cut_drawing(const std::filesystem::path& file, const std::filesystem::path& folder, const DrawingWords& words,
                     const std::function<void(std::string_view)>& progress) {
  try {
    const std::optional<RunData> data = run_data_for(file, words);
    const auto finish = [&data](const Rock& rock, const std::vector<Block>& blocks, json& scene) {
      add_marked_places(rock, blocks, data, scene);
    };
    return Cutter({scene_around(file, words, data), {}}, finish, progress).cut({}, folder);
  } catch (const InputError& error) {
    throw in_words_of_drawing(error, file.string(), words);
  }
}

// A document with one of its blocks and one of its joint lines, which follow the schema all or none of them.
json with_one_of_each(const json& document) {
  json small = json::object();
  for (const auto& [key, value] : document.items()) {
    const bool is_of_many = (key == "blocks" || key == "joint_lines") && !value.empty();
    small[key] = is_of_many ? json::array({value.front()}) : value;
  }
  return small;
}

// Rock in many blocks is a long text, and takes as long to write as to check. So the document is checked: to read the
// text again would only check the library that writes it.
void check_document(const NewScene& made, const std::string& name, const std::filesystem::path& folder) {
  try {
    check_schema(with_one_of_each(made.document));
  } catch (const InputError& error) {
    throw error.in_file(name);
  }
  read_document(made.document, made.rocks, name, folder);
}

}  // namespace

CutScene cut_scene(const std::filesystem::path& file, const std::filesystem::path& folder, const DrawingWords& words,
                   const std::function<void(std::string_view)>& progress, const UseOfCut& meanwhile) {
  NewScene made = is_drawing(file) ? cut_drawing(file, folder, words, progress) : cut_document(file, folder, progress);
  if (progress) progress("checking the scene");
  std::future<std::string> text = std::async(std::launch::async, [&] {
    if (meanwhile) meanwhile(made.scene);
    return written_scene(made.document, made.rocks, made.scene.material_names);
  });
  check_document(made, file.string() + " (cut)", folder);
  made.scene.text = text.get();
  return std::move(made.scene);
}

}  // namespace dda
