#include "engine/view/packing.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <map>

#include "engine/view/colour_scale.h"

namespace dda {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint16_t no_number = 65535;
constexpr double greatest_code = 65534;
constexpr double greatest_force = 32767;
constexpr double drawn_share = 0.99;  // of the forces are drawn no thicker than the thickest line

// In little-endian order, whatever this machine has.
template <typename Integer>
void append(std::string& bytes, Integer value) {
  for (std::size_t i = 0; i < sizeof value; ++i)
    bytes += static_cast<char>(static_cast<std::uint8_t>(static_cast<std::uint64_t>(value) >> (8 * i)));
}

Json ranges_of(const PackedField& field) {
  Json ranges = Json::array();
  for (const CodeRange& range : field.ranges) ranges.push_back({range.low, range.high});
  return ranges;
}

Json scale_json(const std::vector<double>& values) {
  const ColourScale scale = scale_of(values);
  return {{"low", scale.low},           {"high", scale.high},   {"diverging", scale.diverging},
          {"dark_low", scale.dark_low}, {"least", scale.least}, {"most", scale.most}};
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, values.begin() + place);
  return values[static_cast<std::size_t>(place)];
}

std::size_t group_of(const DrawnContact& contact) {
  switch (contact.status) {
    case DrawnStatus::locked: return contact.tension ? 1 : 0;
    case DrawnStatus::sliding: return 2;
    case DrawnStatus::open: break;
  }
  return 3;
}

std::string packed(const std::vector<std::uint32_t>& numbers, bool wide) {
  std::string bytes;
  for (const std::uint32_t number : numbers) {
    if (wide)
      append(bytes, number);
    else
      append(bytes, static_cast<std::uint16_t>(number));
  }
  return bytes;
}

template <typename Value>
std::vector<double> collected(std::size_t count, const Value& value) {
  std::vector<double> values;
  values.reserve(count);
  for (std::size_t i = 0; i < count; ++i) values.push_back(value(i));
  return values;
}

}  // namespace

CodeRange append_codes(std::span<const double> values, std::string& bytes) {
  CodeRange range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    range.low = std::min(range.low, value);
    range.high = std::max(range.high, value);
  }
  if (range.low > range.high) range = {};
  const double width = range.high - range.low;
  for (const double value : values) {
    const double share = width > 0 ? (value - range.low) / width : 0;
    append(bytes, std::isfinite(value) ? static_cast<std::uint16_t>(std::lround(greatest_code * share)) : no_number);
  }
  return range;
}

void PackedRun::add(const Frame& frame) {
  times_.push_back(frame.time);
  const std::size_t vertices = frame.displacement.size();
  displacement_x_.add(collected(vertices, [&](std::size_t i) { return frame.displacement[i].x(); }));
  displacement_y_.add(collected(vertices, [&](std::size_t i) { return frame.displacement[i].y(); }));
  for (std::size_t q = 0; q < quantities_.size(); ++q) {
    const auto values =
        collected(drawing_.blocks(), [&](std::size_t i) { return drawn_quantities[q].value(frame, i); });
    quantities_[q].add(values);
    values_[q].insert(values_[q].end(), values.begin(), values.end());
  }
  add_contacts(frame.contacts);
  if (!frame.bolts.empty()) add_bolts(frame.bolts);
}

void PackedRun::add_bolts(const std::vector<DrawnBolt>& bolts) {
  const bool first = bolts_.names.empty();
  std::vector<double> x, y, forces, shares;
  for (const DrawnBolt& bolt : bolts) {
    if (first) {
      bolts_.names.push_back(bolt.name);
      bolts_.reference.insert(bolts_.reference.end(), bolt.reference.begin(), bolt.reference.end());
      bolts_.begin.push_back(static_cast<std::uint32_t>(bolts_.reference.size()));
    }
    for (const Vec2& moved : bolt.displacement) {
      x.push_back(moved.x());
      y.push_back(moved.y());
    }
    forces.push_back(bolt.force);
    shares.push_back(bolt.utilisation);
    bolts_.has_utilisation = bolts_.has_utilisation || !std::isnan(bolt.utilisation);
    bolts_.conditions += static_cast<char>(bolt.condition);
    if (std::isfinite(bolt.force)) bolts_.most_force = std::max(bolts_.most_force, std::abs(bolt.force));
  }
  bolts_.x.add(x);
  bolts_.y.add(y);
  bolts_.force.add(forces);
  bolts_.utilisation.add(shares);
}

void PackedRun::add_contacts(const std::vector<DrawnContact>& contacts) {
  double most = 0;
  for (const DrawnContact& contact : contacts) {
    if (contact.force.allFinite()) most = std::max(most, contact.force.lpNorm<Eigen::Infinity>());
  }
  note_sizes(contacts);
  const double unit = most > 0 ? most / greatest_force : 1;
  force_units_.push_back(unit);
  std::array<std::uint32_t, 4> counts{};
  for (std::size_t group = 0; group < counts.size(); ++group) {
    for (const DrawnContact& contact : contacts) {
      if (group_of(contact) != group) continue;
      ++counts[group];
      contact_sites_.push_back(sites_.number_of(contact));
      if (group == 3) continue;  // open: no force
      for (const double component : {contact.force.x(), contact.force.y()})
        append(contact_forces_,
               static_cast<std::int16_t>(std::isfinite(component) ? std::lround(component / unit) : 0));
    }
  }
  contact_counts_.push_back(counts);
}

