#include "engine/view/frame_outlines.h"

#include <utility>

#include "engine/view/frame_file.h"

namespace dda {

void FrameOutlines::add_ring(const std::filesystem::path& path, const PolyData& frame,
                             std::span<const std::int64_t> points, Outline& outline) {
  const auto& displacement = need_array<double>(path, frame.point_data, "displacement [m]", 3);
  for (const std::int64_t point : points) {
    const auto i = static_cast<std::size_t>(point);
    outline.points.push_back(i);
    outline.reference.emplace_back(plane(frame.points, i) - plane(displacement, i));
  }
  outline.ring_ends.push_back(outline.points.size());
}

// A block is one polygon, or triangles with rings as closed lines; see FrameWriter.
FrameOutlines::Outline FrameOutlines::outline_of(const std::filesystem::path& path, const PolyData& frame,
                                                 const std::vector<std::size_t>& own) {
  const std::size_t lines = frame.lines.size();
  Outline outline;
  outline.name = need_array<std::string>(path, frame.cell_data, "block_name", 1)[own[0]];
  outline.cells = own.size();
  if (own[0] >= lines) add_ring(path, frame, frame.polygons.cell(own[0] - lines), outline);
  for (const std::size_t cell : own) {
    if (cell >= lines) break;
    const auto closed = frame.lines.cell(cell);
    if (closed.size() < 4) refuse_frame(path, "damaged (a ring is too short)");
    add_ring(path, frame, closed.first(closed.size() - 1), outline);
  }
  return outline;
}

void FrameOutlines::add(const std::filesystem::path& path, const PolyData& frame) {
  const auto& block_of = need_array<std::int32_t>(path, frame.cell_data, "block", 1);
  const std::size_t points = frame.points.size() / 3;
  if (frame.vertices.size() != 0) refuse_frame(path, "without blocks");
  if (points_in_file_ == 0) points_in_file_ = points;
  if (points != points_in_file_) refuse_frame(path, "of other blocks than the first frame");

  std::map<std::int32_t, std::vector<std::size_t>> cells;
  for (std::size_t i = 0; i < block_of.size(); ++i) {
    if (block_of[i] < 0) refuse_frame(path, "damaged (block)");
    if (!blocks_.contains(block_of[i])) cells[block_of[i]].push_back(i);
  }
  for (const auto& [block, own] : cells) {
    Outline outline = outline_of(path, frame, own);
    points_seen_ += outline.points.size();
    blocks_.emplace(block, std::move(outline));
  }
}

Drawing FrameOutlines::drawing() const {
  Drawing drawing{{}, {}, {0}, {0}};
  for (const auto& [block, outline] : blocks_) {
    const std::size_t first = drawing.reference.size();
    drawing.names.push_back(outline.name);
    drawing.reference.insert(drawing.reference.end(), outline.reference.begin(), outline.reference.end());
    for (const std::size_t end : outline.ring_ends)
      drawing.ring_begin.push_back(static_cast<std::uint32_t>(first + end));
    drawing.block_begin.push_back(static_cast<std::uint32_t>(drawing.rings()));
  }
  return drawing;
}

std::vector<std::size_t> FrameOutlines::points() const {
  std::vector<std::size_t> points;
  for (const auto& [block, outline] : blocks_)
    points.insert(points.end(), outline.points.begin(), outline.points.end());
  return points;
}

std::map<std::int32_t, std::size_t> FrameOutlines::places() const {
  std::map<std::int32_t, std::size_t> places;
  for (const auto& [block, outline] : blocks_) places.emplace_hint(places.end(), block, places.size());
  return places;
}

std::vector<std::size_t> FrameOutlines::cells() const {
  std::vector<std::size_t> cells;
  for (const auto& [block, outline] : blocks_) cells.push_back(outline.cells);
  return cells;
}

}  // namespace dda
