#include "engine/advice/spin_remarks.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "engine/advice/remarks.h"
#include "engine/contact/make_contacts.h"

namespace dda {
namespace {

// A block of 1.4 by 0.6 m that spins.
Model spinning(double spin, const Integrator& integrator) {
  Model model;
  model.materials = {{"rock", 2500, 20e9, 0.25, PlaneState::stress}};
  model.joints = {JointMaterial{}};
  Block block;
  block.name = "wheel";
  block.shape.outer = {{0, 0}, {1.4, 0}, {1.4, 0.6}, {0, 0.6}};
  block.initial_spin = spin;
  model.blocks = {block};
  Stage stage;
  stage.dt = 5e-5;
  stage.duration = 1e-2;
  stage.integrator = integrator;
  model.stages = {stage};
  finish_model(model);
  return model;
}

std::vector<std::string> remarks(const Model& model) { return spin_remarks(model, make_contacts(model)); }

bool says(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

// rho omega^2 L^2/12 is 16.3 MPa, which spin_test.cpp finds in runs.
TEST(SpinRemarks, TellTheStressOfWhatBeginsWithoutIt) {
  const auto found = remarks(spinning(200, trapezoidal_integrator()));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(says(found[0], "\"wheel\"")) << found[0];
  EXPECT_TRUE(says(found[0], "16.3 MPa")) << found[0];
  EXPECT_TRUE(says(found[0], "trapezoidal damps nothing")) << found[0];
  EXPECT_FALSE(says(remarks(spinning(200, generalized_alpha_integrator(0.5))).at(0), "damps nothing"));
}

TEST(SpinRemarks, AreSilentWhereItIsLittleOrThere) {
  EXPECT_TRUE(remarks(spinning(40, trapezoidal_integrator())).empty());  // 0.65 MPa
  Model settled = spinning(200, trapezoidal_integrator());
  settled.blocks[0].initial_stress = {2500 * 4e4 * 1.96 / 12, 2500 * 4e4 * 0.36 / 12, 0};
  EXPECT_TRUE(remarks(settled).empty());
  Model small = spinning(200, trapezoidal_integrator());
  small.stages[0].kinematics = Kinematics::small;
  EXPECT_TRUE(remarks(small).empty());
}

// They lost it without a word.
TEST(SpinRemarks, TellWhatAStaticStageTakes) {
  const auto says_lost = [](const Model& model, const char* blocks) {
    const std::string sentence = fmt::format("the motion with which {} should start is lost", blocks);
    return std::ranges::count_if(remarks_on(model, make_contacts(model)), [&](const std::string& text) {
      return says(text, sentence.c_str()) && says(text, "stage \"settle\" is the first and static");
    });
  };
  Model model = spinning(200, static_integrator());
  model.stages[0].name = "settle";
  EXPECT_EQ(says_lost(model, "block \"wheel\""), 1);
  model.blocks.resize(3, model.blocks[0]);
  model.blocks[1].initial_spin = model.blocks[2].initial_spin = 0;
  model.blocks[1].initial_strain_rate = {1e-3, 0, 0};
  EXPECT_EQ(says_lost(model, "block \"wheel\" and 1 more"), 1);
  model.stages[0].integrator = trapezoidal_integrator();
  EXPECT_EQ(says_lost(model, "block \"wheel\" and 1 more"), 0);
}

}  // namespace
}  // namespace dda
