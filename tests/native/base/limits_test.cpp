#include "base/limits.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace gradmesh {
namespace {

TEST(Limits, a_text_sets_those_that_it_names) {
  EXPECT_EQ(limits_from(""), Limits());
  Limits expected;
  expected.patches = 123;
  expected.memory = std::uint64_t(3) << 30;
  expected.document = 5 << 10;
  EXPECT_EQ(limits_from("patches=123,memory=3G,document=5K"), expected);
  expected = {};
  expected.nesting = 5000;
  expected.links = 7 << 20;
  EXPECT_EQ(limits_from("nesting=5000,links=7M"), expected);
}

TEST(Limits, what_cannot_be_understood_is_refused_by_name) {
  for (const std::string wrong :
       {"patches", "patches=", "patches=0", "patches=-1", "patches=1.5", "patches=many", "=5",
        "patches=5T", "depth=5", "nesting=5001", "nesting=5K", "resolution=16385",
        "memory=18446744073709551616", "memory=17179869184G"})
    try {
      limits_from("links=5," + wrong);
      ADD_FAILURE() << wrong;
    } catch (const std::invalid_argument& error) {
      const std::string said = error.what();
      EXPECT_NE(said.find('"' + wrong + '"'), said.npos) << said;
      EXPECT_NE(said.find("document, patches, nesting"), said.npos) << said;
    }
}

TEST(Limits, the_sentence_says_how_to_raise_it) {
  EXPECT_EQ(beyond_limit("patches", 20000, 25000).english(),
            "more than the limit of 20000, which GRADMESH_LIMITS=patches=25000 raises");
}

}  // namespace
}  // namespace gradmesh
