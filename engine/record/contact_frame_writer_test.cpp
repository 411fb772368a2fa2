#include "engine/record/contact_frame_writer.h"

#include <gtest/gtest.h>

#include "engine/record/record_test_support.h"
#include "engine/record/vtp_test_reader.h"

namespace dda {
namespace {

std::vector<ContactPoint> two_contacts() {
  ContactPoint first;
  first.block_a = 0;
  first.block_b = 3;
  first.reference = Vec2(1, 2);
  first.point = Vec2(1.5, 1.75);
  first.normal = Vec2(0, 1);
  first.normal_force = -4;  // compression
  first.shear_force = 3;
  first.status = ContactStatus::sliding;
  ContactPoint second = first;
  second.block_b = 2;
  second.normal_force = second.shear_force = 0;
  second.status = ContactStatus::open;
  return {first, second};
}

TEST(ContactFrameWriter, EveryContactIsAPointWithItsForceAndStatus) {
  const TemporaryFolder folder;
  ContactFrameWriter(folder / "contacts.pvd").write(0.25, two_contacts());
  const VtpReader vtp(folder / "contacts/000000.vtp");
  EXPECT_EQ(vtp.count("NumberOfPoints"), 2U);
  EXPECT_EQ(vtp.count("NumberOfVerts"), 1U);
  EXPECT_EQ(vtp.array("Verts/connectivity"), (std::vector<double>{0, 1}));
  EXPECT_EQ(vtp.array("Verts/offsets"), std::vector<double>{2});
  EXPECT_EQ(vtp.array("FieldData/TimeValue"), std::vector<double>{0.25});
  EXPECT_EQ(vtp.array("Points/Points"), (std::vector<double>{1.5, 1.75, 0, 1.5, 1.75, 0}));
  EXPECT_EQ(vtp.point("displacement [m]"), (std::vector<double>{0.5, -0.25, 0, 0.5, -0.25, 0}));
  EXPECT_EQ(vtp.point("block_a"), (std::vector<double>{0, 0}));
  EXPECT_EQ(vtp.point("block_b"), (std::vector<double>{3, 2}));
  EXPECT_EQ(vtp.point("status"), (std::vector<double>{1, 2}));
  EXPECT_EQ(vtp.point("normal_force [N/m]"), (std::vector<double>{-4, 0}));
  EXPECT_EQ(vtp.point("shear_force [N/m]"), (std::vector<double>{3, 0}));
  // Normal up, tangent to the left: compression 4 pushes b up by 4, shear 3 pulls it to the right.
  EXPECT_EQ(vtp.point("force [N/m]"), (std::vector<double>{3, 4, 0, 0, 0, 0}));
}

TEST(ContactFrameWriter, NoContacts) {
  const TemporaryFolder folder;
  ContactFrameWriter(folder / "contacts.pvd").write(0, {});
  const VtpReader vtp(folder / "contacts/000000.vtp");
  EXPECT_EQ(vtp.count("NumberOfPoints"), 0U);
  EXPECT_EQ(vtp.count("NumberOfVerts"), 0U);
}

}  // namespace
}  // namespace dda
