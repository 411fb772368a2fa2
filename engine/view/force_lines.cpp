#include "engine/view/force_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "engine/geometry/segment.h"

namespace dda {
namespace {

double size_of(const Drawing& drawing, int block) {
  return std::sqrt(area_and_centroid(drawing, drawing.reference, static_cast<std::size_t>(block)).first);
}

Vec2 place_of(const DrawnContact& contact, double deformation_scale) {
  return contact.reference + deformation_scale * contact.displacement;
}

bool carries(const DrawnContact& contact) {
  return contact.status != DrawnStatus::open && contact.force.norm() > 0 && contact.force.allFinite();
}

struct Joint {
  std::vector<Vec2> points;
  std::vector<Vec2> forces;  // on the block of the larger index
  double pull = 0;
};

std::map<std::pair<int, int>, Joint> joints_of(const std::vector<DrawnContact>& contacts, double deformation_scale) {
  std::map<std::pair<int, int>, Joint> joints;
  for (const DrawnContact& contact : contacts) {
    if (!carries(contact)) continue;
    Joint& joint = joints[std::minmax(contact.block_a, contact.block_b)];
    joint.points.push_back(place_of(contact, deformation_scale));
    joint.forces.emplace_back(contact.block_a < contact.block_b ? contact.force : Vec2(-contact.force));
    joint.pull += (contact.tension ? 1 : -1) * contact.force.norm();
  }
  return joints;
}

struct Resultant {
  std::array<int, 2> blocks;
  Vec2 point;       // on its line of action
  Vec2 force;       // on the second block
  double size = 0;  // m, of the smaller block
  bool tension = false;
};

// The point of the resultant's line of action nearest to the middle of the contacts, but no farther than `most` away:
// bending without thrust has its line far off.
Vec2 point_of_action(const Joint& joint, const Vec2& force, double most) {
  const Vec2 middle =
      std::accumulate(joint.points.begin(), joint.points.end(), Vec2(0, 0)) / static_cast<double>(joint.points.size());
  double moment = 0;
  for (std::size_t i = 0; i < joint.points.size(); ++i) moment += cross(joint.points[i] - middle, joint.forces[i]);
  const double offset = std::clamp(moment / force.norm(), -most, most);
  return middle + offset * Vec2(force.y(), -force.x()) / force.norm();
}

// Returns the resultants on all joints that carry a force worth drawing.
std::vector<Resultant> resultants_of(const Drawing& drawing, const std::vector<DrawnContact>& contacts,
                                     double deformation_scale) {
  std::vector<Resultant> all;
  double largest = 0;
  for (const auto& [blocks, joint] : joints_of(contacts, deformation_scale)) {
    const Vec2 force = std::accumulate(joint.forces.begin(), joint.forces.end(), Vec2(0, 0));
    if (force.norm() == 0) continue;
    const double size = std::min(size_of(drawing, blocks.first), size_of(drawing, blocks.second));
    all.push_back({{blocks.first, blocks.second}, point_of_action(joint, force, size), force, size, joint.pull > 0});
    largest = std::max(largest, force.norm());
  }
  std::erase_if(all, [&](const Resultant& resultant) { return resultant.force.norm() < least_drawn_force * largest; });
  return all;
}

// Thrust goes through a block from one joint to the other; two forces to the same side are borne by something else,
// such as a support.
bool is_thrust(const Resultant& one, const Resultant& other, int block) {
  const auto on_block = [&](const Resultant& joint) { return joint.blocks[1] == block ? 1.0 : -1.0; };
  return on_block(one) * on_block(other) * one.force.dot(other.force) < 0;
}

// The end of a joint's line in one of its blocks.
Vec2 end_in(const Drawing& drawing, const std::vector<Vec2>& points, const Resultant& joint, int block,
            const std::vector<const Resultant*>& joints) {
  if (joints.size() == 2 && is_thrust(*joints[0], *joints[1], block)) {
    Vec2 half_way = (joints[0]->point + joints[1]->point) / 2;
    if ((half_way - joint.point).norm() <= joint.size) return half_way;
  }
  const Vec2 along = joint.force.normalized();
  const Vec2 centroid = area_and_centroid(drawing, points, static_cast<std::size_t>(block)).second;
  const double most = 0.75 * joint.size;
  return joint.point + std::clamp((centroid - joint.point).dot(along), -most, most) * along;
}

}  // namespace

std::pair<double, Vec2> area_and_centroid(const Drawing& drawing, const std::vector<Vec2>& points, std::size_t block) {
  const Vec2& origin = points[drawing.ring_begin[drawing.block_begin[block]]];
  double area = 0;
  Vec2 moment = Vec2::Zero();
  for (std::uint32_t ring = drawing.block_begin[block]; ring < drawing.block_begin[block + 1]; ++ring) {
    for (std::uint32_t i = drawing.ring_begin[ring]; i < drawing.ring_begin[ring + 1]; ++i) {
      const std::uint32_t before = i > drawing.ring_begin[ring] ? i - 1 : drawing.ring_begin[ring + 1] - 1;
      const Vec2 a = points[before] - origin;
      const Vec2 b = points[i] - origin;
      area += cross(a, b) / 2;
      moment += cross(a, b) / 6 * (a + b);
    }
  }
  return {area, origin + moment / area};
}

std::vector<ForceLine> contact_lines(const Drawing& drawing, const std::vector<DrawnContact>& contacts,
                                     double deformation_scale) {
  std::vector<ForceLine> lines;
  for (const DrawnContact& contact : contacts) {
    if (!carries(contact)) continue;
    const double half = 0.3 * std::min(size_of(drawing, contact.block_a), size_of(drawing, contact.block_b));
    const Vec2 arm = half * contact.force.normalized();
    const Vec2 place = place_of(contact, deformation_scale);
    lines.push_back({place - arm, place + arm, contact.force.norm(), contact.tension});
  }
  return lines;
}

std::vector<ForceLine> joint_lines(const Drawing& drawing, const std::vector<Vec2>& points,
                                   const std::vector<DrawnContact>& contacts, double deformation_scale) {
  const std::vector<Resultant> resultants = resultants_of(drawing, contacts, deformation_scale);
  std::map<int, std::vector<const Resultant*>> joints_of_block;
  for (const Resultant& resultant : resultants)
    for (const int block : resultant.blocks) joints_of_block[block].push_back(&resultant);
  std::vector<ForceLine> lines;
  for (const Resultant& resultant : resultants)
    for (const int block : resultant.blocks)
      lines.push_back({resultant.point, end_in(drawing, points, resultant, block, joints_of_block[block]),
                       resultant.force.norm(), resultant.tension});
  return lines;
}

}  // namespace dda
