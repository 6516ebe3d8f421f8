#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>

#include "metric_images.h"

namespace gradmesh {
namespace {

TEST(MetricWeights, multiply_the_distance_of_a_pixel) {
  test::RandomImages random(21);
  const Image reference = random.gradient(90, 70), test = random.edited(reference);
  for (const MetricKind kind : test::all_kinds) {
    const Plane plain = make_metric(kind, reference)->map(test);
    Plane weights(90, 70);
    for (float& weight : weights.samples) weight = float(random.from(1, 16)) / 4;
    Plane product = plain;
    for (std::size_t i = 0; i < product.samples.size(); ++i)
      product.samples[i] *= weights.samples[i];
    EXPECT_GT(sum(product, product.window()), 0);
    const auto weighted = [&](const Plane& plane) {
      return make_metric(kind, reference, std::make_shared<const Plane>(plane))->map(test);
    };
    test::expect_equal_bits(weighted(weights), product);
    test::expect_equal_bits(weighted(Plane(90, 70, 1)), plain);
    EXPECT_THROW(weighted(Plane(70, 90, 1)), std::invalid_argument);
  }
}

}  // namespace
}  // namespace gradmesh
