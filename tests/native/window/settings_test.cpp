// What a window remembers (window/view/settings.h), and the language that it speaks
// (window/toolkit/catalogue.h).
#include "window/view/settings.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "window/toolkit/catalogue.h"

namespace gradmesh {
namespace {

/// A path of this test's own: tests run at the same time.
std::filesystem::path file_of_this_test() {
  return std::filesystem::path(testing::TempDir()) /
         (std::string("by-eye_") + testing::UnitTest::GetInstance()->current_test_info()->name());
}

TEST(Settings, are_what_was_written) {
  Settings settings{1000, 700, true, false, true, true};
  write_settings(settings, file_of_this_test());
  EXPECT_EQ(read_settings(file_of_this_test()), settings);
  settings.is_dark.reset();
  write_settings(settings, file_of_this_test());
  EXPECT_EQ(read_settings(file_of_this_test()), settings);
}

TEST(Settings, that_nobody_understands_change_nothing) {
  std::ofstream(file_of_this_test())
      << "width -5\nheight many\nlines\ndark perhaps\n\x01\xff\nnew 1\n";
  EXPECT_EQ(read_settings(file_of_this_test()), Settings());
  std::filesystem::remove(file_of_this_test());
  EXPECT_EQ(read_settings(file_of_this_test()), Settings());
  write_settings(Settings(), "");
}

TEST(Catalogues, speak_german_to_those_who_read_it_first) {
  const Message message("{0} of {1} handles", 3, 12);
  EXPECT_EQ(message.in(translation_into({"de", "en"})), "3 von 12 Anfassern");
  EXPECT_EQ(message.in(translation_into({"fr", "de"})), "3 von 12 Anfassern");
  EXPECT_EQ(message.in(translation_into({"en", "de"})), message.english());
  EXPECT_EQ(message.in(translation_into({"fr"})), message.english());
  EXPECT_EQ(message.in(translation_into({})), message.english());
}

TEST(Catalogues, that_are_damaged_leave_the_text_as_it_is) {
  std::string bytes = "\xde\x12\x04\x95";
  for (int i = 0; i < 64; ++i) {
    EXPECT_EQ(Catalogue(bytes).translated("Lines"), "Lines");
    bytes += char(255);
  }
}

}  // namespace
}  // namespace gradmesh
