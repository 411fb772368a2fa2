// Follows what Model::peaks asks about: the strongest motion of every block in one stage.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "engine/model/block_peaks.h"
#include "engine/simulation/simulation.h"

namespace dda {

// Peaks are those of the ends of steps, and of the stage's first moment. Motion relative to the rest is relative to the
// median of all blocks present, by mass, of each component: a few blocks that fly do not change it, and a base that is
// shaken takes it along.
class PeakMotion {
 public:
  // The model of `simulation` must ask for peaks. Looks at its first moment, if that is one of the stage.
  explicit PeakMotion(const Simulation& simulation);

  // To be called after every step that is not the last of its stage.
  void after_step(const Simulation& simulation);
  // To be called between two stages and after the last, when nothing of the next has begun. `ended`: the stage, from 0.
  void after_stage(const Simulation& simulation, std::size_t ended);

  [[nodiscard]] bool has_begun() const { return has_begun_; }
  [[nodiscard]] bool is_over() const { return is_over_; }
  [[nodiscard]] std::span<const BlockPeaks> blocks() const { return blocks_; }

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [blocks, start, has_begun, is_over, sorted] = self;
    archive(has_begun, is_over);
    archive.each(blocks);
    archive.each(start);
  }

 private:
  void begin(const Simulation& simulation);
  void look(const Simulation& simulation);
  [[nodiscard]] Vec2 median(const Model& model, const std::vector<Vec6>& values, std::span<const Vec2> from);
  void look_for_ejection(const EjectionRequest& asked, const Simulation& simulation);

  std::vector<BlockPeaks> blocks_;
  std::vector<Vec2> start_;  // displacements of the centroids when the stage began
  bool has_begun_ = false;
  bool is_over_ = false;
  std::vector<std::pair<double, int>> sorted_;  // values and blocks; scratch
};

}  // namespace dda
