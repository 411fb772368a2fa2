#include "engine/advice/chain_path.h"
#include "engine/advice/reach.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <variant>

#include "engine/geometry/polygon.h"

namespace dda {
namespace {

constexpr double tolerance = 1e-6;  // of lengths, over those of the block; of cosines

std::size_t at(int index) { return static_cast<std::size_t>(index); }

// One try: the layers across `direction`.
class Layering {
 public:
  Layering(const Model& model, const ContactSet& contacts, const SceneLoad& load, const Vec2& direction)
      : model_(model), contacts_(contacts), load_(load), direction_(direction) {
    path_.direction = direction;
    path_.is_moved = static_cast<bool>(load.history.displacement);
  }

  PathSearch run() {
    sort_blocks();
    if (layer_of_[at(load_.block)] != 0) return {std::nullopt, "what drives it is not on the first of its layers"};
    for (const auto& members : layers_)
      if (!add_layer(members)) return {std::nullopt, why_not_};
    path_.driven_as_whole = model_.is_held(load_.block);
    if (!choose_kind() || !find_drive()) return {std::nullopt, why_not_};
    for (ChainLayer& layer : path_.layers) {
      const Material& material = model_.material_of(layer.block);
      layer.speed = continuum_speed(material, path_.kind);
      layer.impedance = material.density * layer.speed * layer.width;
    }
    if (path_.layers.size() < (path_.driven_as_whole ? 3 : 2)) return {std::nullopt, "there is no joint on its way"};
    return {path_, ""};
  }

 private:
  [[nodiscard]] const Block& block(int index) const { return model_.blocks[at(index)]; }
  [[nodiscard]] double along(int index) const { return direction_.dot(block(index).moments.centroid); }

  bool fail(const char* why) {
    why_not_ = why;
    return false;
  }

  // Blocks whose centroids are at one height lie in one layer.
  void sort_blocks() {
    std::vector<int> order(model_.blocks.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return along(a) < along(b); });
    layer_of_.resize(order.size());
    for (const int index : order) {
      const double size = std::sqrt(block(index).moments.area);
      if (layers_.empty() || along(index) - along(layers_.back().front()) > tolerance * size) layers_.emplace_back();
      layers_.back().push_back(index);
      layer_of_[at(index)] = static_cast<int>(layers_.size()) - 1;
    }
    neighbours_.resize(order.size());
    for (std::size_t i = 0; i < contacts_.interfaces.size(); ++i) {
      const Interface& interface = contacts_.interfaces[i];
      if (interface.length == 0) continue;
      for (const auto& [a, b] :
           {std::pair(interface.block_a, interface.block_b), std::pair(interface.block_b, interface.block_a)})
        neighbours_[at(a)].push_back({b, layer_of_[at(b)], i});
    }
  }

  // Nearest to the line through where the wave is looked at, so that the ends of courses are far.
  [[nodiscard]] int representative(const std::vector<int>& members) const {
    const Vec2 across = left_of(direction_);
    return *std::min_element(members.begin(), members.end(), [&](int a, int b) {
      const auto distance = [&](int i) { return std::abs(across.dot(block(i).moments.centroid - load_.looked_at)); };
      return distance(a) < (1 - tolerance) * distance(b);
    });
  }

  bool add_layer(const std::vector<int>& members) {
    const int index = representative(members);
    ChainLayer layer;
    layer.block = index;
    layer.neighbours = neighbours_[at(index)];
    layer.thickness = extent_along(block(index).shape.outer, direction_);
    layer.width = block(index).moments.area / layer.thickness;
    const int number = static_cast<int>(path_.layers.size());
    double before = 0, behind = 0;
    for (const ChainNeighbour& neighbour : layer.neighbours) {
      const Interface& interface = contacts_.interfaces[neighbour.interface];
      const int way = neighbour.layer - number;
      if (std::abs(way) > 1) return fail("its blocks do not lie in flat layers");
      if (way == 0) continue;
      if (std::abs(interface.normal.dot(direction_)) < 1 - tolerance) return fail("its joints are not across the wave");
      (way < 0 ? before : behind) += interface.length;
    }
    const bool is_last = number + 1 == static_cast<int>(layers_.size());
    if ((number > 0 && before == 0) || (!is_last && behind == 0)) return fail("its layers do not all touch");
    if (members.size() > 1 && !is_inside_of_mesh(layer, number, before, behind))
      return fail("the blocks of its layers are not all alike");
    path_.layers.push_back(layer);
    return true;
  }

