#pragma once

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "formats/pdf/color/function.h"

namespace gradmesh {

inline constexpr double infinite = std::numeric_limits<double>::infinity();
inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

using Numbers = std::vector<double>;
using Ranges = std::vector<ValueRange>;

inline void expect_numbers(const Numbers& found, const Numbers& expected, double tolerance = 1e-9) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i], expected[i], tolerance) << "value " << i;
}

}  // namespace gradmesh
