// Damping of the material that cannot be: each gives one sentence.
#include <gtest/gtest.h>

#include <vector>

#include "engine/scene/bad_scene_test_support.h"

namespace dda {
namespace {

class BadDamping : public testing::TestWithParam<Spoiled> {};

TEST_P(BadDamping, NamesFileFieldAndValue) { expect_refusal(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Values, BadDamping,
                         testing::ValuesIn(std::vector<Spoiled>{
                             {"damping at no frequency",
                              R"("duration": 0.01)",
                              R"("duration": 0.01, "damping": {"ratio": 0.02})",
                              {"steps.damping is", "expected either \"frequency\" or \"frequencies\""}},
                             {"damping beyond critical",
                              R"("duration": 0.01)",
                              R"("duration": 0.01, "damping": {"ratio": 1.5, "frequency": 100})",
                              {"steps.damping.ratio is 1.5", "below 1"}},
                             {"damping with frequencies turned round",
                              R"("duration": 0.01)",
                              R"("duration": 0.01, "damping": {"ratio": 0.1, "frequencies": [200, 20]})",
                              {"steps.damping.frequencies is", "the lower one first"}},
                             {"damping at rest",
                              R"("duration": 0.01)",
                              R"("duration": 0.01, "integrator": "static", "damping": {"ratio": 0.1, "frequency": 20})",
                              {"steps.damping is", "static stage"}},
                             {"damping where geometry moves",
                              R"("duration": 0.01)",
                              R"("duration": 0.01, "damping": {"ratio": 0.1, "frequency": 20})",
                              {"damping is given", "small kinematics"}}}));

}  // namespace
}  // namespace dda
