#include "engine/app/cut_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

#include "engine/scene/cut_remarks.h"

namespace dda {
namespace {

using nlohmann::json;

constexpr double degrees = 180 / std::numbers::pi;

void add(const CutEntry& entry, CutFigures& figures) {
  figures.blocks += entry.cut.blocks.size();
  figures.boundary_area += entry.cut.boundary_area;
  figures.left_out_area += entry.cut.left_out_area;
  figures.dropped_area += entry.cut.dropped_area;
  figures.lines += entry.rock.plan.lines.size();
  figures.dangles_trimmed += entry.cut.dangles_trimmed;
  figures.merged += entry.cut.merged;
  for (const CutBlock& block : entry.cut.blocks) {
    const BlockShape shape = shape_of(block.shape);
    figures.area += shape.area;
    figures.smallest_area = std::min(figures.smallest_area, shape.area);
    figures.smallest_angle = std::min(figures.smallest_angle, shape.sharpest);
    figures.largest_aspect = std::max(figures.largest_aspect, shape.aspect);
    if (shape.aspect > slender_aspect) ++figures.slender;
    figures.shapes.push_back(shape);
  }
  figures.statistics.push_back(statistics_of(entry.cut, entry.rock.plan));
}

json entry_of(const Cleaned& cleaned) {
  json entry = {
      {"what", to_string(cleaned.what)}, {"at", {cleaned.from.x(), cleaned.from.y()}}, {"size", cleaned.size}};
  if (cleaned.from != cleaned.to) entry["to"] = {cleaned.to.x(), cleaned.to.y()};
  if (!cleaned.origin.empty()) entry["line"] = cleaned.origin;
  return entry;
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
  json cleaned = json::array();
  json statistics = json::array();
  json fills = json::array();
  json points = json::array();
  json remarks = json::array();
  for (const CutEntry& entry : scene.entries) {
    statistics.push_back(statistics_entry(entry, figures.statistics[statistics.size()]));
    for (const CutFill& fill : entry.cut.fills) fills.push_back(fill_entry(fill));
    for (const PlanPoint& point : entry.rock.plan.points) points.push_back(point_entry(point));
    for (const std::string& remark : entry.rock.remarks) remarks.push_back(remark);
    for (const Cleaned& each : entry.cut.cleaned) cleaned.push_back(entry_of(each));
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
                       {"cleaned", cleaned}};
  return report.dump(1) + "\n";
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
