#include "base/power_of_ten.h"

#include <gtest/gtest.h>

#include <charconv>
#include <string>

namespace gradmesh {
namespace {

TEST(PowerOfTen, is_the_number_that_its_text_is_read_as) {
  for (int exponent = -22; exponent <= 22; ++exponent) {
    const std::string text = "1e" + std::to_string(exponent);
    double read = 0;
    std::from_chars(text.data(), text.data() + text.size(), read);
    EXPECT_EQ(power_of_ten(exponent), read) << text;
  }
}

}  // namespace
}  // namespace gradmesh
