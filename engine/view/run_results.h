// What `dda run --frames` left in a folder, read back for pictures.
#pragma once

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/types.h"
#include "engine/record/vtp_reader.h"
#include "engine/view/frame_outlines.h"

namespace dda {

enum class DrawnStatus : std::uint8_t { locked, sliding, open };

struct DrawnContact {
  int block_a = 0;
  int block_b = 0;
  Vec2 reference;        // m, the material point of block b
  Vec2 displacement;     // m, of that point
  Vec2 force;            // N per m of thickness, on block b
  bool tension = false;  // it pulls the blocks together
  DrawnStatus status = DrawnStatus::open;
};

enum class DrawnCondition : std::uint8_t { elastic, yielded, broken, waiting };  // waiting: not drawn

// A link of a rock bolt, or an element of a lining: a line through material points of its two blocks.
struct DrawnBolt {
  std::string name;
  std::vector<Vec2> reference;     // m
  std::vector<Vec2> displacement;  // m, of these points
  double force = 0;                // N in one bolt, or per m of a lining: axial, tension positive
  DrawnCondition condition = DrawnCondition::elastic;
  // The share of its strength that an element of a lining carries. It is no number for bolts, and where no element of
  // the lining carries any.
  double utilisation = std::numeric_limits<double>::quiet_NaN();
};

// Blocks that are not there, removed or still to be added, have displacements, stresses and velocities that are no
// numbers.
struct Frame {
  double time = 0;                 // s
  std::vector<Vec2> displacement;  // m, of every vertex of the Drawing
  std::vector<Vec3> stress;        // Pa, of every block: xx, yy, xy, tension positive
  std::vector<Vec2> velocity;      // m/s, of every block's centroid
  std::vector<Vec2> moved;         // m, displacement of every block's centroid
  std::vector<DrawnContact> contacts;
  std::vector<DrawnBolt> bolts;  // the same links in every frame, then the elements of linings
};

inline bool is_present(const Frame& frame, std::size_t block) { return !std::isnan(frame.moved[block].x()); }

class RunResults {
 public:
  // Reads the list of frames, and as many of them as it takes to know all blocks. InputError naming the file, and what
  // to do, when there is none or one is broken.
  explicit RunResults(const std::filesystem::path& folder);

  [[nodiscard]] const Drawing& drawing() const { return drawing_; }
  [[nodiscard]] const std::vector<double>& times() const { return times_; }

  // False for runs of a program that did not write contacts yet.
  [[nodiscard]] bool has_contacts() const { return !contacts_.empty(); }

  // False for scenes without bolts, and for programs that did not write bolts yet.
  [[nodiscard]] bool has_bolts() const { return !bolts_.empty(); }
  [[nodiscard]] bool has_linings() const { return !linings_.empty(); }

  // Reads a frame; InputError naming the file when it is broken or not of the same blocks.
  [[nodiscard]] Frame frame(std::size_t index) const;

 private:
  [[nodiscard]] std::vector<SeriesEntry> series_beside(const std::filesystem::path& index) const;
  void read_outlines();
  void add_lines(std::size_t index, std::vector<DrawnBolt>& lines) const;
  [[nodiscard]] std::vector<std::optional<std::size_t>> cells_of_blocks(const std::filesystem::path& path,
                                                                        const PolyData& data) const;

  std::vector<SeriesEntry> frames_;
  std::vector<SeriesEntry> contacts_;
  std::vector<SeriesEntry> bolts_;
  std::vector<SeriesEntry> linings_;
  std::vector<double> times_;
  Drawing drawing_;
  std::vector<std::size_t> point_;                      // in the file, of every vertex
  std::map<std::int32_t, std::size_t> place_of_block_;  // in the drawing, by its number in the file
  std::vector<std::size_t> cells_of_block_;             // how many a block of the drawing has in the file
  std::size_t points_in_file_ = 0;
  std::vector<std::int64_t> bolt_offsets_, lining_offsets_;  // in the file: where each line ends
};

}  // namespace dda
