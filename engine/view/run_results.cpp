#include "engine/view/run_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <system_error>

#include "engine/core/error.h"
#include "engine/view/frame_file.h"

namespace dda {
namespace {

std::vector<SeriesEntry> frames_in(const std::filesystem::path& folder) {
  std::error_code ignored;
  const auto need = [&](const std::string& value) {
    throw InputError("", "the folder " + folder.string(), value,
                     "results with frames: dda run SCENE.json --out " + folder.string() + " --frames 100");
  };
  if (!std::filesystem::is_directory(folder, ignored)) need("missing");
  if (!std::filesystem::exists(folder / "frames.pvd", ignored)) need("without frames.pvd");
  auto entries = read_series(folder / "frames.pvd");
  if (entries.empty()) need("without frames");
  return entries;
}

std::vector<DrawnContact> read_contacts(const std::filesystem::path& path,
                                        const std::map<std::int32_t, std::size_t>& places) {
  const PolyData data = read_vtp(path);
  const auto& block_a = need_array<std::int32_t>(path, data.point_data, "block_a", 1);
  const auto& block_b = need_array<std::int32_t>(path, data.point_data, "block_b", 1);
  const auto& status = need_array<std::int32_t>(path, data.point_data, "status", 1);
  const auto& force = need_array<double>(path, data.point_data, "force [N/m]", 3);
  const auto& normal_force = need_array<double>(path, data.point_data, "normal_force [N/m]", 1);
  const auto& displacement = need_array<double>(path, data.point_data, "displacement [m]", 3);
  std::vector<DrawnContact> contacts(block_a.size());
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const auto a = places.find(block_a[i]);
    const auto b = places.find(block_b[i]);
    if (a == places.end() || b == places.end()) refuse_frame(path, "of other blocks than the frames");
    if (status[i] < 0 || status[i] > 2) refuse_frame(path, "with the unknown status " + std::to_string(status[i]));
    const Vec2 moved = plane(displacement, i);
    contacts[i] = {static_cast<int>(a->second),
                   static_cast<int>(b->second),
                   plane(data.points, i) - moved,
                   moved,
                   plane(force, i),
                   normal_force[i] > 0,
                   static_cast<DrawnStatus>(status[i])};
  }
  return contacts;
}

// What files of lines along bolts, or along linings, call their values.
struct LineNames {
  const char* kind;
  const char* name;
  const char* force;
  double sign;                             // of what is tension
  std::vector<DrawnCondition> conditions;  // by the numbers in the file
};

const LineNames bolt_lines{
    "bolts",
    "bolt_name",
    "axial_force [N]",
    1,
    {DrawnCondition::elastic, DrawnCondition::yielded, DrawnCondition::broken, DrawnCondition::waiting}};
const LineNames lining_lines{"linings",
                             "lining_name",
                             "thrust [N]",
                             -1,
                             {DrawnCondition::elastic, DrawnCondition::yielded, DrawnCondition::waiting}};

void append_lines(const std::filesystem::path& path, const PolyData& data, const LineNames& names,
                  const std::vector<std::int64_t>& offsets, std::vector<DrawnBolt>& lines) {
  if (data.lines.offsets != offsets) refuse_frame(path, fmt::format("of other {} than the first frame", names.kind));
  const auto& name = need_array<std::string>(path, data.cell_data, names.name, 1);
  const auto& status = need_array<std::int32_t>(path, data.cell_data, "status", 1);
  const auto& force = need_array<double>(path, data.cell_data, names.force, 1);
  const auto& displacement = need_array<double>(path, data.point_data, "displacement [m]", 3);
  for (std::size_t i = 0; i < data.lines.size(); ++i) {
    if (status[i] < 0 || static_cast<std::size_t>(status[i]) >= names.conditions.size())
      refuse_frame(path, "with the unknown status " + std::to_string(status[i]));
    DrawnBolt& line = lines.emplace_back();
    line.name = name[i];
    line.force = names.sign * force[i];
    line.condition = names.conditions[static_cast<std::size_t>(status[i])];
    for (const std::int64_t point : data.lines.cell(i)) {
      const auto at = static_cast<std::size_t>(point);
      line.displacement.push_back(plane(displacement, at));
      line.reference.emplace_back(plane(data.points, at) - line.displacement.back());
    }
  }
}

// Reads how far the elements of linings are used, those of one lining after the other.
void read_utilisation(const std::filesystem::path& path, const PolyData& data, std::span<DrawnBolt> elements) {
  const auto& shares = need_array<double>(path, data.cell_data, "utilisation", 1);
  for (std::size_t begin = 0, end = 0; begin < elements.size(); begin = end) {
    double largest = 0;
    for (end = begin; end < elements.size() && elements[end].name == elements[begin].name; ++end)
      largest = std::max(largest, shares[end]);
    if (largest > 0)
      for (std::size_t i = begin; i < end; ++i) elements[i].utilisation = shares[i];
  }
}

// Gives a block that is not there the values of none.
void add_nothing(const Drawing& drawing, std::size_t block, Frame& frame) {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  frame.stress.emplace_back(Vec3::Constant(nothing));
  frame.velocity.emplace_back(Vec2::Constant(nothing));
  frame.moved.emplace_back(Vec2::Constant(nothing));
  const std::uint32_t last = drawing.ring_begin[drawing.block_begin[block + 1]];
  for (std::uint32_t i = drawing.ring_begin[drawing.block_begin[block]]; i < last; ++i)
    frame.displacement[i].setConstant(nothing);
}

}  // namespace

