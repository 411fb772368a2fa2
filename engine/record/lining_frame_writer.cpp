#include "engine/record/lining_frame_writer.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "engine/model/state.h"

namespace dda {
namespace {

void append(std::vector<double>& values, const Vec2& vector) {
  values.insert(values.end(), {vector.x(), vector.y(), 0});
}

}  // namespace

LiningFrameWriter::LiningFrameWriter(const Model& model, std::filesystem::path index)
    : model_(model), series_(std::move(index)) {
  std::vector<std::int32_t> linings, elements, blocks_a, blocks_b;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < model.linings.size(); ++i) {
    const Lining& lining = model.linings[i];
    for (std::size_t j = 0; j < lining.elements(); ++j) {
      for (const LiningNode* node : {&lining.start_of(j), &lining.end_of(j)}) {
        data_.lines.connectivity.push_back(static_cast<std::int64_t>(points_.size()));
        points_.push_back(node);
      }
      data_.lines.offsets.push_back(static_cast<std::int64_t>(points_.size()));
      linings.push_back(static_cast<std::int32_t>(i));
      elements.push_back(static_cast<std::int32_t>(j));
      blocks_a.push_back(lining.start_of(j).block);
      blocks_b.push_back(lining.end_of(j).block);
      names.push_back(lining.name);
    }
  }
  data_.cell_data = {{"lining", 1, std::move(linings)},
                     {"element", 1, std::move(elements)},
                     {"lining_name", 1, std::move(names)},
                     {"block_a", 1, std::move(blocks_a)},
                     {"block_b", 1, std::move(blocks_b)}};
}

void LiningFrameWriter::write(const State& state, std::span<const LiningValues> elements) {
  PolyData data = data_;
  data.time = state.time;
  std::vector<double> moved;
  for (const LiningNode* node : points_) {
    append(data.points, current_position(model_, state, node->block, node->point));
    append(moved, point_displacement(model_, state, node->block, node->point));
  }
  data.point_data = {{"displacement [m]", 3, std::move(moved)}};
  const auto add = [&](const char* name, auto value) {
    data.cell_data.push_back(numbers_of<double>(name, elements, value));
  };
  data.cell_data.push_back(
      numbers_of<std::int32_t>("status", elements, [](const auto& each) { return each.condition; }));
  add("thrust [N]", [](const auto& each) { return each.thrust; });
  add("moment [N m]", [](const auto& each) { return each.moment; });
  add("shear [N]", [](const auto& each) { return each.shear; });
  add("utilisation", [](const auto& each) { return each.utilisation; });
  series_.add(data);
}

}  // namespace dda
