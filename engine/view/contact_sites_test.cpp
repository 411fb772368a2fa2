#include "engine/view/contact_sites.h"

#include <gtest/gtest.h>

#include "engine/view/view_test_support.h"

namespace dda {
namespace {

class ContactSitesTest : public testing::Test {
 protected:
  static DrawnContact at(int a, int b, const Vec2& reference) {
    DrawnContact contact;
    contact.block_a = a;
    contact.block_b = b;
    contact.reference = reference;
    return contact;
  }

  [[nodiscard]] Vec2 place(const ContactSite& site) const {
    const auto& points = results_.drawing().reference;
    return points[site.from] + site.fraction / 65536.0 * (points[site.to] - points[site.from]);
  }

  [[nodiscard]] const std::filesystem::path& written() const {
    write_run(folder_.path(), model_to_view(), {0});
    return folder_.path();
  }

  TemporaryFolder folder_;
  RunResults results_{written()};
};

TEST_F(ContactSitesTest, LieOnTheOutlineOfTheSecondBlock) {
  ContactSites sites(results_.drawing());
  const Vec2 points[] = {
      {6, 0.7}, {9, 3}, {7, 1.25}, {8, 2}, {6, 0}};  // edges and corners of block 2, its hole included
  for (const Vec2& point : points) {
    const std::uint32_t number = sites.number_of(at(1, 2, point));
    const ContactSite& found = sites.sites()[number];
    EXPECT_EQ(found.block_a, 1U);
    EXPECT_EQ(found.block_b, 2U);
    EXPECT_LE((place(found) - point).norm(), 3.0 / 65536);  // half a step of an edge of 3 m, with room
    EXPECT_LT(found.fraction, 65536U);
  }
  EXPECT_EQ(sites.sites().size(), 5U);
}

TEST_F(ContactSitesTest, AreTheSameForTheSamePlace) {
  ContactSites sites(results_.drawing());
  const auto corner = sites.number_of(at(0, 2, Vec2(6, 0)));
  EXPECT_EQ(sites.number_of(at(0, 2, Vec2(6 + 1e-13, -1e-13))), corner);  // from the edge before and behind the corner
  EXPECT_EQ(sites.number_of(at(0, 2, Vec2(6 - 1e-13, 1e-13))), corner);
  EXPECT_NE(sites.number_of(at(1, 2, Vec2(6, 0))), corner);
  EXPECT_EQ(sites.sites().size(), 2U);
}

}  // namespace
}  // namespace dda
