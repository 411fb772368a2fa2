#include "engine/simulation/excess_shear.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

#include "engine/contact/bond_strength.h"
#include "engine/contact/contact_points.h"
#include "engine/contact/projected_law.h"
#include "engine/geometry/segment.h"
#include "engine/model/tolerance.h"
#include "engine/simulation/block_system.h"
#include "engine/simulation/linear_states.h"

namespace dda {
namespace {

// Cosine between normals of contacts that lie on one face.
constexpr double same_face = 0.99;

// By where its ends were drawn.
bool is_on(const Segment& line, const LoadedFace& face, double tolerance) {
  return distance(line, face.from) <= tolerance && distance(line, face.to) <= tolerance;
}

bool has_named_strength(const JointMaterial& joint) {
  return !joint.bonded || joint.friction_angle > 0 || joint.cohesion > 0;
}

double coulomb(double cohesion, double friction, double normal) { return std::max(0.0, cohesion - friction * normal); }

// By which strength a joint is judged in place of what its contacts can carry now; none: by that.
std::optional<JudgedStrength> strength_for(const JointMaterial& joint, const std::optional<JudgedStrength>& judged) {
  if (judged || !joint.bonded) return judged;
  return JudgedStrength{std::tan(joint.friction_angle), joint.cohesion};
}

// One contact point with what it can carry in shear, N per m of thickness.
struct JudgedPoint {
  ContactPoint point;
  double capacity = 0;
};

double capacity_of(const ContactPoint& point, const EndStrength& strength, bool broken, bool residual) {
  if (broken || strength.is_dry()) return strength.capacity(point.normal_force, residual);
  return coulomb(strength.cohesion, strength.friction, point.normal_force);
}

// One contact after the other, in memory that is kept.
class JudgedPoints {
 public:
  explicit JudgedPoints(const BlockSystem& system) : system_(system) {}

  const std::vector<JudgedPoint>& of(std::size_t i) {
    const BlockSystem& s = system_;
    const InterfaceState state = interface_state_now(s, i);
    found_.clear();
    const EndStrength& strength = s.contacts.strengths[i];
    const InterfaceElement element = s.contacts.elements[i];
    append_contact_points(s.model, s.state, s.contacts.interfaces[i], element, state, found_);
    points_.clear();
    const bool presses_as_one = press_together(element, state.broken);
    for (std::size_t end = 0; end < found_.size(); ++end)
      points_.push_back(
          {found_[end], presses_as_one ? stretch_capacity(element, strength, state, static_cast<int>(end))
                                       : capacity_of(found_[end], strength, state.broken[end], state.residual[end])});
    return points_;
  }