  // Whole neighbours all around, as wide as the block itself.
  [[nodiscard]] bool is_inside_of_mesh(const ChainLayer& layer, int number, double before, double behind) const {
    const double slack = tolerance * layer.width;
    const bool is_last = number + 1 == static_cast<int>(layers_.size());
    if (number > 0 && std::abs(before - layer.width) > slack) return false;
    if (!is_last && std::abs(behind - layer.width) > slack) return false;
    const bool on_base = number == 1 && model_.is_held(load_.block);  // which moves all of the layer alike
    if (number > 0 && !on_base && std::abs(path_.layers.back().width - layer.width) > slack) return false;
    int beside = 0;
    for (const ChainNeighbour& neighbour : layer.neighbours) {
      if (neighbour.layer != number) continue;
      ++beside;
      const double difference = block(neighbour.block).moments.area - block(layer.block).moments.area;
      if (std::abs(difference) > tolerance * block(layer.block).moments.area) return false;
      if (block(neighbour.block).material != block(layer.block).material) return false;
    }
    return beside == 2;
  }

  [[nodiscard]] bool is_row() const { return layers_.size() == model_.blocks.size(); }

  // Along the layers' normal, or across it; a row between rollers is one course of a mesh.
  bool choose_kind() {
    const double cosine = std::abs(load_.motion.normalized().dot(direction_));
    if (cosine > tolerance && cosine < 1 - tolerance) return fail("what drives it pushes at an angle");
    const bool shear = cosine <= tolerance;
    particles_ = shear ? left_of(direction_) : direction_;
    path_.kind = shear ? WaveKind::s : WaveKind::p;
    if (!is_row()) return true;
    const std::size_t guided = count_guided_layers();
    if (guided + 2 >= layers_.size() && guided > 0) return true;
    if (shear) return fail("a push across a row of blocks bends it, and bending is not foretold");
    if (guided != 0) return fail("some of its blocks are held at their sides and some are not");
    path_.kind = WaveKind::bar;
    return true;
  }

  // Rollers that leave the wave its motion, on both sides of a block, between the first layer and the last. Others
  // (what holds the far end) are left out.
  std::size_t count_guided_layers() {
    std::map<int, std::pair<double, double>> sides;
    for (std::size_t i = 0; i < model_.supports.size(); ++i) {
      const PointSupport& support = model_.supports[i];
      if (!is_still(support) || support.partner || support.last_stage >= 0) continue;
      if ((held_directions(support) * particles_).norm() > tolerance) continue;
      const double side = left_of(direction_).dot(support.point - block(support.block).moments.centroid);
      auto& [low, high] = sides[support.block];
      low = std::min(low, side);
      high = std::max(high, side);
      path_.supports.push_back(i);
    }
    return static_cast<std::size_t>(std::count_if(sides.begin(), sides.end(), [&](const auto& side) {
      const int layer = layer_of_[at(side.first)];
      const bool is_end = layer == 0 || layer + 1 == static_cast<int>(layers_.size());
      return !is_end && side.second.first < 0 && side.second.second > 0;
    }));
  }

  // The first layer is driven as a whole and by one history.
  bool find_drive() {
    const int first = path_.layers.front().block;
    double loaded = 0;
    bool driven = path_.driven_as_whole;
    for (const EdgeLoad& load : model_.edge_loads) {
      if (load.block != first || std::holds_alternative<Constant>(load.history)) continue;
      loaded += (load.to - load.from).norm();
      driven = true;
    }
    for (const PointLoad& load : model_.point_loads) {
      if (load.block != first || std::holds_alternative<Constant>(load.history)) continue;
      if (!is_row()) return fail("a load at a point spreads to all sides of a mesh");
      driven = true;
    }
    for (std::size_t i = 0; i < model_.supports.size(); ++i) {
      if (model_.supports[i].block != first || is_still(model_.supports[i])) continue;
      path_.supports.push_back(i);
      driven = true;
    }
    if (!driven) return fail("what drives it is not there where the wave is looked at");
    if (!is_row() && loaded > 0 && std::abs(loaded - path_.layers.front().width) > tolerance * loaded)
      return fail("its load does not cover the face of the first layer");
    return true;
  }