RunResults::RunResults(const std::filesystem::path& folder) : frames_(frames_in(folder)) {
  for (const SeriesEntry& entry : frames_) times_.push_back(entry.time);
  contacts_ = series_beside(folder / "contacts.pvd");
  bolts_ = series_beside(folder / "bolts.pvd");
  linings_ = series_beside(folder / "linings.pvd");
  if (has_bolts()) bolt_offsets_ = read_vtp(bolts_[0].file).lines.offsets;
  if (has_linings()) lining_offsets_ = read_vtp(linings_[0].file).lines.offsets;
  read_outlines();
}

std::vector<SeriesEntry> RunResults::series_beside(const std::filesystem::path& index) const {
  if (!std::filesystem::exists(index)) return {};
  auto entries = read_series(index);
  if (!entries.empty() && entries.size() < frames_.size()) refuse_frame(index, "shorter than frames.pvd");
  return entries;
}

void RunResults::read_outlines() {
  FrameOutlines outlines;
  for (const SeriesEntry& entry : frames_) {
    outlines.add(entry.file, read_vtp(entry.file));
    if (outlines.is_complete()) break;
  }
  drawing_ = outlines.drawing();
  if (drawing_.blocks() == 0) refuse_frame(frames_[0].file, "without blocks");
  points_in_file_ = outlines.points_in_file();
  point_ = outlines.points();
  place_of_block_ = outlines.places();
  cells_of_block_ = outlines.cells();
}

// The first cell of each block, which has its values; none of a block that is not there.
std::vector<std::optional<std::size_t>> RunResults::cells_of_blocks(const std::filesystem::path& path,
                                                                    const PolyData& data) const {
  const auto& block_of = need_array<std::int32_t>(path, data.cell_data, "block", 1);
  std::vector<std::optional<std::size_t>> first(drawing_.blocks());
  std::vector<std::size_t> count(drawing_.blocks(), 0);
  for (std::size_t cell = 0; cell < block_of.size(); ++cell) {
    const auto place = place_of_block_.find(block_of[cell]);
    if (place == place_of_block_.end()) refuse_frame(path, "of other blocks than the frames before");
    if (count[place->second]++ == 0) first[place->second] = cell;
  }
  for (std::size_t block = 0; block < first.size(); ++block)
    if (first[block] && count[block] != cells_of_block_[block])
      refuse_frame(path, "of other blocks than the frames before");
  return first;
}

void RunResults::add_lines(std::size_t index, std::vector<DrawnBolt>& lines) const {
  if (has_bolts()) append_lines(bolts_[index].file, read_vtp(bolts_[index].file), bolt_lines, bolt_offsets_, lines);
  if (!has_linings()) return;
  const std::filesystem::path& path = linings_[index].file;
  const PolyData data = read_vtp(path);
  const std::size_t bolts = lines.size();
  append_lines(path, data, lining_lines, lining_offsets_, lines);
  read_utilisation(path, data, std::span(lines).subspan(bolts));
}

Frame RunResults::frame(std::size_t index) const {
  const std::filesystem::path& path = frames_.at(index).file;
  const PolyData data = read_vtp(path);
  if (data.points.size() / 3 != points_in_file_) refuse_frame(path, "of other blocks than the first frame");
  const auto& displacement = need_array<double>(path, data.point_data, "displacement [m]", 3);
  const auto& xx = need_array<double>(path, data.cell_data, "stress_xx [Pa]", 1);
  const auto& yy = need_array<double>(path, data.cell_data, "stress_yy [Pa]", 1);
  const auto& xy = need_array<double>(path, data.cell_data, "stress_xy [Pa]", 1);
  const auto& velocity = need_array<double>(path, data.cell_data, "velocity [m/s]", 3);
  const auto& moved = need_array<double>(path, data.cell_data, "displacement [m]", 3);
  Frame frame;
  frame.time = data.time;
  for (const std::size_t point : point_) frame.displacement.push_back(plane(displacement, point));
  const auto cells = cells_of_blocks(path, data);
  for (std::size_t block = 0; block < cells.size(); ++block) {
    if (cells[block]) {
      const std::size_t cell = *cells[block];
      frame.stress.emplace_back(xx[cell], yy[cell], xy[cell]);
      frame.velocity.push_back(plane(velocity, cell));
      frame.moved.push_back(plane(moved, cell));
    } else {
      add_nothing(drawing_, block, frame);
    }
  }
  if (has_contacts()) frame.contacts = read_contacts(contacts_[index].file, place_of_block_);
  add_lines(index, frame.bolts);
  return frame;
}

}  // namespace dda
