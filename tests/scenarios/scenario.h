#pragma once

#include <gtest/gtest.h>

#include "tests/scenarios/story.h"

namespace scenarios {

/// A story that must end the same in every view: TEST_P(Scenario, ...), then instantiate with all_views().
class Scenario : public ::testing::TestWithParam<View> {};

inline std::string view_name(const ::testing::TestParamInfo<View>& view) { return name(view.param); }

}  // namespace scenarios
