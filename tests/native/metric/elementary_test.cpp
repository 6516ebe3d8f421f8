#include <gtest/gtest.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>

#include "metric/elementary-inl.h"

namespace gradmesh {
namespace {

// metric_test shows that the other targets give the same bits as this one.
TEST(Elementary, functions_agree_with_the_standard_library) {
  namespace simd = HWY_NAMESPACE;
  const hwy::HWY_NAMESPACE::CappedTag<float, 1> d;
  for (double exact = 1e-37; exact < 1e5; exact *= 1.0173) {
    const auto x = float(exact);
    const double root = GetLane(simd::cube_root(d, Set(d, x)));
    ASSERT_NEAR(root / std::cbrt(double(x)), 1, 3e-7) << x;
    const double logarithm = GetLane(simd::log2_positive(d, Set(d, x)));
    const double expected = std::log2(double(x));
    ASSERT_NEAR(logarithm, expected, 2e-7 * std::max(1.0, std::abs(expected))) << x;
    const auto y = float(std::remainder(exact, 254));
    ASSERT_NEAR(GetLane(simd::exp2_bounded(d, Set(d, y))) / std::exp2(double(y)), 1, 3e-7) << y;
  }
  EXPECT_EQ(GetLane(simd::log2_positive(d, Set(d, 1.0F))), 0);
  EXPECT_EQ(GetLane(simd::exp2_bounded(d, Zero(d))), 1);
}

}  // namespace
}  // namespace gradmesh
