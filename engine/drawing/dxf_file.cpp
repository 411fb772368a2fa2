#include "engine/drawing/dxf_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "engine/core/error.h"
#include "engine/drawing/dxf_names.h"
#include "engine/drawing/line_drawing.h"
#include "engine/drawing/number_text.h"

namespace dda {
namespace {

constexpr int entity_type = 0;
constexpr int name_code = 2;
constexpr int variable_code = 9;

class Parser {
 public:
  Parser(std::string_view text, const std::string& name) : groups_(text, name) {}

  DxfFile parse() {
    for (group_ = groups_.next(); !is(entity_type, "EOF");) section();
    return std::move(file_);
  }

 private:
  [[nodiscard]] bool is(int code, std::string_view value) const { return group_.code == code && group_.value == value; }

  void step() { group_ = groups_.next(); }

  void section() {
    if (!is(entity_type, "SECTION"))
      groups_.fail(group_, fmt::format("\"{}\" outside of a section", readable(group_.value.substr(0, 40))),
                   "SECTION or EOF of a DXF file");
    step();
    const std::string_view name = group_.code == name_code ? group_.value : "";
    step();
    while (!is(entity_type, "ENDSEC")) {
      if (is(entity_type, "EOF")) groups_.fail(group_, "EOF inside of a section", "ENDSEC before it");
      if (name == "HEADER")
        header_variable();
      else if (name == "BLOCKS" && is(entity_type, "BLOCK"))
        block();
      else if (name == "ENTITIES" && group_.code == entity_type)
        file_.entities.push_back(entity());
      else
        step();
    }
    step();
  }

  void header_variable() {
    const bool unit = is(variable_code, "$INSUNITS");
    step();
    if (!unit || group_.code != 70) return;
    const auto value = number_in<int>(group_.value);
    if (!value) groups_.fail(group_, "no number for $INSUNITS", "a whole number");
    file_.unit = *value;
  }

  // Reads up to the next group 0, which begins the next entity.
  DxfEntity entity() {
    DxfEntity entity(group_.value, groups_.place(group_.line));
    for (step(); group_.code != entity_type; step()) entity.add(group_);
    return entity;
  }

  void block() {
    const DxfEntity head = entity();
    DxfBlock block;
    block.base = head.point(10);
    while (!is(entity_type, "ENDBLK")) {
      if (is(entity_type, "ENDSEC") || is(entity_type, "EOF"))
        groups_.fail(group_, fmt::format("{} inside of a block", group_.value), "ENDBLK before it");
      block.entities.push_back(entity());
    }
    step();
    file_.blocks.insert_or_assign(head.text(name_code), std::move(block));
  }

  DxfGroups groups_;
  DxfGroup group_;
  DxfFile file_;
};

}  // namespace

const DxfGroup* DxfEntity::find(int code) const {
  const auto found = std::ranges::find(groups_, code, &DxfGroup::code);
  return found == groups_.end() ? nullptr : &*found;
}

std::string DxfEntity::text(int code, std::string_view otherwise) const {
  const DxfGroup* group = find(code);
  return readable(group == nullptr ? otherwise : group->value);
}

std::string DxfEntity::extended(const std::string& key) const {
  constexpr int application = 1001;
  constexpr int string = 1000;
  bool ours = false;
  for (const DxfGroup& group : groups_) {
    if (group.code == application) ours = group.value == dxf_application;
    if (ours && group.code == string && group.value.starts_with(key))
      return readable(dxf_unescaped(group.value.substr(key.size())));
  }
  return "";
}

double DxfEntity::number_of(const DxfGroup& group) const {
  const auto number = number_in<double>(group.value);
  if (!number)
    throw InputError("", origin_ + fmt::format(" ({}), group {} in line {}", readable(type_), group.code, group.line),
                     "\"" + readable(group.value.substr(0, 40)) + "\"", "a finite number");
  return *number;
}

double DxfEntity::number(int code, double otherwise) const {
  const DxfGroup* group = find(code);
  return group == nullptr ? otherwise : number_of(*group);
}

int DxfEntity::whole(int code, int otherwise) const {
  constexpr double most = 1e9;
  const double value = number(code, otherwise);
  if (value != std::floor(value) || std::abs(value) > most)
    throw InputError("", origin_ + fmt::format(" ({}), group {}", readable(type_), code), fmt::format("{}", value),
                     "a whole number");
  return static_cast<int>(value);
}

Vec2 DxfEntity::point(int x_code) const { return {number(x_code), number(x_code + 10)}; }

double DxfEntity::needed_number(int code) const {
  if (find(code) == nullptr)
    throw InputError("", fmt::format("{} ({})", origin_, readable(type_)), fmt::format("without group {}", code),
                     "all coordinates, radii and angles that its type has");
  return number(code);
}

Vec2 DxfEntity::needed_point(int x_code) const { return {needed_number(x_code), needed_number(x_code + 10)}; }

std::vector<double> DxfEntity::numbers(int code) const {
  std::vector<double> values;
  for (const DxfGroup& group : groups_) {
    if (group.code == code) values.push_back(number_of(group));
  }
  return values;
}

DxfFile parse_dxf(std::string_view text, const std::string& name) { return Parser(text, name).parse(); }

}  // namespace dda
