#include "engine/app/cut_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string_view>

#include "engine/core/parallel.h"
#include "engine/scene/cut_remarks.h"
#include "engine/scene/json_pieces.h"

namespace dda {
namespace {

using nlohmann::json;

constexpr double degrees = 180 / std::numbers::pi;
constexpr std::size_t entries_in_part = 10'000;  // of a list that threads write together

void add(const CutEntry& entry, CutFigures& figures) {
  figures.blocks += entry.cut.blocks.size();
  figures.boundary_area += entry.cut.boundary_area;
  figures.left_out_area += entry.cut.left_out_area;
  figures.dropped_area += entry.cut.dropped_area;
  figures.lines += entry.rock.plan.lines.size();
  figures.dangles_trimmed += entry.cut.dangles_trimmed;
  figures.merged += entry.cut.merged;
  std::vector<BlockShape> shapes(entry.cut.blocks.size());
  constexpr std::size_t worth_sharing = 256;
  parallel_for_each(shapes.size(), worth_sharing,
                    [&](std::size_t i) { shapes[i] = shape_of(entry.cut.blocks[i].shape); });
  for (const BlockShape& shape : shapes) {
    figures.area += shape.area;
    figures.smallest_area = std::min(figures.smallest_area, shape.area);
    figures.smallest_angle = std::min(figures.smallest_angle, shape.sharpest);
    figures.largest_aspect = std::max(figures.largest_aspect, shape.aspect);
    if (shape.aspect > slender_aspect) ++figures.slender;
    figures.shapes.push_back(shape);
  }
  figures.statistics.push_back(statistics_of(entry.cut, entry.rock.plan));
}

void append_place(const Vec2& place, std::string& text) {
  text += "[\n    ";
  append_json_number(place.x(), text);
  text += ",\n    ";
  append_json_number(place.y(), text);
  text += "\n   ]";
}

// As the JSON library would write it there, keys in their order.
void append_entry(const Cleaned& cleaned, std::string& text) {
  text += "  {\n   \"at\": ";
  append_place(cleaned.from, text);
  if (!cleaned.origin.empty()) {
    text += ",\n   \"line\": ";
    append_json_text(cleaned.origin, text);
  }
  text += ",\n   \"size\": ";
  append_json_number(cleaned.size, text);
  if (cleaned.from != cleaned.to) {
    text += ",\n   \"to\": ";
    append_place(cleaned.to, text);
  }
  text += ",\n   \"what\": ";
  append_json_text(to_string(cleaned.what), text);
  text += "\n  }";
}

// `more` bytes follow it in the text.
void append_list(const std::vector<const Cleaned*>& all, std::size_t more, std::string& text) {
  if (all.empty()) {
    text += "[]";
    return;
  }
  text += "[\n";
  const auto append_one = [&](std::size_t i, std::string& to) { append_entry(*all[i], to); };
  append_entries(all.size(), entries_in_part, ",\n", append_one, text, more);
  text += "\n ]";
}

json point_entry(const PlanPoint& point) {
  return {{"layer", point.layer}, {"name", point.name}, {"at", {point.at.x(), point.at.y()}}, {"drawn", point.origin}};
}

json statistics_entry(const CutEntry& entry, const RockStatistics& statistics) {
  return {{"rock", entry.rock.group.name},
          {"mean_area", statistics.mean_area},
          {"area_10_50_90_percent", statistics.area_shares},
          {"p20", statistics.p20},
          {"p21", statistics.p21},
          {"p20_traces", statistics.p20_traces},
          {"p21_traces", statistics.p21_traces},
          {"rqd_level", statistics.rqd_level},
          {"rqd_upright", statistics.rqd_upright},
          {"rqd_level_traces", statistics.rqd_level_traces},
          {"rqd_upright_traces", statistics.rqd_upright_traces}};
}

json fill_entry(const CutFill& fill) {
  return {{"fill", fill.origin},
          {"blocks", fill.blocks},
          {"cells", fill.sites},
          {"short_edges_closed", fill.short_edges_closed}};
}

std::string cleaned_text(const CutScene& scene) {
  std::vector<const CutRock*> rocks;
  for (const CutEntry& entry : scene.entries) rocks.push_back(&entry.cut);
  const std::string text = cleaned_in_words(rocks);
  return text.empty() ? "cleaned: nothing\n" : "cleaned: " + text + " (cut.json says where)\n";
}

}  // namespace

CutFigures figures_of(const CutScene& scene, double seconds) {
  CutFigures figures;
  figures.smallest_area = figures.smallest_angle = std::numeric_limits<double>::infinity();
  for (const CutEntry& entry : scene.entries) add(entry, figures);
  figures.seconds = seconds;
  return figures;
}

std::string report_json(const CutScene& scene, const CutFigures& figures) {
  std::vector<const Cleaned*> cleaned;
  json statistics = json::array();
  json fills = json::array();
  json points = json::array();
  json remarks = json::array();
  for (const CutEntry& entry : scene.entries) {
    statistics.push_back(statistics_entry(entry, figures.statistics[statistics.size()]));
    for (const CutFill& fill : entry.cut.fills) fills.push_back(fill_entry(fill));
    for (const PlanPoint& point : entry.rock.plan.points) points.push_back(point_entry(point));
    for (const std::string& remark : entry.rock.remarks) remarks.push_back(remark);
    for (const Cleaned& each : entry.cut.cleaned) cleaned.push_back(&each);
  }
  const json report = {{"blocks", figures.blocks},
                       {"area", figures.area},
                       {"boundary_area", figures.boundary_area},
                       {"left_out_area", figures.left_out_area},
                       {"dropped_area", figures.dropped_area},
                       {"smallest_area", figures.smallest_area},
                       {"smallest_angle_deg", degrees * figures.smallest_angle},
                       {"largest_aspect", figures.largest_aspect},
                       {"slender_blocks", figures.slender},
                       {"lines", figures.lines},
                       {"dangles_trimmed", figures.dangles_trimmed},
                       {"merged", figures.merged},
                       {"tolerance", scene.entries.front().cut.tolerance},
                       {"seconds", figures.seconds},
                       {"statistics", statistics},
                       {"fills", fills},
                       {"points", points},
                       {"remarks", remarks},
                       {"cleaned", json::array()}};
  // What was cleaned is most of it. Within texts of a document there are no ends of lines, so the key is where it is.
  constexpr std::string_view key = "\n \"cleaned\": ";
  std::string text = report.dump(1) + "\n";
  const std::size_t list = text.find(key) + key.size();
  const std::string rest = text.substr(list + std::string_view("[]").size());
  text.resize(list);
  append_list(cleaned, rest.size(), text);
  text += rest;
  return text;
}

std::string report_text(const CutScene& scene, const CutFigures& figures) {
  std::string text = fmt::format("{} blocks of {:.6g} m2 in all, from {} lines in {:.2g} s\n", figures.blocks,
                                 figures.area, figures.lines, figures.seconds);
  text += fmt::format("smallest block {:.3g} m2, sharpest corner {:.3g} deg, largest aspect {:.3g}\n",
                      figures.smallest_area, degrees * figures.smallest_angle, figures.largest_aspect);
  for (const CutEntry& entry : scene.entries) {
    for (const CutFill& fill : entry.cut.fills)
      text += fmt::format("{}: {} cells in {} blocks between joints\n", fill.origin, fill.sites, fill.blocks);
  }
  text += cleaned_text(scene);
  for (const CutEntry& entry : scene.entries) {
    for (const std::string& remark : entry.rock.remarks) text += fmt::format("remark: {}\n", remark);
  }
  if (figures.slender > 0)
    text += fmt::format(
        "warning: {} blocks are more than {:g} times as long as wide; \"merge\" with an area or an angle "
        "takes them to neighbours\n",
        figures.slender, slender_aspect);
  return text;
}

}  // namespace dda
