#include "verification/chapters/jointed_rock.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace verify {

using Json = SceneFolder::Scene;

Json joint_set(const std::string& name, const JointSet& set, double spacing) {
  const double angle = set.dip * std::numbers::pi / 180;
  const double shift = set.shift * spacing;
  return {{"name", name},
          {"dip", fmt::format("{:g} deg", set.dip)},
          {"spacing", spacing},
          {"start", {-shift * std::sin(angle), shift * std::cos(angle)}},
          {"joint", "default"}};
}

Json octagon_around(double x) {
  constexpr double far = octagon_half_width, near = 0.5;
  const std::array<std::pair<double, double>, 8> corners{
      {{far, near}, {near, far}, {-near, far}, {-far, near}, {-far, -near}, {-near, -far}, {near, -far}, {far, -near}}};
  Json polygon = Json::array();
  for (const auto& [right, up] : corners) polygon.push_back({x + right, up});
  return polygon;
}

Json held_while_settling(bool sides_held) {
  Json list = {{{"edge", "bottom"}, {"hold", sides_held ? "normal" : "xy"}, {"until_stage", "settle"}}};
  if (!sides_held) return list;
  for (const char* edge : {"left", "right"})
    list.push_back({{"edge", edge}, {"hold", "normal"}, {"until_stage", "settle"}});
  return list;
}

void measure_motion(Json& list, const std::string& prefix, const Json& where) {
  for (const char* quantity : {"displacement", "velocity", "acceleration"})
    for (const char* axis : {"x", "y"}) {
      Json entry = {{"name", fmt::format("{}_{}_{}", prefix, quantity, axis)},
                    {"quantity", fmt::format("{}_{}", quantity, axis)}};
      entry.update(where);
      list.push_back(std::move(entry));
    }
}

void measure_stress(Json& list, const std::string& prefix, const dda::Vec2& point) {
  for (const char* axes : {"xx", "yy"})
    list.push_back({{"name", prefix + "_" + axes},
                    {"quantity", fmt::format("stress_{}", axes)},
                    {"point", {point.x(), point.y()}}});
}

}  // namespace verify
