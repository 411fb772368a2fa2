// For the tests: reads .pvd and .vtp files back, independent of the writer.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "engine/core/read_file.h"
#include "engine/geometry/polygon.h"

namespace dda {

struct Element {
  std::string name;
  std::string parents;  // "VTKFile/PolyData/..."
  std::map<std::string, std::string> attributes;
};

inline std::string unescaped(const std::string& text) {
  static const std::map<std::string, char> entities = {{"amp", '&'}, {"lt", '<'}, {"gt", '>'}, {"quot", '"'}};
  std::string plain;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '<') throw std::runtime_error("bare < in an attribute");
    if (text[at] != '&') {
      plain += text[at];
      continue;
    }
    const std::size_t end = text.find(';', at);
    if (end == std::string::npos) throw std::runtime_error("bare & in an attribute");
    plain += entities.at(text.substr(at + 1, end - at - 1));
    at = end;
  }
  return plain;
}

// The elements of a text in order; throws std::runtime_error when tags do not match or attributes are not quoted.
class XmlReader {
 public:
  explicit XmlReader(std::string text) : text_(std::move(text)) {
    for (std::size_t start; (start = text_.find('<', end_)) != std::string::npos;) {
      end_ = text_.find('>', start);
      need(end_ != std::string::npos, "tag without end");
      read_tag(text_.substr(start + 1, end_ - start - 1));
    }
    need(open_.empty(), "element left open");
  }
  std::vector<Element> elements;

 private:
  static void need(bool condition, const char* problem) {
    if (!condition) throw std::runtime_error(problem);
  }

  void read_tag(std::string tag) {
    if (tag.starts_with('/')) {
      need(!open_.empty() && open_.back() == tag.substr(1), "tags do not match");
      open_.pop_back();
      return;
    }
    const bool closed = tag.ends_with('/');
    if (closed) tag.pop_back();
    const Element element = parse(tag);
    elements.push_back(element);
    if (!closed) open_.push_back(element.name);
  }

  Element parse(const std::string& tag) const {
    Element element;
    std::size_t at = tag.find(' ');
    element.name = tag.substr(0, at);
    for (const std::string& parent : open_) element.parents += parent + "/";
    while (at < tag.size()) {
      const std::size_t equals = tag.find("=\"", at);
      need(equals != std::string::npos, "attribute without value");
      const std::size_t quote = tag.find('"', equals + 2);
      need(quote != std::string::npos, "attribute without end");
      const std::string name = tag.substr(at + 1, equals - at - 1);
      need(!element.attributes.contains(name), "attribute twice");
      element.attributes[name] = unescaped(tag.substr(equals + 2, quote - equals - 2));
      at = quote + 1;
    }
    return element;
  }

  std::string text_;
  std::size_t end_ = 0;
  std::vector<std::string> open_;
};

// A .vtp file with raw appended data; throws std::runtime_error or std::out_of_range for one that is not right.
class VtpReader {
 public:
  explicit VtpReader(const std::filesystem::path& path) {
    std::string text = read_file(path);
    const std::string begin = "<AppendedData encoding=\"raw\">\n_";
    const std::size_t split = text.find(begin) + begin.size();
    data_ = text.substr(split);
    const XmlReader xml(text.substr(0, split) + "</AppendedData></VTKFile>");
    for (const Element& element : xml.elements) {
      if (element.name == "VTKFile") file_ = element;
      if (element.name == "Piece") piece_ = element;
      if (element.name == "DataArray") add_array(element);
    }
  }

  // By section and name, e.g. "CellData/block"; a number of any type fits into a double here.
  const std::vector<double>& array(const std::string& name) const { return arrays_.at(name); }
  const std::vector<double>& cell(const std::string& name) const { return array("CellData/" + name); }
  const std::vector<double>& point(const std::string& name) const { return array("PointData/" + name); }
  // The texts of an array of texts.
  const std::vector<std::string>& texts(const std::string& name) const { return texts_.at(name); }
  std::size_t components(const std::string& name) const { return components_.at(name); }
  const Element& file() const { return file_; }
  std::size_t count(const std::string& what) const { return std::stoul(piece_.attributes.at(what)); }
  std::size_t appended_bytes_read() const { return read_; }
  std::string tail() const { return data_.substr(read_); }