  const Model& model_;
  const ContactSet& contacts_;
  const SceneLoad& load_;
  Vec2 direction_;
  Vec2 particles_ = Vec2::UnitX();
  std::vector<std::vector<int>> layers_;
  std::vector<int> layer_of_;
  std::vector<std::vector<ChainNeighbour>> neighbours_;
  ChainPath path_;
  std::string why_not_;
};

// Away from the driven block across its joints, those first that lie opposite to where it is driven. Nothing runs into
// a block that is held.
std::vector<Vec2> directions_from(const Model& model, const ContactSet& contacts, const SceneLoad& load) {
  std::vector<Vec2> directions;
  for (const Interface& interface : contacts.interfaces) {
    if (interface.length == 0) continue;
    if (interface.block_a == load.block && !model.is_held(interface.block_b)) directions.push_back(interface.normal);
    if (interface.block_b == load.block && !model.is_held(interface.block_a))
      directions.emplace_back(-interface.normal);
  }
  const Vec2 arm = load.place - model.blocks[at(load.block)].moments.centroid;
  std::stable_sort(directions.begin(), directions.end(),
                   [&](const Vec2& a, const Vec2& b) { return arm.dot(a) < arm.dot(b) - 1e-9 * arm.norm(); });
  return directions;
}

}  // namespace

bool is_still(const PointSupport& support) {
  return support.amplitude.isZero(0) || std::holds_alternative<Constant>(support.history);
}

Mat2 held_directions(const PointSupport& support) {
  if (!support.direction.isZero(0)) return support.direction * support.direction.transpose();
  return Mat2(Vec2(support.holds_x ? 1 : 0, support.holds_y ? 1 : 0).asDiagonal());
}

double ChainPath::distance_of(int joint) const {
  double sum = 0;
  for (int i = driven_as_whole ? 1 : 0; i < joint; ++i) sum += layers[at(i)].thickness;
  return sum;
}

double ChainPath::time_to(int joint) const {
  double sum = 0;
  for (int i = driven_as_whole ? 1 : 0; i < joint; ++i) sum += layers[at(i)].thickness / layers[at(i)].speed;
  return sum;
}

int ChainPath::joint_near(double distance) const {
  const int first = driven_as_whole ? 2 : 1;
  int nearest = first;
  double gone = distance_of(first);
  double least = std::abs(gone - distance);
  for (int joint = first + 1; joint < static_cast<int>(layers.size()); ++joint) {
    gone += layers[at(joint - 1)].thickness;
    if (std::abs(gone - distance) >= least) continue;
    least = std::abs(gone - distance);
    nearest = joint;
  }
  return nearest;
}

bool ChainPath::is_of_one_rock(int number) const {
  const ChainLayer& first = layers[driven_as_whole ? 1 : 0];
  return std::all_of(layers.begin() + (driven_as_whole ? 1 : 0), layers.begin() + number, [&](const ChainLayer& layer) {
    return std::abs(layer.speed / first.speed - 1) < tolerance &&
           std::abs(layer.impedance / first.impedance - 1) < tolerance;
  });
}

bool ChainPath::repeats_itself(const Model& model, const ContactSet& contacts) const {
  const ChainLayer& one = layers[layers.size() / 2];
  const auto joint_of = [&](const ChainLayer& layer) {
    return contacts.interfaces[layer.neighbours.front().interface].joint;
  };
  return supports.empty() && std::all_of(layers.begin(), layers.end(), [&](const ChainLayer& layer) {
           return std::abs(layer.thickness / one.thickness - 1) < tolerance &&
                  std::abs(layer.width / one.width - 1) < tolerance &&
                  model.blocks[at(layer.block)].material == model.blocks[at(one.block)].material &&
                  joint_of(layer) == joint_of(one);
         });
}

int ChainPath::layers_within(double distance) const {
  double gone = 0;
  int number = 0;
  while (number < static_cast<int>(layers.size()) && gone < distance) gone += layers[at(number++)].thickness;
  return number;
}

PathSearch find_chain_path(const Model& model, const ContactSet& contacts, const SceneLoad& load) {
  std::optional<PathSearch> first;
  for (const Vec2& direction : directions_from(model, contacts, load)) {
    PathSearch search = Layering(model, contacts, load, direction).run();
    if (search.path) return search;
    if (!first) first = std::move(search);
  }
  return first ? *first : PathSearch{std::nullopt, "the block that is driven touches no other"};
}

}  // namespace dda
