#include "engine/record/contact_frame_writer.h"

#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace dda {
namespace {

template <typename Value>
std::vector<double> vectors(std::span<const ContactPoint> contacts, const Value& value) {
  std::vector<double> values;
  values.reserve(3 * contacts.size());
  for (const ContactPoint& contact : contacts) {
    const Vec2 vector = value(contact);
    values.insert(values.end(), {vector.x(), vector.y(), 0});
  }
  return values;
}

}  // namespace

ContactFrameWriter::ContactFrameWriter(std::filesystem::path index) : series_(std::move(index)) {}

void ContactFrameWriter::write(double time, std::span<const ContactPoint> contacts) {
  PolyData data;
  data.time = time;
  data.points = vectors(contacts, [](const ContactPoint& contact) { return contact.point; });
  if (!contacts.empty()) {
    data.vertices.connectivity.resize(contacts.size());
    std::iota(data.vertices.connectivity.begin(), data.vertices.connectivity.end(), 0);
    data.vertices.offsets = {static_cast<std::int64_t>(contacts.size())};
  }
  data.point_data = {
      numbers_of<std::int32_t>("block_a", contacts, [](const ContactPoint& contact) { return contact.block_a; }),
      numbers_of<std::int32_t>("block_b", contacts, [](const ContactPoint& contact) { return contact.block_b; }),
      numbers_of<std::int32_t>("status", contacts, [](const ContactPoint& contact) { return contact.status; }),
      {"force [N/m]", 3, vectors(contacts, [](const ContactPoint& contact) { return contact.force(); })},
      numbers_of<double>("normal_force [N/m]", contacts,
                         [](const ContactPoint& contact) { return contact.normal_force; }),
      numbers_of<double>("shear_force [N/m]", contacts,
                         [](const ContactPoint& contact) { return contact.shear_force; }),
      {"displacement [m]", 3,
       vectors(contacts, [](const ContactPoint& contact) -> Vec2 { return contact.point - contact.reference; })},
  };
  series_.add(data);
}

}  // namespace dda
