#include "engine/view/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/core/error.h"
#include "engine/record/atomic_file.h"
#include "engine/record/vtp_file.h"
#include "engine/view/base64.h"
#include "engine/view/colour_map.h"
#include "engine/view/packing.h"
#include "engine/view/page_parts.h"
#include "engine/view/run_facts.h"

namespace dda {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t plotted_rows = 2000;

// Every `stride`-th frame, and the last.
std::vector<std::size_t> chosen_frames(std::size_t frames, std::size_t stride) {
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < frames; i += stride) chosen.push_back(i);
  if (chosen.back() != frames - 1) chosen.push_back(frames - 1);
  return chosen;
}

PackedRun packed(const RunResults& results, const std::vector<std::size_t>& frames) {
  PackedRun run(results.drawing());
  for (const std::size_t frame : frames) run.add(results.frame(frame));
  return run;
}

std::string megabytes(std::size_t bytes) { return fmt::format("{:.3g} MB", static_cast<double>(bytes) / 1e6); }

// As many frames as fit. How many that will be is first estimated from two of them.
PackedRun packed_to_fit(const RunResults& results, const PageOptions& options) {
  const std::size_t frames = results.times().size();
  const auto too_long = [&](std::size_t bytes) { return (bytes + options.most_bytes - 1) / options.most_bytes; };
  const std::size_t two_frames = packed(results, chosen_frames(frames, frames)).size();
  for (std::size_t stride = std::max<std::size_t>(too_long(two_frames / 2 * frames), 1);;) {
    PackedRun run = packed(results, chosen_frames(frames, stride));
    if (run.size() <= options.most_bytes) return run;
    if (stride >= frames)
      throw InputError("", "the size of two frames", megabytes(run.size()),
                       fmt::format("at most the {} of --max-size", megabytes(options.most_bytes)));
    stride = std::min(stride * std::max<std::size_t>(too_long(run.size()), 2), frames);
  }
}

Json map_json(const ColourMap& map) {
  Json colours = Json::array();
  for (const Rgb& colour : map) colours.push_back(to_hex(colour));
  return colours;
}

Json histories_json(const std::optional<Histories>& histories) {
  if (!histories || histories->times.empty()) return nullptr;
  const Histories plotted = thinned(*histories, plotted_rows);
  Json columns = Json::array();
  for (const HistoryColumn& column : plotted.columns)
    columns.push_back({{"name", column.name}, {"unit", column.unit}, {"values", column.values}});
  return {{"times", plotted.times}, {"columns", std::move(columns)}};
}

std::string json_text(const Json& json) {
  std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string safe;  // "</script>" in a title must not end the script
  for (const char c : text) {
    if (c == '<')
      safe += "\\u003c";
    else
      safe += c;
  }
  return safe;
}

std::string data_part(const PackedRun& run, const Json& header) {
  std::string part =
      fmt::format("<script type=\"application/json\" id=\"data-header\">{}</script>\n", json_text(header));
  for (const auto& [name, bytes] : run.sections())
    part += fmt::format("<script type=\"text/plain\" id=\"data-{}\">{}</script>\n", name, base64(bytes));
  return part;
}

std::string script_part() {
  std::string part;
  for (const std::string_view script : page_scripts()) part += fmt::format("<script>\n{}</script>\n", script);
  return part;
}

// The template with each {{NAME}} replaced; values are not looked at again.
std::string filled(std::string_view text, const std::vector<std::pair<std::string_view, std::string>>& values) {
  std::string result;
  while (!text.empty()) {
    const std::size_t mark = text.find("{{");
    result += text.substr(0, mark);
    if (mark == std::string_view::npos) break;
    const std::size_t end = text.find("}}", mark);
    const std::string_view name = text.substr(mark + 2, end - mark - 2);
    result += std::ranges::find(values, name, [](const auto& value) { return value.first; })->second;
    text.remove_prefix(end + 2);
  }
  return result;
}

}  // namespace

void write_page(const PageOptions& options, std::ostream& out) {
  find_quantity(options.quantity, "--quantity");
  const RunResults results(options.folder);
  const RunFacts facts = read_facts(options.folder);
  const PackedRun run = packed_to_fit(results, options);
  Json header = run.header();
  header["title"] = facts.title;
  header["summary"] = facts.summary;
  header["frames_in_run"] = results.times().size();
  header["first_quantity"] = options.quantity;
  header["maps"] = {{"sequential", map_json(sequential_map())},
                    {"diverging", map_json(diverging_map())},
                    {"utilisation", map_json(utilisation_map())}};
  header["histories"] = histories_json(facts.histories);
  const std::string page = filled(page_template(), {{"TITLE", xml_escaped(facts.title)},
                                                    {"STYLE", std::string(page_style())},
                                                    {"DATA", data_part(run, header)},
                                                    {"SCRIPTS", script_part()}});
  write_file(options.file, page);
  const std::size_t shown = header["times"].size();
  out << fmt::format("{}: {} blocks, {} frames{}, {}; open it in a browser\n", options.file.string(),
                     results.drawing().blocks(), shown,
                     shown < results.times().size() ? fmt::format(" of {} (thinned to {}, see --max-size)",
                                                                  results.times().size(), megabytes(options.most_bytes))
                                                    : "",
                     megabytes(page.size()));
}

}  // namespace dda
