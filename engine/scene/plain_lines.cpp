#include "engine/scene/plain_lines.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "engine/scene/json_path.h"

namespace dda {
namespace {

constexpr std::size_t longest_plain_name = 100;  // bytes; the schema allows as many characters

}  // namespace

std::span<const Vec2> PlainLines::points(std::size_t line) const {
  const std::size_t begin = line == 0 ? 0 : lines_[line - 1].end;
  return std::span(points_).subspan(begin, lines_[line].end - begin);
}

std::vector<Field> PlainLines::joints() const {
  std::vector<Field> users;
  for (const Joint& joint : joints_) users.emplace_back(joint.entry, item_path(path_, joint.line));
  return users;
}

nlohmann::json PlainLines::first_entry() const {
  nlohmann::json entry = joints_.front().entry;
  for (const Vec2& point : points(0)) entry["points"].push_back({point.x(), point.y()});
  return entry;
}

void PlainLines::end_line(const std::string& joint) {
  const auto [number, is_new] = numbers_.try_emplace(joint, joints_.size());
  if (is_new) joints_.push_back({{{"joint", joint}}, lines_.size()});
  lines_.push_back({points_.size(), number->second});
}

const PlainLines* lines_at(const std::string& path, const std::vector<PlainLines>& all) {
  const auto found = std::ranges::find(all, path, &PlainLines::path);
  return found == all.end() ? nullptr : &*found;
}

bool PlainLinesBuilder::go_from(Place from, Place to) {
  const bool is_there = place_ == from;
  place_ = to;
  return is_there;
}

bool PlainLinesBuilder::start_object() {
  has_points_ = false;
  joint_.clear();
  return go_from(Place::list, Place::line);
}

bool PlainLinesBuilder::key(const std::string& key) {
  if (key == "points" && !has_points_) return go_from(Place::line, Place::before_points);
  return key == "joint" && joint_.empty() && go_from(Place::line, Place::before_joint);
}

bool PlainLinesBuilder::start_array() {
  if (place_ == Place::before_points) {
    point_count_ = 0;
    return go_from(Place::before_points, Place::points);
  }
  coordinates_ = 0;
  return go_from(Place::points, Place::point);
}

bool PlainLinesBuilder::number(double value) {
  if (place_ != Place::point || coordinates_ == 2) return false;
  point_(static_cast<Eigen::Index>(coordinates_++)) = value;
  return true;
}

bool PlainLinesBuilder::string(const std::string& value) {
  joint_ = value;
  return !value.empty() && value.size() <= longest_plain_name && go_from(Place::before_joint, Place::line);
}

bool PlainLinesBuilder::end_array() {
  if (place_ == Place::points) {
    has_points_ = true;
    return point_count_ >= 2 && go_from(Place::points, Place::line);
  }
  ++point_count_;
  lines_.add_point(point_);
  return coordinates_ == 2 && go_from(Place::point, Place::points);
}

bool PlainLinesBuilder::end_object() {
  if (!has_points_ || joint_.empty()) return false;
  lines_.end_line(joint_);
  return go_from(Place::line, Place::list);
}

}  // namespace dda
