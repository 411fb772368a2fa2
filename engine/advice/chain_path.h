// The way of a wave through a scene whose blocks lie in flat layers across it: a row of any blocks, a column between
// rollers, a mesh in courses. A plane wave moves all blocks of a layer alike, so one of each stands for its layer.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/advice/load_history.h"
#include "engine/advice/plane_wave.h"
#include "engine/contact/contact_set.h"
#include "engine/model/model.h"

namespace dda {

struct ChainNeighbour {
  int block = 0;
  int layer = 0;
  std::size_t interface = 0;
};

struct ChainLayer {
  int block = 0;  // that stands for the layer
  std::vector<ChainNeighbour> neighbours;
  double thickness = 0;  // m
  double width = 0;      // m, of the block
  double speed = 0;      // m/s, of the wave in the layer's rock
  double impedance = 0;  // N s/m per m of thickness: density times speed times width
};

struct ChainPath {
  Vec2 direction = Vec2::UnitX();  // unit, away from the load
  WaveKind kind = WaveKind::bar;
  std::vector<ChainLayer> layers;     // the first of them is driven
  bool is_moved = false;              // by supports or as a whole, in place of loaded
  bool driven_as_whole = false;       // the first layer is a held block that moves: the way begins behind it
  std::vector<std::size_t> supports;  // of the model, that act on the blocks above

  // Joint j lies between layers j - 1 and j.
  [[nodiscard]] double distance_of(int joint) const;    // m, from where the way begins
  [[nodiscard]] double time_to(int joint) const;        // s, of the wave in the rock alone
  [[nodiscard]] int joint_near(double distance) const;  // at least the first joint of the way
  [[nodiscard]] bool is_of_one_rock(int layers) const;  // as far as waves are concerned
  // All layers but the first and the last are as thick, of the same rock and held by the same joints: one stands for
  // all.
  [[nodiscard]] bool repeats_itself(const Model& model, const ContactSet& contacts) const;
  [[nodiscard]] int layers_within(double distance) const;  // of the first ones, that reach as far
};

// Whether a support stands where it is.
bool is_still(const PointSupport& support);

// The projection on the directions in which it holds.
Mat2 held_directions(const PointSupport& support);

struct PathSearch {
  std::optional<ChainPath> path;
  std::string why_not;  // a clause for people, where there is none
};

// `contacts`: of the model as drawn.
PathSearch find_chain_path(const Model& model, const ContactSet& contacts, const SceneLoad& load);

}  // namespace dda
