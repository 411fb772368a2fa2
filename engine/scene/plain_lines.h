// Lines of rock that a scene lists as {"points": [[x, y], ...], "joint": NAME}, all in numbers and without more: a
// million of them are soon read, but slow as parts of a document.
#pragma once

#include <cstddef>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "engine/core/types.h"
#include "engine/scene/field.h"

namespace dda {

// Stand for the entry "lines" of a rock.
class PlainLines {
 public:
  explicit PlainLines(std::string path) : path_(std::move(path)) {}

  [[nodiscard]] const std::string& path() const { return path_; }  // blocks.rock.lines
  [[nodiscard]] std::size_t size() const { return lines_.size(); }
  [[nodiscard]] std::span<const Vec2> points(std::size_t line) const;  // m
  // Which of `joints` the line names.
  [[nodiscard]] std::size_t joint(std::size_t line) const { return lines_[line].joint; }
  // The lines that are the first with their joint, in order, as far as they name it.
  [[nodiscard]] std::vector<Field> joints() const;
  // The first of them, as it would be in a document.
  [[nodiscard]] nlohmann::json first_entry() const;

  void add_point(const Vec2& point) { points_.push_back(point); }
  void end_line(const std::string& joint);

 private:
  struct Line {
    std::size_t end = 0;  // of its points
    std::size_t joint = 0;
  };
  struct Joint {
    nlohmann::json entry;  // {"joint": NAME}
    std::size_t line = 0;  // the first that names it
  };

  std::string path_;
  std::vector<Vec2> points_;  // of all lines
  std::vector<Line> lines_;
  std::vector<Joint> joints_;
  std::map<std::string, std::size_t> numbers_;  // of joints
};

// Those of the rock whose lines are at `path`, or nullptr.
const PlainLines* lines_at(const std::string& path, const std::vector<PlainLines>& all);

// Makes plain lines of what a parser finds in a list of them. All answer false where a line is not plain: where the
// schema would refuse it, and where more than numbers and one name is to be read of it.
class PlainLinesBuilder {
 public:
  explicit PlainLinesBuilder(std::string path) : lines_(std::move(path)) {}

  bool start_object();
  bool key(const std::string& key);
  bool start_array();
  bool number(double value);
  bool string(const std::string& value);
  bool end_array();
  bool end_object();

  [[nodiscard]] bool is_between_lines() const { return place_ == Place::list; }
  [[nodiscard]] PlainLines take() { return std::move(lines_); }

 private:
  enum class Place { list, line, before_points, points, point, before_joint };

  bool go_from(Place from, Place to);

  PlainLines lines_;
  Place place_ = Place::list;
  bool has_points_ = false;  // of the line
  std::string joint_;        // of the line; empty: not yet
  std::size_t point_count_ = 0;
  std::size_t coordinates_ = 0;  // of the point, so far
  Vec2 point_ = Vec2::Zero();
};

}  // namespace dda
