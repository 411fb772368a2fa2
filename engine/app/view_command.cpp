#include "engine/app/view_command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <ostream>
#include <system_error>

#include "engine/core/error.h"
#include "engine/record/atomic_file.h"
#include "engine/scene/file_kind.h"
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
void check_output(const std::filesystem::path& file, const std::vector<std::string>& extensions) {
  const std::string extension = file.extension().string();
  if (!extension.empty() && std::ranges::find(extensions, extension) == extensions.end())
    throw InputError("", "--out", file.string(),
                     fmt::format("a name that ends in {}, which is what is written", fmt::join(extensions, " or ")));
  if (const std::string kind = why_unwritable(file); !kind.empty())
    throw InputError("", "--out", file.string() + ", which is " + kind, "a file, or a name that is free");
}

void draw_picture(const ViewOptions& options, std::ostream& out) {
  if (options.file.empty()) throw InputError("", "--out", "missing", "the file of the picture, which --svg needs");
  check_output(options.file, {".svg"});
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
  expect_folder(options.folder);
  if (!options.svg_frame.empty()) return draw_picture(options, out);
  PageOptions page;
  page.folder = options.folder;
  page.file = options.file.empty() ? options.folder / "view.html" : options.file;
  check_output(page.file, {".html", ".htm"});
  page.quantity = options.quantity;
  page.most_bytes = static_cast<std::size_t>(options.most_megabytes * 1e6);
  write_page(page, out);
}

}  // namespace dda
