#include "engine/app/view_command.h"

#include <fmt/format.h>

#include <charconv>
#include <ostream>
#include <system_error>

#include "engine/core/error.h"
#include "engine/record/atomic_file.h"
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

std::optional<Window> window_of(const std::vector<double>& sides) {
  if (sides.empty()) return std::nullopt;
  if (sides.size() != 4 || !(sides[0] < sides[2]) || !(sides[1] < sides[3]))
    throw InputError("", "--window", fmt::format("{}", fmt::join(sides, ",")),
                     "LEFT,BOTTOM,RIGHT,TOP in m, with LEFT < RIGHT and BOTTOM < TOP");
  return Window{sides[0], sides[1], sides[2], sides[3]};
}

void draw_picture(const ViewOptions& options, std::ostream& out) {
  if (options.file.empty()) throw InputError("", "--out", "missing", "the file of the picture, which --svg needs");
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

void view_run(const ViewOptions& options, std::ostream& out) {
  if (!options.svg_frame.empty()) return draw_picture(options, out);
  PageOptions page;
  page.folder = options.folder;
  page.file = options.file.empty() ? options.folder / "view.html" : options.file;
  page.quantity = options.quantity;
  page.most_bytes = static_cast<std::size_t>(options.most_megabytes * 1e6);
  write_page(page, out);
}

}  // namespace dda
