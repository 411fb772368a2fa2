#include "engine/record/bolt_frame_writer.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace dda {

BoltFrameWriter::BoltFrameWriter(const Model& model, std::filesystem::path index)
    : model_(model), series_(std::move(index)) {
  std::vector<std::int32_t> bolts, links, blocks_a, blocks_b;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < model.bolts.size(); ++i) {
    const Bolt& bolt = model.bolts[i];
    for (std::size_t j = 0; j < bolt.links.size(); ++j) {
      const BoltLink& link = bolt.links[j];
      add_line(link, bolt.direction);
      bolts.push_back(static_cast<std::int32_t>(i));
      links.push_back(static_cast<std::int32_t>(j));
      blocks_a.push_back(link.block_a);
      blocks_b.push_back(link.block_b);
      names.push_back(bolt.name);
    }
  }
  data_.cell_data = {{"bolt", 1, std::move(bolts)},
                     {"link", 1, std::move(links)},
                     {"bolt_name", 1, std::move(names)},
                     {"block_a", 1, std::move(blocks_a)},
                     {"block_b", 1, std::move(blocks_b)}};
}

void BoltFrameWriter::add_line(const BoltLink& link, const Vec2& direction) {
  const auto add_point = [this](int block, const Vec2& reference) { lines_.add_point(block, reference, data_); };
  if (link.reach_a > 0) add_point(link.block_a, link.point_a - link.reach_a * direction);
  add_point(link.block_a, link.point_a);
  add_point(link.block_b, link.point_b);
  if (link.reach_b > 0) add_point(link.block_b, link.point_b + link.reach_b * direction);
  lines_.end_line(data_);
}

void BoltFrameWriter::write(const State& state, std::span<const BoltLinkValues> links) {
  PolyData data = data_;
  data.time = state.time;
  lines_.place(model_, state, data);
  data.cell_data.push_back(numbers_of<std::int32_t>("status", links, [](const auto& link) { return link.condition; }));
  data.cell_data.push_back(
      numbers_of<double>("axial_force [N]", links, [](const auto& link) { return link.force(0); }));
  data.cell_data.push_back(
      numbers_of<double>("shear_force [N]", links, [](const auto& link) { return link.force(1); }));
  data.cell_data.push_back(
      numbers_of<double>("elongation [m]", links, [](const auto& link) { return link.elongation; }));
  series_.add(data);
}

}  // namespace dda
