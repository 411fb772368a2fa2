#include "engine/simulation/unbalanced_block.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "engine/contact/contact_points.h"
#include "engine/core/place_in_words.h"
#include "engine/simulation/block_system.h"
#include "engine/simulation/linear_states.h"

namespace dda {
namespace {

constexpr std::size_t most_named = 3;

// Cosine between normals of contacts that lie on one face.
constexpr double same_face = 0.99;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

// Seen from `block`: block a is its neighbour, and the normal points into it.
ContactPoint seen_from(int block, ContactPoint point) {
  if (point.block_b == block) return point;
  std::swap(point.block_a, point.block_b);
  point.normal = -point.normal;
  return point;
}

// Contact points that carry a force, of each of `blocks`, in one way through all contacts.
std::vector<std::vector<ContactPoint>> points_of(const std::vector<int>& blocks, const BlockSystem& s) {
  std::vector<std::vector<ContactPoint>> found(blocks.size());
  std::vector<int> place(s.model.blocks.size(), -1);
  for (std::size_t i = 0; i < blocks.size(); ++i) place[at(blocks[i])] = static_cast<int>(i);
  std::vector<ContactPoint> points;
  InterfaceElement room;
  for (std::size_t i = 0; i < s.contacts.elements.size(); ++i) {
    const InterfaceElement& element = s.contacts.elements.read(i, room);
    if (place[at(element.block_a)] < 0 && place[at(element.block_b)] < 0) continue;
    const InterfaceState state = interface_state_now(s, i);
    points.clear();
    append_contact_points(s.model, s.state, s.contacts.interfaces[i], element, state, points);
    std::erase_if(points, [](const ContactPoint& point) { return point.force().isZero(0); });
    for (const int block : {element.block_a, element.block_b}) {
      if (place[at(block)] < 0) continue;
      for (const ContactPoint& point : points) found[at(place[at(block)])].push_back(seen_from(block, point));
    }
  }
  return found;
}

HoldingFace face_of(const std::vector<ContactPoint>& points) {
  HoldingFace face;
  face.neighbour = points.front().block_a;
  for (const ContactPoint& point : points) {
    face.place += point.point / static_cast<double>(points.size());
    face.force += point.force();
    face.slides = face.slides || point.status == ContactStatus::sliding;
  }
  return face;
}

std::vector<HoldingFace> faces_of(std::vector<ContactPoint> left) {
  std::vector<HoldingFace> faces;
  while (!left.empty()) {
    const int neighbour = left.front().block_a;
    const Vec2 normal = left.front().normal;
    const auto rest = std::stable_partition(left.begin(), left.end(), [&](const ContactPoint& point) {
      return point.block_a == neighbour && point.normal.dot(normal) > same_face;
    });
    faces.push_back(face_of({left.begin(), rest}));
    left.erase(left.begin(), rest);
  }
  return faces;
}

}  // namespace

std::vector<UnbalancedBlock> placed(const BlockSystem& system, const std::vector<int>& blocks) {
  std::vector<UnbalancedBlock> found;
  if (blocks.empty()) return found;
  std::vector<std::vector<ContactPoint>> points = points_of(blocks, system);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const Vec2 place = current_centroid(system.model, system.state, blocks[i]);
    found.push_back({static_cast<int>(system.clock.stage), blocks[i], place, faces_of(std::move(points[i]))});
  }
  return found;
}

std::vector<UnbalancedBlock> of_stage(std::size_t stage, std::vector<UnbalancedBlock> blocks) {
  std::erase_if(blocks, [stage](const UnbalancedBlock& each) { return at(each.stage) != stage; });
  return blocks;
}

std::string named_with_places(const Model& model, const std::vector<UnbalancedBlock>& blocks) {
  std::string text = blocks.size() == 1 ? "block " : "blocks ";
  for (std::size_t i = 0; i < std::min(most_named, blocks.size()); ++i)
    text += fmt::format("{}\"{}\" at {}", i == 0 ? "" : ", ", model.blocks[at(blocks[i].block)].name,
                        place_in_words(blocks[i].place));
  if (blocks.size() > most_named) text += fmt::format(" and {} more", blocks.size() - most_named);
  return text;
}

std::string described(const Model& model, const UnbalancedBlock& block) {
  std::string text =
      fmt::format("block \"{}\" (number {}) at {}, {:.4g} kg/m, held by ", model.blocks[at(block.block)].name,
                  block.block, place_in_words(block.place), model.mass_of(block.block));
  if (block.faces.empty()) return text + "no face";
  for (std::size_t i = 0; i < block.faces.size(); ++i) {
    const HoldingFace& face = block.faces[i];
    text += fmt::format("{}\"{}\" at {} with {:.3g} N/m{}", i == 0 ? "" : ", ", model.blocks[at(face.neighbour)].name,
                        place_in_words(face.place), face.force.norm(), face.slides ? " (slides)" : "");
  }
  return text;
}

}  // namespace dda
