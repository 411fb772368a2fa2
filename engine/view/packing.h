// A run as the page carries it: integers of 16 bits between the least and the greatest value of each frame (a part in
// 65534 of the range), little-endian, and a header in JSON that says what they mean. README.md lists the sections.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/view/contact_sites.h"
#include "engine/view/quantities.h"
#include "engine/view/run_results.h"

namespace dda {

// Value = low + (high - low) * code/65534; the code 65535 is no number.
struct CodeRange {
  double low = 0;
  double high = 0;
};

// Appends a code for every value; returns the range of those that are numbers.
CodeRange append_codes(std::span<const double> values, std::string& bytes);

// Codes of one field, frame after frame.
struct PackedField {
  std::string bytes;
  std::vector<CodeRange> ranges;

  void add(std::span<const double> values) { ranges.push_back(append_codes(values, bytes)); }
};

class PackedRun {
 public:
  explicit PackedRun(const Drawing& drawing) : drawing_(drawing), sites_(drawing), quantities_(drawn_quantity_count) {}

  void add(const Frame& frame);

  // Bytes of all sections so far, as text in the page.
  [[nodiscard]] std::size_t size() const;

  // What the sections mean; to be completed with what the page says of the run.
  [[nodiscard]] nlohmann::ordered_json header() const;

  // Name and bytes.
  [[nodiscard]] std::vector<std::pair<std::string, std::string>> sections() const;

 private:
  struct Bolts {
    std::vector<std::string> names;       // of each link
    std::vector<std::uint32_t> begin{0};  // link i has the points begin[i] to begin[i + 1]
    std::vector<Vec2> reference;          // m
    PackedField x, y, force, utilisation;
    bool has_utilisation = false;
    std::string conditions;  // a byte for each link, frame by frame
    double most_force = 0;   // N
  };

  void add_contacts(const std::vector<DrawnContact>& contacts);
  void add_bolts(const std::vector<DrawnBolt>& bolts);
  [[nodiscard]] nlohmann::ordered_json bolt_header() const;
  [[nodiscard]] std::string packed_points(const std::vector<Vec2>& points) const;
  void note_sizes(const std::vector<DrawnContact>& contacts);
  [[nodiscard]] bool wide_sites() const { return sites_.sites().size() > std::numeric_limits<std::uint16_t>::max(); }

  const Drawing& drawing_;
  ContactSites sites_;
  std::vector<double> times_;
  PackedField displacement_x_, displacement_y_;
  std::vector<PackedField> quantities_;
  std::vector<std::vector<double>> values_ = std::vector<std::vector<double>>(drawn_quantity_count);  // all frames
  std::vector<std::array<std::uint32_t, 4>> contact_counts_;  // locked, locked in tension, sliding, open
  std::vector<std::uint32_t> contact_sites_;
  std::string contact_forces_;
  std::vector<double> force_units_;                  // N/m, of each frame
  std::vector<double> contact_sizes_, joint_sizes_;  // N/m, sizes of all forces and of all resultants
  Bolts bolts_;
};

}  // namespace dda
