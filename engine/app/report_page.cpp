#include "engine/app/report_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

#include "engine/app/block_sheet.h"
#include "engine/app/moving_part.h"
#include "engine/app/report_peaks.h"
#include "engine/app/report_tables.h"
#include "engine/app/run_request.h"
#include "engine/core/error.h"
#include "engine/record/run_folder.h"
#include "engine/record/vtp_file.h"
#include "engine/scene/scene.h"
#include "engine/view/line_plot.h"
#include "engine/view/run_facts.h"
#include "engine/view/run_results.h"
#include "engine/view/svg_picture.h"

namespace dda {
namespace {

constexpr std::size_t most_rows = 1200;  // of a plot
constexpr std::size_t most_plots = 60;
constexpr std::size_t most_lines = 4;  // of a plot

constexpr auto style =
    "body { margin: 0 auto; max-width: 1400px; padding: 16px 24px; color: #1a2129; background: #f4f6f8;\n"
    "  font: 15px/1.45 'Source Sans 3', 'Segoe UI', Arial, sans-serif; font-variant-numeric: tabular-nums; }\n"
    "section { background: #fff; border: 1px solid #d5dbe1; border-radius: 6px; padding: 10px 18px; margin: 14px 0; }\n"
    "h1 { font-size: 24px; margin: 8px 0 2px; } h2 { font-size: 17px; margin: 4px 0 10px; }\n"
    "table { border-collapse: collapse; margin: 6px 24px 12px 0; display: inline-table; vertical-align: top; }\n"
    "th, td { text-align: left; padding: 2px 14px 2px 0; border-bottom: 1px solid #e6ebf0; } th { color: #566370; }\n"
    ".ok { color: #1c7c3c; } .bad { color: #c02020; } .quiet { color: #566370; }\n"
    ".plots { display: grid; grid-template-columns: repeat(auto-fit, minmax(480px, 1fr)); gap: 12px; }\n"
    ".plot { width: 100%; } .picture { max-width: 1000px; } .picture svg { width: 100%; height: auto; }\n"
    "section { overflow-x: auto; } @media print { body { background: #fff; } section { break-inside: avoid; } }\n";

bool is_zero(const std::vector<double>& values) {
  return std::ranges::all_of(values, [](double value) { return value == 0; });
}

std::string energy_plots(const std::filesystem::path& folder, double begin) {
  const std::filesystem::path path = folder / energies_name;
  if (!std::filesystem::exists(path)) return "";
  const Histories rows = from(begin, read_histories(path));
  LinePlot terms{"Energy and work per metre of thickness", "J/m", rows.times, {}};
  LinePlot error{"Size of the residual over the largest energy", "-", rows.times, {{"residual", {}}}, true};
  const HistoryColumn& residual = rows.columns[rows.columns.size() - 2];
  const HistoryColumn& largest = rows.columns.back();
  for (std::size_t i = 0; i + 2 < rows.columns.size(); ++i)
    if (!is_zero(rows.columns[i].values)) terms.lines.push_back({rows.columns[i].name, rows.columns[i].values});
  for (std::size_t i = 0; i < rows.times.size(); ++i)
    error.lines[0].values.push_back(largest.values[i] == 0 ? 0 : residual.values[i] / largest.values[i]);
  return "<div class=\"plots\">\n" + svg_plot(terms) + svg_plot(error) + "</div>\n";
}

// Columns of one unit share plots, a few lines each, in the order of the scene.
std::string history_plots(const Histories& histories) {
  std::map<std::string, std::vector<const HistoryColumn*>> of_unit;
  std::vector<std::string> units;
  for (const HistoryColumn& column : histories.columns) {
    if (!of_unit.contains(column.unit)) units.push_back(column.unit);
    of_unit[column.unit].push_back(&column);
  }
  std::string plots;
  std::size_t drawn = 0;
  for (const std::string& unit : units) {
    const auto& columns = of_unit[unit];
    for (std::size_t i = 0; i < columns.size() && drawn < most_plots; i += most_lines, ++drawn) {
      LinePlot plot{"", unit, histories.times, {}};
      for (std::size_t j = i; j < std::min(i + most_lines, columns.size()); ++j) {
        plot.lines.push_back({columns[j]->name, columns[j]->values});
        plot.title += (plot.title.empty() ? "" : ", ") + columns[j]->name;
      }
      plots += svg_plot(plot);
    }
  }
  if (plots.empty()) return "";
  const std::string more = drawn < most_plots ? "" : "<p class=\"quiet\">There are more in histories.csv.</p>\n";
  return "<div class=\"plots\">\n" + plots + "</div>\n" + more;
}

std::string last_frame(const std::filesystem::path& folder) {
  const RunResults results(folder);
  const Frame frame = results.frame(results.times().size() - 1);
  const PictureOptions options;
  return fmt::format(
      "<p>The last frame, at {:.6g} s: mean stress, and the forces that joints carry.</p>\n"
      "<div class=\"picture\">{}</div>\n",
      frame.time, svg_picture(results.drawing(), frame, options));
}

// The blocks as drawn, where the run has no frames. Their scene may need files that are not here.
std::string drawn_blocks(const Json& request, const std::filesystem::path& folder) {
  try {
    const Model model = parse_scene(request["scene"].dump(), (folder / request_name).string(), folder);
    BlockSheet sheet(model);
    SvgPath blocks;
    for (const Block& block : model.blocks) sheet.append_block(block.shape, blocks);
    sheet.draw_blocks(blocks, "#e3e9ee");
    return "<p>The blocks as drawn; with <code>--frames</code> a run leaves pictures.</p>\n<div class=\"picture\">" +
           sheet.text(0) + "</div>\n";
  } catch (const InputError& error) {
    return fmt::format("<p class=\"quiet\">No picture: {}</p>\n", xml_escaped(error.what()));
  }
}

std::string header(const RunFacts& facts, const Json& request) {
  const Json& summary = facts.summary;
  const std::string status = summary.value("status", "unknown");
  std::string text = fmt::format("<h1>{}</h1>\n<p><b class=\"{}\">{}</b>: {} steps to {:.6g} s in {:.3g} s",
                                 xml_escaped(facts.title), status == "ok" ? "ok" : "bad", xml_escaped(status),
                                 summary.value("steps", 0), summary.value("time_s", 0.0), summary.value("wall_s", 0.0));
  if (const Json from = summary.value("from", Json()); from.is_string())
    text += ", going on from " + xml_escaped(from.get<std::string>());
  return text + fmt::format("; <span class=\"quiet\">{}</span></p>\n", xml_escaped(request.value("program", "")));
}

}  // namespace

std::string report_page(const std::filesystem::path& folder) {
  const Json request = read_request(folder, "a folder that dda run has written to");
  const RunFacts facts = read_facts(folder);
  if (facts.summary.is_null())
    throw InputError((folder / summary_name).string(), "summary", "missing", "that of a run that has ended");
  const double begin = first_moment(facts.summary);
  const bool has_frames = std::filesystem::exists(folder / frames_name);
  std::string page = fmt::format(
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{}</title>\n<style>\n{}</style></head>\n"
      "<body>\n",
      xml_escaped(facts.title), style);
  page += header(facts, request);
  page += section("Warnings and remarks", warning_list(facts.summary));
  page += section("Blocks", has_frames ? last_frame(folder) : drawn_blocks(request, folder));
  page += section("Scene", scene_tables(facts.summary, request));
  page += section("Energies",
                  energy_plots(folder, begin) + release_table(facts.summary) + release_rate_table(facts.summary));
  page += section("Excess shear stress of joints", excess_shear_table(facts.summary));
  page += section("Strongest motion", peaks_part(facts.summary, folder));
  if (facts.histories)
    page += section("Measurements", history_plots(thinned(from(begin, *facts.histories), most_rows)));
  page += section("Counters and times", cost_tables(facts.summary));
  return page + "</body></html>\n";
}

}  // namespace dda
