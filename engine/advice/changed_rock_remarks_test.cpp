#include "engine/advice/changed_rock_remarks.h"

#include <gtest/gtest.h>

#include "engine/model/settings.h"

namespace dda {
namespace {

// A stage as the scene gives it, one with `young` (Pa), and one after it that changes nothing.
Model with_young(double young, bool is_static) {
  Model model;
  model.materials = {{"rock", 2600, 10e9, 0.2, PlaneState::stress}};
  model.stages.resize(3);
  model.stages[0].name = "first";
  model.stages[1].name = "loosened";
  model.stages[2].name = "after";
  model.stages[1].rock.materials = model.materials;
  model.stages[1].rock.materials[0].young = young;
  if (is_static)
    for (Stage& stage : model.stages) stage.integrator = static_integrator();
  return model;
}

TEST(ChangedRockRemarks, AreOnEachDynamicStageWithOtherModuli) {
  const std::vector<std::string> remarks = changed_rock_remarks(with_young(5e9, false));
  ASSERT_EQ(remarks.size(), 2);
  EXPECT_EQ(
      remarks[0],
      "stage \"loosened\" has other moduli or densities than the scene begins with: what is foretold of waves, and a "
      "dt that is chosen, go by those of the start");
  EXPECT_EQ(remarks[1].substr(0, 13), "stage \"after\"");
}

TEST(ChangedRockRemarks, AreNotOnStaticStagesOrTheSameModuli) {
  EXPECT_TRUE(changed_rock_remarks(with_young(5e9, true)).empty());
  EXPECT_TRUE(changed_rock_remarks(with_young(10e9, false)).empty());
}

TEST(ChangedRockRemarks, AreOnRockSofterThanSoil) {
  const std::vector<std::string> remarks = changed_rock_remarks(with_young(20, true));
  ASSERT_EQ(remarks.size(), 1);
  EXPECT_EQ(remarks[0],
            "stage \"loosened\": young of material \"rock\" becomes 20 Pa, softer than any soil (1 MPa); rock has some "
            "GPa");
}

}  // namespace
}  // namespace dda
