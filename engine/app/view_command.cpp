#include "engine/app/view_command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <optional>
#include <ostream>
#include <string_view>
#include <system_error>

#include "engine/app/output_file.h"
#include "engine/app/scene_picture.h"
#include "engine/core/error.h"
#include "engine/drawing/read_drawing.h"
#include "engine/geometry/box.h"
#include "engine/record/atomic_file.h"
#include "engine/scene/cut_scene.h"
#include "engine/scene/file_kind.h"
#include "engine/scene/scene_parts.h"
#include "engine/simulation/probes.h"
#include "engine/simulation/simulation.h"
#include "engine/view/page.h"
#include "engine/view/quantities.h"
#include "engine/view/run_facts.h"
#include "engine/view/svg_picture.h"

namespace dda {
namespace {

std::size_t frame_number(const std::string& text, std::size_t frames) {
  if (text == "last") return frames - 1;
  std::size_t number = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stop != end || number >= frames)
    throw InputError("", "--svg", "\"" + text + "\"", fmt::format("a frame from 0 to {}, or last", frames - 1));
  return number;
}

DrawnForces forces_of(const std::string& text) {
  if (text == "joints") return DrawnForces::joints;
  if (text == "contacts") return DrawnForces::contacts;
  if (text == "none") return DrawnForces::none;
  throw InputError("", "--forces", "\"" + text + "\"", "joints, contacts or none");
}

constexpr double farthest = 1e9;        // m, of a window from the origin: beyond all scenes
constexpr double smallest_side = 1e-6;  // m, of a window: below all blocks
constexpr double most_slender = 1e4;    // sides of a window, one to the other

std::optional<Window> window_of(const std::vector<double>& sides) {
  if (sides.empty()) return std::nullopt;
  const auto refuse = [&](const std::string& expected) {
    throw InputError("", "--window", fmt::format("{}", fmt::join(sides, ",")),
                     "LEFT,BOTTOM,RIGHT,TOP in m, " + expected);
  };
  const auto in_reach = [](double side) { return std::abs(side) <= farthest; };  // false of what is no number
  if (sides.size() != 4 || !std::ranges::all_of(sides, in_reach))
    refuse(fmt::format("four numbers from -{:g} to {:g}", farthest, farthest));
  const double wide = sides[2] - sides[0];
  const double high = sides[3] - sides[1];
  if (!(wide > 0) || !(high > 0)) refuse("with LEFT < RIGHT and BOTTOM < TOP");
  if (std::min(wide, high) < smallest_side || std::max(wide, high) > most_slender * std::min(wide, high))
    refuse(fmt::format("at least {:g} m wide and high, one at most {:g} times the other", smallest_side, most_slender));
  return Window{sides[0], sides[1], sides[2], sides[3]};
}

// Whether `file` can take what is written, and has a name that says so.
void check_output(const std::filesystem::path& file, const std::filesystem::path& folder_of_run,
                  const std::vector<std::string>& extensions) {
  const std::string extension = file.extension().string();
  if (!extension.empty() && std::ranges::find(extensions, extension) == extensions.end())
    throw InputError("", "--out", file.string(),
                     fmt::format("a name that ends in {}, which is what is written", fmt::join(extensions, " or ")));
  expect_output(file, folder_of_run);
}

bool is_given(const ViewOptions& options, std::string_view name) {
  return std::ranges::find(options.given, name) != options.given.end();
}

// What is a file, or has the name of one that could be drawn.
bool shows_scene(const std::filesystem::path& given) {
  std::error_code ignored;
  if (std::filesystem::is_regular_file(given, ignored)) {
    const auto kind = kind_other_than_scene(given);
    return !kind || (is_drawing(given) && kind->command.starts_with("dda cut"));
  }
  return (is_drawing(given) || given.extension() == ".json") && !std::filesystem::exists(given, ignored);
}

// Options that say something of results, which a scene does not have.
void refuse_options_of_runs(const ViewOptions& options) {
  for (const char* name : {"--quantity", "--max-size", "--svg", "--forces", "--crosses", "--deformation-scale"})
    if (is_given(options, name))
      throw InputError("", name, "given for a scene, which is drawn before anything moves",
                       "the folder of a run: dda run SCENE.json --out DIR --frames 100 makes one");
}

void refuse_options_without_picture(const ViewOptions& options) {
  for (const char* name : {"--forces", "--crosses", "--deformation-scale", "--window"})
    if (is_given(options, name)) throw InputError("", name, "given without --svg", "--svg FRAME beside it");
}

void refuse_options_of_drawings(const ViewOptions& options) {
  for (const char* name : {"--layer", "--unit", "--run-data"})
    if (is_given(options, name)) throw InputError("", name, "given beside a run", "a drawing, in place of the run");
}

SceneParts parts_of_drawing(const std::filesystem::path& file, const DrawingWords& words) {
  CutScene cut = cut_scene(file, file.parent_path(), words);
  SceneParts parts = parse_scene_parts(cut.text, file.string() + " (cut)", file.parent_path());
  for (const CutEntry& entry : cut.entries) std::ranges::copy(entry.rock.remarks, std::back_inserter(parts.remarks));
  return parts;
}

// What only setting up a run finds out is refused too, as by dda check.
void expect_runnable(const Model& model, const std::string& file) {
  try {
    const Simulation simulation(model);
    const Probes probes(simulation);
  } catch (const InputError& error) {
    throw error.in_file(file);
  }
}

std::optional<Box> part_of(const std::vector<double>& sides) {
  const std::optional<Window> window = window_of(sides);
  if (!window) return std::nullopt;
  return Box{{window->left, window->bottom}, {window->right, window->top}};
}

void draw_scene(const ViewOptions& options, std::ostream& out) {
  refuse_options_of_runs(options);
  const std::filesystem::path& scene = options.folder;
  const DrawingWords words = words_of(options.drawing, scene);
  const std::optional<Box> part = part_of(options.window);
  const std::filesystem::path file =
      options.file.empty() ? std::filesystem::path(scene).replace_extension(".view.svg") : options.file;
  check_output(file, {}, {".svg"});
  const SceneParts parts = is_drawing(scene) ? parts_of_drawing(scene, words) : read_scene_parts(scene);
  expect_runnable(parts.model, scene.string());
  write_file(file, scene_picture(parts, part));
  for (const std::string& remark : parts.remarks) out << "remark: " << remark << '\n';
  out << fmt::format("{}: {} block{}, before anything moves\n", file.string(), parts.model.blocks.size(),
                     parts.model.blocks.size() == 1 ? "" : "s");
}

void draw_picture(const ViewOptions& options, std::ostream& out) {
  if (options.file.empty()) throw InputError("", "--out", "missing", "the file of the picture, which --svg needs");
  check_output(options.file, options.folder, {".svg"});
  PictureOptions picture;
  picture.quantity = options.quantity;
  picture.forces = forces_of(options.forces);
  picture.crosses = options.crosses;
  picture.deformation_scale = options.deformation_scale;
  picture.window = window_of(options.window);
  find_quantity(options.quantity, "--quantity");
  const RunResults results(options.folder);
  const std::size_t number = frame_number(options.svg_frame, results.times().size());
  const Frame frame = results.frame(number);
  picture.title = read_facts(options.folder).title;
  write_file(options.file, svg_picture(results.drawing(), frame, picture));
  out << fmt::format("{}: frame {} of 0 to {}, t = {:.6g} s\n", options.file.string(), number,
                     results.times().size() - 1, frame.time);
}

}  // namespace

void expect_folder(const std::filesystem::path& folder) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(folder, ignored)) return;
  const auto kind = kind_other_than_scene(folder);
  const std::string advice = kind ? kind->command : "dda run makes one of a scene";
  throw InputError("", "the folder of the run", folder.string() + ", which is " + (kind ? kind->what : "a file"),
                   "a folder with results; " + advice);
}

void view_run(const ViewOptions& options, std::ostream& out) {
  if (shows_scene(options.folder)) return draw_scene(options, out);
  expect_folder(options.folder);
  refuse_options_of_drawings(options);
  if (!options.svg_frame.empty()) return draw_picture(options, out);
  refuse_options_without_picture(options);
  PageOptions page;
  page.folder = options.folder;
  page.file = options.file.empty() ? options.folder / "view.html" : options.file;
  check_output(page.file, page.folder, {".html", ".htm"});
  page.quantity = options.quantity;
  page.most_bytes = static_cast<std::size_t>(options.most_megabytes * 1e6);
  write_page(page, out);
}

}  // namespace dda