 private:
  const BlockSystem& system_;
  std::vector<ContactPoint> found_;
  std::vector<JudgedPoint> points_;
};

LoadedFace face_of(const std::vector<JudgedPoint>& points, int joint, double length,
                   const std::optional<JudgedStrength>& judged) {
  const auto [low, high] = std::minmax(points.front().point.block_a, points.front().point.block_b);
  LoadedFace face{low,   high, joint, Vec2::Zero(), points.front().point.reference, points.back().point.reference,
                  length};
  for (const auto& [point, capacity] : points) {
    face.place += point.point / static_cast<double>(points.size());
    face.normal += point.normal_force / length;
    face.shear += point.shear_force / length;
    face.strength += capacity / length;
  }
  if (judged) face.strength = coulomb(judged->cohesion, judged->friction, face.normal);
  return face;
}

// How far the points reach along the face with this normal, m: contacts of two edges are at the ends of what they have
// in common.
double extent_of(const std::vector<JudgedPoint>& points, const Vec2& normal) {
  const auto place = [&normal](const JudgedPoint& judged) { return cross(normal, judged.point.point); };
  const auto [first, last] = std::ranges::minmax_element(points, {}, place);
  return place(*last) - place(*first);
}

// Contacts of single vertices, by their blocks and joint.
using VertexPoints = std::map<std::tuple<int, int, int>, std::vector<JudgedPoint>>;

// Two vertices or more make a face; one alone has no length.
void append_faces_of_vertices(const Model& model, const std::optional<JudgedStrength>& judged, VertexPoints& points,
                              std::vector<LoadedFace>& faces) {
  for (auto& [key, left] : points) {
    const int joint = std::get<2>(key);
    while (!left.empty()) {
      const Vec2 normal = left.front().point.normal;
      const auto rest = std::stable_partition(left.begin(), left.end(), [&](const JudgedPoint& other) {
        return std::abs(other.point.normal.dot(normal)) > same_face;
      });
      const std::vector<JudgedPoint> own(left.begin(), rest);
      left.erase(left.begin(), rest);
      const double length = extent_of(own, normal);
      if (length > point_tolerance(model))
        faces.push_back(
            face_of(own, joint, length, strength_for(model.joints[static_cast<std::size_t>(joint)], judged)));
    }
  }
}

// Contacts carry what their law says to this share of the largest force between blocks (solve/friction_passes), so the
// shear of a joint that slides is off its strength by that, to either side.
constexpr double share_left_by_steps = 1e-9;

// N per m of thickness.
double negligible_force(const std::vector<LoadedFace>& faces) {
  double largest = 0;
  for (const LoadedFace& face : faces)
    largest = std::max(largest, face.length * std::max(std::abs(face.normal), std::abs(face.shear)));
  return share_left_by_steps * largest;
}

// Pa; 0 where the shear is the strength, up to a `negligible` force.
double excess_beyond(double negligible, const LoadedFace& face) {
  const double excess = face.excess();
  return std::abs(excess) * face.length <= negligible ? 0 : excess;
}

void add(const LoadedFace& face, double negligible, ExcessShear& sum) {
  sum.length += face.length;
  const double excess = excess_beyond(negligible, face);
  if (excess > 0) sum.positive += face.length;
  if (sum.length > face.length && excess <= sum.largest) return;
  std::tie(sum.largest, sum.block_a, sum.block_b, sum.normal, sum.shear) =
      std::tuple(excess, face.block_a, face.block_b, face.normal, face.shear);
  sum.place = face.place;
}

std::optional<JudgedStrength> strength_of(const Measurement& measurement) {
  if (!measurement.friction_angle && !measurement.cohesion) return std::nullopt;
  return JudgedStrength{std::tan(measurement.friction_angle.value_or(0)), measurement.cohesion.value_or(0)};
}

void keep_measured(const BlockSystem& system, const Measurement& measurement, std::vector<LoadedFace>& faces) {
  const double tolerance = point_tolerance(system.model);
  std::erase_if(faces, [&](const LoadedFace& face) {
    const bool is_other = measurement.joint >= 0 && face.joint != measurement.joint;
    return is_other || (measurement.on_line && !is_on({measurement.from, measurement.to}, face, tolerance));
  });
}

}  // namespace

double LoadedFace::excess() const { return std::abs(shear) - strength; }

std::vector<LoadedFace> loaded_faces(const BlockSystem& s, const std::optional<JudgedStrength>& judged) {
  std::vector<LoadedFace> faces;
  VertexPoints vertices;
  JudgedPoints judged_points(s);
  for (std::size_t i = 0; i < s.contacts.interfaces.size(); ++i) {
    const Interface& interface = s.contacts.interfaces[i];
    const JointMaterial& joint = s.model.joints[static_cast<std::size_t>(interface.joint)];
    if (!judged && !has_named_strength(joint)) continue;
    const std::vector<JudgedPoint>& points = judged_points.of(i);
    if (interface.length > 0) {
      faces.push_back(face_of(points, interface.joint, interface.length, strength_for(joint, judged)));
      continue;
    }
    const auto [low, high] = std::minmax(interface.block_a, interface.block_b);
    std::vector<JudgedPoint>& same = vertices[{low, high, interface.joint}];
    same.insert(same.end(), points.begin(), points.end());
  }
  append_faces_of_vertices(s.model, judged, vertices, faces);
  return faces;
}

std::vector<ExcessShear> excess_by_joint(const BlockSystem& s) {
  std::map<int, ExcessShear> by_joint;
  const std::vector<LoadedFace> faces = loaded_faces(s, std::nullopt);
  const double negligible = negligible_force(faces);
  for (const LoadedFace& face : faces) {
    ExcessShear& sum = by_joint[face.joint];
    sum.stage = static_cast<int>(s.clock.stage);
    sum.joint = face.joint;
    add(face, negligible, sum);
  }
  std::vector<ExcessShear> list;
  for (const auto& [joint, sum] : by_joint) list.push_back(sum);
  return list;
}

Vec2 excess_shear(const BlockSystem& system, const Measurement& measurement) {
  ExcessShear sum;
  sum.largest = std::numeric_limits<double>::quiet_NaN();
  std::vector<LoadedFace> faces = loaded_faces(system, strength_of(measurement));
  const double negligible = negligible_force(faces);
  keep_measured(system, measurement, faces);
  for (const LoadedFace& face : faces) add(face, negligible, sum);
  return {sum.largest, sum.positive};
}

bool has_faces(const BlockSystem& system, const Measurement& measurement) {
  std::vector<LoadedFace> faces = loaded_faces(system, strength_of(measurement));
  keep_measured(system, measurement, faces);
  return !faces.empty();
}

}  // namespace dda
