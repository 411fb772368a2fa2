// The outlines of all blocks that the frames of a run show, whichever of them is the first to have a block.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "engine/core/types.h"
#include "engine/record/vtp_reader.h"

namespace dda {

// What stays from frame to frame: the true outlines of the blocks, holes included. Blocks that no frame has are not
// among them.
struct Drawing {
  std::vector<std::string> names;         // of the blocks
  std::vector<Vec2> reference;            // m, all vertices as drawn at the start, those of a ring one after the other
  std::vector<std::uint32_t> ring_begin;  // ring r has the vertices ring_begin[r] to ring_begin[r + 1]
  std::vector<std::uint32_t>
      block_begin;  // block b has the rings block_begin[b] to block_begin[b + 1], outer one first

  [[nodiscard]] std::size_t blocks() const { return block_begin.size() - 1; }
  [[nodiscard]] std::size_t rings() const { return ring_begin.size() - 1; }
};

// Stages remove blocks and add others, and a branch may begin while some are away: files have the points of all blocks,
// but cells only of those that are there. So frames are asked one after the other until every point has its block.
class FrameOutlines {
 public:
  // Takes the blocks of a frame that none before had. InputError naming the file where it is damaged, or has not as
  // many points as the first one.
  void add(const std::filesystem::path& path, const PolyData& frame);

  // Whether frames to come can have no blocks but those that have been seen.
  [[nodiscard]] bool is_complete() const { return points_seen_ >= points_in_file_; }

  [[nodiscard]] std::size_t points_in_file() const { return points_in_file_; }

  // The blocks in the order of their numbers in the files.
  [[nodiscard]] Drawing drawing() const;

  // Where in the files every vertex of the drawing is.
  [[nodiscard]] std::vector<std::size_t> points() const;

  // By their numbers in the files, the place of blocks in the drawing.
  [[nodiscard]] std::map<std::int32_t, std::size_t> places() const;

  // How many cells each block of the drawing has in the files.
  [[nodiscard]] std::vector<std::size_t> cells() const;

 private:
  struct Outline {
    std::string name;
    std::size_t cells = 0;
    std::vector<std::size_t> ring_ends;  // in what follows
    std::vector<std::size_t> points;     // in the files, those of a ring one after the other
    std::vector<Vec2> reference;         // m, of each
  };

  static void add_ring(const std::filesystem::path& path, const PolyData& frame, std::span<const std::int64_t> points,
                       Outline& outline);
  [[nodiscard]] static Outline outline_of(const std::filesystem::path& path, const PolyData& frame,
                                          const std::vector<std::size_t>& own);

  std::map<std::int32_t, Outline> blocks_;
  std::size_t points_in_file_ = 0;
  std::size_t points_seen_ = 0;
};

}  // namespace dda
