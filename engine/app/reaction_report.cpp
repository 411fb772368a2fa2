#include "engine/app/reaction_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>

#include "engine/core/status.h"

namespace dda {
namespace {

using Json = nlohmann::ordered_json;

Json number_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(); }

const std::string& name_of(int block, const Model& model) { return model.blocks[static_cast<std::size_t>(block)].name; }

Json motion_json(const WallMotion& motion, const Model& model) {
  Json json{{"mean", motion.mean}};
  for (std::size_t i = 0; i < wall_places.size(); ++i)
    json[std::string(wall_place_names[i])] = number_or_null(motion.places[i]);
  json["largest"] = motion.largest;
  json["largest_of"] = name_of(motion.block, model);
  return json;
}

Json loose_json(const std::vector<UnbalancedBlock>& loose, const Model& model) {
  Json list = Json::array();
  for (const UnbalancedBlock& block : loose)
    list.push_back({{"block", name_of(block.block, model)}, {"place", {block.place.x(), block.place.y()}}});
  return list;
}

Json names_of(const std::vector<int>& blocks, const Model& model) {
  Json list = Json::array();
  for (const int block : blocks) list.push_back(name_of(block, model));
  return list;
}

Json point_json(const ReactionPoint& point, double pressure, const Model& model) {
  return {{"share", point.share},
          {"pressure", point.share * pressure},
          {"settles", point.settles()},
          {"status", to_string(point.status)},
          {"reason", point.reason},
          {"displacement", point.settles() ? motion_json(point.motion, model) : Json()},
          {"loose_blocks", loose_json(point.loose, model)}};
}

// The least share at which the rock came to rest; no number where it did at none.
double least_share(const ReactionCurve& curve) {
  double least = std::numeric_limits<double>::quiet_NaN();
  for (const ReactionPoint& point : curve.points)
    if (point.settles()) least = point.share;
  return least;
}

// What is round-off beside the largest motion of the curve: the wall that is still supported moves by some 1e-14 m.
double round_off_in(const ReactionCurve& curve) {
  double largest = 0;
  for (const ReactionPoint& point : curve.points)
    if (point.settles()) largest = std::max(largest, point.motion.largest);
  return 1e-9 * largest;
}

std::string millimetres(double motion, double round_off) {
  if (std::isnan(motion)) return fmt::format(" {:>10}", "-");
  return fmt::format(" {:>10.4g}", std::abs(motion) < round_off ? 0.0 : 1e3 * motion);
}

std::string table_row(const ReactionPoint& point, double pressure, double round_off) {
  std::string row = fmt::format("{:>6.4g} {:>13.4g}", point.share, 1e-6 * point.share * pressure);
  if (!point.settles()) return row + "  does not come to rest\n";
  row += millimetres(point.motion.mean, round_off);
  for (const double place : point.motion.places) row += millimetres(place, round_off);
  return row + "\n";
}

}  // namespace

std::optional<ReactionPoint> failure_of(const ReactionCurve& curve) {
  if (curve.points.empty() || curve.points.back().settles()) return std::nullopt;
  return curve.points.back();
}

std::vector<std::string> remarks_on(const ReactionCurve& curve, const Model& model) {
  std::vector<std::string> remarks;
  if (const auto failure = failure_of(curve)) {
    const double last = least_share(curve);
    remarks.push_back(
        fmt::format("At a share of {:.4g} ({:.4g} MPa) the rock does not come to rest, and {}: {}.", failure->share,
                    1e-6 * failure->share * curve.pressure,
                    std::isnan(last) ? std::string("there is no curve") : fmt::format("the curve ends at {:.4g}", last),
                    failure->reason));
  }
  if (!(curve.pressure > 0))
    remarks.emplace_back("In situ the opening does not press on its wall: shares say nothing of a support pressure.");
  if (!curve.loose_in_situ.empty())
    remarks.push_back(fmt::format("In situ nothing held {} already: that does not end the curve.",
                                  named_with_places(model, curve.loose_in_situ)));
  if (!curve.loose_at_full_share.empty())
    remarks.push_back(
        fmt::format("With all of its support left nothing holds {} any more: that does not end the curve, and the "
                    "wall is followed without.",
                    named_with_places(model, curve.loose_at_full_share)));
  if (!curve.removed_with_it.empty())
    remarks.push_back(fmt::format("{} that the same stage takes out let{} go to the same share.",
                                  curve.removed_with_it.size() == 1
                                      ? "Another block"
                                      : fmt::format("{} other blocks", curve.removed_with_it.size()),
                                  curve.removed_with_it.size() == 1 ? "s" : ""));
  if (!curve.left_out.empty())
    remarks.push_back(
        fmt::format("Left out, as support that comes with the opening or later: {}.", fmt::join(curve.left_out, ", ")));
  return remarks;
}

std::string reaction_text(const ReactionCurve& curve, const std::string& opening, const Model& model) {
  std::string text = fmt::format("opening \"{}\": wall of {:.4g} m, in situ under a mean pressure of {:.4g} MPa\n",
                                 opening, curve.wall.length, 1e-6 * curve.pressure);
  text += fmt::format("{:>6} {:>13} {:>10}", "share", "pressure/MPa", "mean/mm");
  for (const std::string_view place : wall_place_names) text += fmt::format(" {:>10}", fmt::format("{}/mm", place));
  text += "\n";
  const double round_off = round_off_in(curve);
  for (const ReactionPoint& point : curve.points) text += table_row(point, curve.pressure, round_off);
  for (const std::string& remark : remarks_on(curve, model)) text += remark + "\n";
  return text;
}

std::string reaction_json(const ReactionCurve& curve, const std::string& opening, const Model& model) {
  const auto failure = failure_of(curve);
  Json json{{"opening", opening},
            {"wall_length", curve.wall.length},
            {"centroid", {curve.wall.centroid.x(), curve.wall.centroid.y()}},
            {"pressure", curve.pressure},
            {"settles_down_to", number_or_null(least_share(curve))},
            {"fails_at", failure ? Json(failure->share) : Json()},
            {"remarks", remarks_on(curve, model)},
            {"left_out", curve.left_out},
            {"removed_with_it", names_of(curve.removed_with_it, model)},
            {"loose_in_situ", loose_json(curve.loose_in_situ, model)},
            {"loose_at_full_share", loose_json(curve.loose_at_full_share, model)},
            {"points", Json::array()}};
  for (const ReactionPoint& point : curve.points) json["points"].push_back(point_json(point, curve.pressure, model));
  return json.dump(1) + "\n";
}

std::string reaction_csv(const ReactionCurve& curve) {
  std::string table = "share,pressure [Pa],mean [m]";
  for (const std::string_view place : wall_place_names) table += fmt::format(",{} [m]", place);
  table += ",largest [m]\n";
  for (const ReactionPoint& point : curve.points) {
    if (!point.settles()) continue;
    table += fmt::format("{},{},{}", point.share, point.share * curve.pressure, point.motion.mean);
    for (const double place : point.motion.places) table += std::isnan(place) ? "," : fmt::format(",{}", place);
    table += fmt::format(",{}\n", point.motion.largest);
  }
  return table;
}

}  // namespace dda