void PackedRun::note_sizes(const std::vector<DrawnContact>& contacts) {
  std::map<std::pair<int, int>, Vec2> joints;
  for (const DrawnContact& contact : contacts) {
    if (!contact.force.allFinite() || contact.force.norm() == 0) continue;
    contact_sizes_.push_back(contact.force.norm());
    const auto [joint, is_new] = joints.try_emplace(std::minmax(contact.block_a, contact.block_b), Vec2(0, 0));
    joint->second += contact.block_a < contact.block_b ? contact.force : Vec2(-contact.force);
  }
  for (const auto& [blocks, force] : joints) joint_sizes_.push_back(force.norm());
}

std::size_t PackedRun::size() const {
  std::size_t bytes = displacement_x_.bytes.size() + displacement_y_.bytes.size() + contact_forces_.size();
  for (const PackedField& field : quantities_) bytes += field.bytes.size();
  bytes += contact_sites_.size() * (wide_sites() ? 4 : 2) + sites_.sites().size() * sizeof(ContactSite);
  bytes += (drawing_.reference.size() + bolts_.reference.size()) * 2 * sizeof(float);
  bytes += bolts_.x.bytes.size() + bolts_.y.bytes.size() + bolts_.force.bytes.size() + bolts_.conditions.size();
  if (bolts_.has_utilisation) bytes += bolts_.utilisation.bytes.size();
  return bytes * 4 / 3;
}

Json PackedRun::header() const {
  Json quantities = Json::array();
  for (std::size_t q = 0; q < quantities_.size(); ++q) {
    const DrawnQuantity& quantity = drawn_quantities[q];
    quantities.push_back({{"id", quantity.id},
                          {"title", quantity.title},
                          {"unit", quantity.unit},
                          {"ranges", ranges_of(quantities_[q])},
                          {"scale", scale_json(values_[q])}});
  }
  Json contact_counts = Json::array();
  for (const auto& [locked, pulled, sliding, open] : contact_counts_)
    contact_counts.push_back({locked, pulled, sliding, open});
  const Vec2 origin = drawing_.reference.empty() ? Vec2(0, 0) : drawing_.reference[0];
  return {{"times", times_},
          {"blocks", drawing_.blocks()},
          {"block_names", drawing_.names},
          {"vertices", drawing_.reference.size()},
          {"origin", {origin.x(), origin.y()}},
          {"ring_begin", drawing_.ring_begin},
          {"block_begin", drawing_.block_begin},
          {"displacement_x", ranges_of(displacement_x_)},
          {"displacement_y", ranges_of(displacement_y_)},
          {"quantities", std::move(quantities)},
          {"contact_counts", std::move(contact_counts)},
          {"force_units", force_units_},
          {"thickest_force",
           {{"none", 0},
            {"contacts", quantile(contact_sizes_, drawn_share)},
            {"joints", quantile(joint_sizes_, drawn_share)}}},
          {"wide_sites", wide_sites()},
          {"bolts", bolt_header()}};
}

// null where there are none.
Json PackedRun::bolt_header() const {
  if (bolts_.names.empty()) return nullptr;
  return {{"names", bolts_.names},
          {"begin", bolts_.begin},
          {"x", ranges_of(bolts_.x)},
          {"y", ranges_of(bolts_.y)},
          {"force", ranges_of(bolts_.force)},
          {"utilisation", bolts_.has_utilisation ? ranges_of(bolts_.utilisation) : Json()},
          {"most_force", bolts_.most_force}};
}

// From the origin, as floats.
std::string PackedRun::packed_points(const std::vector<Vec2>& points) const {
  std::string bytes;
  for (const Vec2& point : points)
    for (const double offset : {point.x() - drawing_.reference[0].x(), point.y() - drawing_.reference[0].y()})
      append(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(offset)));
  return bytes;
}

std::vector<std::pair<std::string, std::string>> PackedRun::sections() const {
  std::string sites;
  for (const ContactSite& site : sites_.sites())
    for (const std::uint32_t number : {site.block_a, site.block_b, site.from, site.to, site.fraction})
      append(sites, number);
  std::vector<std::pair<std::string, std::string>> sections = {{"reference", packed_points(drawing_.reference)},
                                                               {"displacement-x", displacement_x_.bytes},
                                                               {"displacement-y", displacement_y_.bytes},
                                                               {"sites", std::move(sites)},
                                                               {"contact-sites", packed(contact_sites_, wide_sites())},
                                                               {"contact-forces", contact_forces_}};
  if (!bolts_.names.empty()) {
    sections.emplace_back("bolt-reference", packed_points(bolts_.reference));
    sections.emplace_back("bolt-x", bolts_.x.bytes);
    sections.emplace_back("bolt-y", bolts_.y.bytes);
    sections.emplace_back("bolt-force", bolts_.force.bytes);
    sections.emplace_back("bolt-condition", bolts_.conditions);
    if (bolts_.has_utilisation) sections.emplace_back("bolt-utilisation", bolts_.utilisation.bytes);
  }
  for (std::size_t q = 0; q < quantities_.size(); ++q)
    sections.emplace_back("quantity-" + std::string(drawn_quantities[q].id), quantities_[q].bytes);
  return sections;
}

}  // namespace dda