  // The points of a cell of "Lines" or "Polys".
  std::vector<Vec2> corners(const std::string& kind, std::size_t cell) const {
    const auto first = static_cast<std::size_t>(cell == 0 ? 0 : array(kind + "/offsets")[cell - 1]);
    const auto last = static_cast<std::size_t>(array(kind + "/offsets")[cell]);
    std::vector<Vec2> corners;
    for (std::size_t i = first; i < last; ++i) {
      const auto point = static_cast<std::size_t>(array(kind + "/connectivity").at(i));
      corners.emplace_back(array("Points/Points").at(3 * point), array("Points/Points").at(3 * point + 1));
    }
    return corners;
  }

  // The block of a polygon; cell data begin with those of the lines.
  std::size_t block_of_polygon(std::size_t polygon) const {
    return static_cast<std::size_t>(cell("block").at(count("NumberOfLines") + polygon));
  }

  // By the number of each block.
  std::map<int, double> block_areas() const {
    std::map<int, double> areas;
    for (std::size_t i = 0; i < count("NumberOfPolys"); ++i) {
      const double area = signed_area(corners("Polys", i));
      EXPECT_GT(area, 0);
      areas[static_cast<int>(block_of_polygon(i))] += area;
    }
    return areas;
  }

 private:
  void add_array(const Element& element) {
    const auto& attributes = element.attributes;
    if (attributes.at("format") != "appended") throw std::runtime_error("format");
    const std::size_t offset = std::stoul(attributes.at("offset"));
    if (offset != read_) throw std::runtime_error("arrays overlap or leave gaps");
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, data_.substr(offset, sizeof bytes).c_str(), sizeof bytes);
    const std::string raw = data_.substr(offset + sizeof bytes, bytes);
    if (raw.size() != bytes) throw std::runtime_error("array is cut off");
    read_ = offset + sizeof bytes + bytes;

    const std::string parent = element.parents.substr(0, element.parents.size() - 1);
    const std::string name = parent.substr(parent.rfind('/') + 1) + "/" + attributes.at("Name");
    components_[name] = std::stoul(attributes.at("NumberOfComponents"));
    if (attributes.at("type") == "String")
      texts_[name] = texts_of(raw);
    else
      arrays_[name] = numbers(raw, attributes.at("type"));
  }

  static std::vector<std::string> texts_of(const std::string& raw) {
    if (!raw.empty() && raw.back() != '\0') throw std::runtime_error("text without end");
    std::vector<std::string> result;
    for (std::size_t at = 0; at < raw.size(); at += result.back().size() + 1) result.emplace_back(raw.c_str() + at);
    return result;
  }

  static std::vector<double> numbers(const std::string& raw, const std::string& type) {
    if (type == "Float64") return numbers_of<double>(raw);
    if (type == "Int32") return numbers_of<std::int32_t>(raw);
    if (type == "Int64") return numbers_of<std::int64_t>(raw);
    throw std::runtime_error("type " + type);
  }

  template <typename Number>
  static std::vector<double> numbers_of(const std::string& raw) {
    std::vector<double> result;
    for (std::size_t i = 0; i + sizeof(Number) <= raw.size(); i += sizeof(Number)) {
      Number number;
      std::memcpy(&number, raw.data() + i, sizeof number);
      result.push_back(static_cast<double>(number));
    }
    return result;
  }

  std::string data_;
  std::size_t read_ = 0;
  Element file_;
  Element piece_;
  std::map<std::string, std::vector<double>> arrays_;
  std::map<std::string, std::vector<std::string>> texts_;
  std::map<std::string, std::size_t> components_;
};

}  // namespace dda
