#include "engine/contact/interface_elements.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "engine/builder/generators.h"
#include "engine/contact/make_contacts.h"

namespace dda {
namespace {

Model bonded_grid(int columns, int rows) {
  Model model;
  model.materials.emplace_back().name = "rock";
  model.materials[0].density = 2600;
  model.materials[0].young = 5e10;
  model.materials[0].poisson = 0.25;
  model.joints.emplace_back().bonded = true;
  model.joints[0].name = "joint";
  GridSpec grid;
  grid.columns = columns;
  grid.rows = rows;
  grid.block_width = grid.block_height = 1;
  append_grid(model, grid);
  model.stages.emplace_back().dt = 1e-5;
  model.stages[0].duration = 1e-4;
  model.stages[0].kinematics = Kinematics::small;
  finish_model(model);
  return model;
}

void expect_same(const InterfaceElement& one, const InterfaceElement& other) {
  EXPECT_EQ(one.block_a, other.block_a);
  EXPECT_EQ(one.block_b, other.block_b);
  EXPECT_EQ(one.law, other.law);
  EXPECT_EQ(one.length, other.length);
  EXPECT_EQ(one.stiffness, other.stiffness);
  EXPECT_EQ(one.rows_a, other.rows_a);
  EXPECT_EQ(one.rows_b, other.rows_b);
  EXPECT_EQ(one.stress_rows_a, other.stress_rows_a);
  EXPECT_EQ(one.stress_rows_b, other.stress_rows_b);
  EXPECT_EQ(one.strain_rows_a, other.strain_rows_a);
  EXPECT_EQ(one.strain_rows_b, other.strain_rows_b);
}

// Squares of 1 m between whole numbers: those beside each other, and those above each other.
TEST(InterfaceElements, OfAGridAreTwo) {
  const ContactSet drawn = make_contacts(bonded_grid(30, 20));
  InterfaceElements shared = drawn.elements;
  shared.share();
  EXPECT_EQ(shared.kinds().size(), 2U);
  ASSERT_EQ(shared.size(), drawn.elements.size());
  InterfaceElement room;
  for (std::size_t i = 0; i < shared.size(); ++i) {
    expect_same(shared[i], drawn.elements[i]);
    expect_same(shared.read(i, room), drawn.elements[i]);
    EXPECT_EQ(shared.but_for_blocks(i).rows_a, drawn.elements[i].rows_a);
  }
}

TEST(InterfaceElements, AreOnesOwnAgainToBeChanged) {
  const ContactSet drawn = make_contacts(bonded_grid(5, 4));
  InterfaceElements shared = drawn.elements;
  shared.share();
  EXPECT_THROW(static_cast<void>(shared.own()), std::logic_error);
  shared.edit()[3].stiffness(0) = 7;
  ASSERT_EQ(shared.own().size(), drawn.elements.size());
  for (std::size_t i = 0; i < shared.size(); ++i) {
    if (i == 3) continue;
    expect_same(shared[i], drawn.elements[i]);
  }
  EXPECT_EQ(shared[3].stiffness(0), 7);
  EXPECT_NE(drawn.elements[3].stiffness(0), 7);
}

// One bit apart is another kind, wherever that bit is.
TEST(InterfaceElements, ThatDifferInOneBitAreKept) {
  const ContactSet drawn = make_contacts(bonded_grid(5, 4));
  const auto differs = [&](const auto& change) {
    InterfaceElements changed = drawn.elements;
    change(changed.edit()[8]);
    changed.share();
    EXPECT_EQ(changed.kinds().size(), 3U);
    const InterfaceElement found = changed[8];
    InterfaceElements expected = drawn.elements;
    change(expected.edit()[8]);
    expect_same(found, expected[8]);
  };
  const auto more = [](double& number) { number = std::nextafter(number, 1e300); };
  differs([&](InterfaceElement& element) { more(element.length); });
  differs([&](InterfaceElement& element) { more(element.stiffness(3)); });
  differs([&](InterfaceElement& element) { more(element.dashpot(1)); });
  differs([&](InterfaceElement& element) { more(element.rows_a(3, 5)); });
  differs([&](InterfaceElement& element) { more(element.rows_b(0, 0)); });
  differs([&](InterfaceElement& element) { more(element.stress_rows_b(1, 2)); });
  differs([&](InterfaceElement& element) { more(element.strain_rows_a(0, 1)); });
  differs([&](InterfaceElement& element) { more(element.gap_at_start(2)); });
  differs([&](InterfaceElement& element) { more(element.force_at_start(0)); });
}

TEST(InterfaceElements, ThatAreMostlyDifferentAreNotShared) {
  ContactSet drawn = make_contacts(bonded_grid(5, 4));
  double number = 1;
  for (InterfaceElement& element : drawn.elements.edit()) element.stiffness(0) = number++;
  drawn.elements.share();
  EXPECT_EQ(drawn.elements.own().size(), drawn.interfaces.size());
}

}  // namespace
}  // namespace dda
