// The order of numbers is that of the comments and of the code in the first published version of ntdda
// (src/analysisreader.c), which still has the questions that df asked and says which of its numbers it leaves out:
//
//   0 static, 1 dynamic; steps; block materials; joint materials; largest displacement of a step over half the height;
//   longest step; stiffness of contacts (*); rows of the table of each fixed and load point, 0 or 2 and more (*); time,
//   x and y of each row (*); density, unit weight, Young's modulus, Poisson's ratio, 3 stresses, 3 more of them, 2
//   velocities and a spin of each block material; friction angle in degrees, cohesion and tensile strength of each
//   joint material
//
// DDA for Windows leaves (*) out.
#include "engine/drawing/run_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "engine/core/error.h"
#include "engine/core/read_file.h"
#include "engine/drawing/line_drawing.h"
#include "engine/drawing/number_list.h"

namespace dda {
namespace {

constexpr std::size_t in_head = 6;
constexpr std::size_t in_block_material = 13;
constexpr std::size_t in_joint_material = 3;
constexpr std::size_t in_row = 3;

std::size_t count_numbers(std::string_view text, const std::string& name) {
  NumberList numbers(text, name);
  std::size_t count = 0;
  for (; !numbers.at_end(); ++count) numbers.number("a number of run data");
  return count;
}

class RunDataReader {
 public:
  RunDataReader(std::string_view text, const std::string& name, int points)
      : numbers_(text, name), points_(static_cast<std::size_t>(points)), count_(count_numbers(text, name)) {
    data_.name = name;
  }

  RunData read() {
    read_head();
    const std::size_t materials = in_block_material * block_materials_ + in_joint_material * joint_materials_;
    const bool is_short = count_ == in_head + materials;
    if (!is_short) {
      if (count_ < in_head + 1 + points_ + materials) refuse_count(materials);
      data_.spring = not_negative("the stiffness of contacts");
      read_tables(materials);
    }
    for (std::size_t i = 0; i < block_materials_; ++i) read_block_material();
    for (std::size_t i = 0; i < joint_materials_; ++i) read_joint_material();
    return std::move(data_);
  }

 private:
  void read_head() {
    data_.velocity_share = numbers_.number("static or dynamic");
    if (data_.velocity_share < 0 || data_.velocity_share > 1)
      refuse(fmt::format("{:g} for static or dynamic", data_.velocity_share), "0 for static, 1 for dynamic");
    data_.steps = numbers_.whole("the number of steps", 1);
    block_materials_ = static_cast<std::size_t>(numbers_.whole("the number of block materials", 1));
    joint_materials_ = static_cast<std::size_t>(numbers_.whole("the number of joint materials", 1));
    data_.displacement_ratio = numbers_.number("the largest displacement of a step");
    if (data_.displacement_ratio <= 0 || data_.displacement_ratio >= 1)
      refuse(fmt::format("{:g} for the largest displacement of a step", data_.displacement_ratio),
             "a share of half the height, above 0 and below 1");
    data_.longest_step = not_negative("the longest step");
  }

  void read_tables(std::size_t materials) {
    std::vector<std::size_t> rows;
    std::size_t all = 0;
    for (std::size_t i = 0; i < points_; ++i) {
      const int count = numbers_.whole("the number of rows of a point");
      if (count == 1) refuse("1 for the number of rows of a point", "0, or 2 and more");
      rows.push_back(static_cast<std::size_t>(count));
      all += rows.back();
    }
    if (count_ != in_head + 1 + points_ + in_row * all + materials) refuse_count(materials);
    for (const std::size_t count : rows) read_table(count);
  }

  void read_table(std::size_t rows) {
    PointTable table;
    for (std::size_t i = 0; i < rows; ++i) {
      std::array<double, in_row> row{};
      for (double& value : row) value = numbers_.number("a row of a point");
      if (i == 0) table.origin = numbers_.here();
      if (i > 0 && row[0] <= table.rows.back()[0])
        refuse(fmt::format("the time {:g} behind {:g}", row[0], table.rows.back()[0]), "times that grow");
      table.rows.push_back(row);
    }
    data_.points.push_back(std::move(table));
  }

  void read_block_material() {
    BlockMaterialData material;
    material.density = positive("the density");
    material.origin = numbers_.here();
    material.unit_weight = numbers_.number("the unit weight");
    material.young = positive("Young's modulus");
    material.poisson = numbers_.number("Poisson's ratio");
    for (double& stress : material.stress) stress = numbers_.number("a stress");
    for (int i = 0; i < 3; ++i) expect_nothing();
    for (double& velocity : material.velocity) velocity = numbers_.number("a velocity");
    material.spin = numbers_.number("the spin");
    data_.materials.push_back(std::move(material));
  }

  // Stresses that grow with the height, strains or a damping: versions do not agree.
  void expect_nothing() {
    const double value = numbers_.number("the numbers behind the stresses");
    if (value != 0)
      refuse(fmt::format("{:g} behind the stresses of a block material", value),
             "0, as versions of df take these three numbers for different things");
  }

  void read_joint_material() {
    JointMaterialData joint;
    joint.friction_deg = not_negative("a friction angle");
    joint.origin = numbers_.here();
    if (joint.friction_deg >= 90)
      refuse(fmt::format("{:g} for a friction angle", joint.friction_deg), "below 90 degrees");
    joint.cohesion = not_negative("a cohesion");
    joint.tension = not_negative("a tensile strength");
    data_.joints.push_back(std::move(joint));
  }

  double not_negative(const char* what) {
    const double value = numbers_.number(what);
    if (value < 0) refuse(fmt::format("{:g} for {}", value, what), "0 or more");
    return value;
  }

  double positive(const char* what) {
    const double value = numbers_.number(what);
    if (value <= 0) refuse(fmt::format("{:g} for {}", value, what), "more than 0");
    return value;
  }

  [[noreturn]] void refuse(const std::string& value, const std::string& expected) const {
    throw InputError("", numbers_.here(), value, expected);
  }

  [[noreturn]] void refuse_count(std::size_t materials) const {
    throw InputError(
        "", data_.name,
        fmt::format(
            "{} numbers for {} block and {} joint materials, {} points that are fixed or loaded, and their tables",
            count_, block_materials_, joint_materials_, points_),
        fmt::format("{}, or {} and three for each row of a table: files of other versions of df have others",
                    in_head + materials, in_head + 1 + points_ + materials));
  }

  NumberList numbers_;
  std::size_t points_;
  std::size_t count_;
  std::size_t block_materials_ = 0, joint_materials_ = 0;
  RunData data_;
};

}  // namespace

RunData read_run_data(std::string_view text, const std::string& name, int points) {
  return RunDataReader(text, name, points).read();
}

RunData read_run_data(const std::filesystem::path& file, int points) {
  const std::string name = readable(file.string());
  try {
    return read_run_data(read_file(file, most_input_bytes), name, points);
  } catch (const UnreadableFile& error) {
    throw InputError("", name, error.why(), "run data for df");
  }
}

}  // namespace dda
