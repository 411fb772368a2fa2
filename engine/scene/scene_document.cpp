#include "engine/scene/scene_document.h"

#include <string>
#include <utility>

#include "engine/core/error.h"
#include "engine/scene/json_text.h"
#include "engine/scene/json_tracker.h"
#include "engine/scene/schema_check.h"

namespace dda {
namespace {

using nlohmann::json;

// blocks.rock.lines, blocks[3].rock.lines
bool is_place_of_lines(std::string_view path) {
  constexpr std::string_view first = "blocks", last = ".rock.lines";
  if (!path.starts_with(first) || !path.ends_with(last)) return false;
  const std::string_view entry = path.substr(first.size(), path.size() - first.size() - last.size());
  return entry.empty() || (entry.front() == '[' && entry.find_first_not_of("0123456789", 1) == entry.size() - 1);
}

// Lets the document be made, but for lines of rock. The library calls these functions; one that returns false ends it.
class LineWatcher {
 public:
  explicit LineWatcher(json& document) : tracker_(document) {}

  bool null() { return !builder_ && tracker_.null(); }
  bool boolean(bool value) { return !builder_ && tracker_.boolean(value); }
  bool number_integer(json::number_integer_t value) {
    return builder_ ? builder_->number(static_cast<double>(value)) : tracker_.number_integer(value);
  }
  bool number_unsigned(json::number_unsigned_t value) {
    return builder_ ? builder_->number(static_cast<double>(value)) : tracker_.number_unsigned(value);
  }
  bool number_float(json::number_float_t value, const std::string& text) {
    return builder_ ? builder_->number(value) : tracker_.number_float(value, text);
  }
  bool string(std::string& value) { return builder_ ? builder_->string(value) : tracker_.string(value); }
  bool binary(json::binary_t& value) { return !builder_ && tracker_.binary(value); }
  bool start_object(std::size_t size) { return builder_ ? builder_->start_object() : tracker_.start_object(size); }
  bool end_object() { return builder_ ? builder_->end_object() : tracker_.end_object(); }

  bool key(std::string& key) {
    if (builder_) return builder_->key(key);
    if (!tracker_.key(key)) return false;
    is_at_lines_ = key == "lines";
    return true;
  }

  bool start_array(std::size_t size) {
    if (builder_) return builder_->start_array();
    if (std::exchange(is_at_lines_, false) && is_place_of_lines(tracker_.path())) builder_.emplace(tracker_.path());
    return tracker_.start_array(size);
  }

  bool end_array() {
    if (!builder_) return tracker_.end_array();
    if (!builder_->is_between_lines()) return builder_->end_array();
    lines_.push_back(builder_->take());
    builder_.reset();
    return tracker_.end_array();
  }

  template <typename Error>
  bool parse_error(std::size_t /*byte*/, const std::string& /*token*/, const Error& /*error*/) {
    return false;
  }

  [[nodiscard]] std::vector<PlainLines> take_lines() { return std::move(lines_); }

 private:
  JsonTracker tracker_;
  bool is_at_lines_ = false;                  // where these may begin
  std::optional<PlainLinesBuilder> builder_;  // within lines
  std::vector<PlainLines> lines_;
};

json& lines_of(const PlainLines& lines, json& document) {
  json& blocks = document["blocks"];
  if (!blocks.is_array()) return blocks["rock"]["lines"];
  constexpr std::size_t digits_from = std::string_view("blocks[").size();
  return blocks[std::stoul(lines.path().substr(digits_from))]["rock"]["lines"];
}

}  // namespace

std::optional<SceneDocument> document_without_lines(std::string_view text) {
  SceneDocument scene;
  LineWatcher watcher(scene.document);
  try {
    if (!json::sax_parse(text, &watcher)) return std::nullopt;
    scene.lines = watcher.take_lines();
    std::erase_if(scene.lines, [](const PlainLines& lines) { return lines.size() == 0; });
    for (const PlainLines& lines : scene.lines) lines_of(lines, scene.document).push_back(lines.first_entry());
    check_schema(scene.document);
  } catch (const InputError&) {
    return std::nullopt;
  }
  return scene;
}

// What is wrong is said of the whole document.
SceneDocument read_scene_document(std::string_view text) {
  constexpr std::size_t large = 1'000'000;  // bytes; the lines of smaller ones are soon read in the document, too
  if (text.size() > large)
    if (auto scene = document_without_lines(text)) return std::move(*scene);
  SceneDocument scene{parse_json(text), {}};
  check_schema_of_many(scene.document);
  return scene;
}

}  // namespace dda
