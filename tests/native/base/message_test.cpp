#include <gtest/gtest.h>

#include "base/error.h"

namespace gradmesh {
namespace {

TEST(Message, puts_its_arguments_into_their_places) {
  EXPECT_EQ(Message("nothing to add").english(), "nothing to add");
  EXPECT_EQ(Message("{1} of {0}, {1} more", 12, "3").english(), "3 of 12, 3 more");
  // What is put in is no template, whatever it holds.
  EXPECT_EQ(Message("{0}{1}", "{1}", std::string("}")).english(), "{1}}");
}

TEST(Message, holds_messages) {
  const Message place("row {0}", std::size_t(2));
  EXPECT_EQ(Message("{0}: {1} is wrong", place, "it").english(), "row 2: it is wrong");
}

TEST(Message, keeps_the_template_and_what_goes_into_it) {
  const Message message("{0}: {1}", Message("row {0}", 7), std::string("why"));
  EXPECT_STREQ(message.text(), "{0}: {1}");
  ASSERT_EQ(message.arguments().size(), 2u);
  EXPECT_STREQ(std::get<Message>(message.arguments()[0]).text(), "row {0}");
  EXPECT_EQ(std::get<std::string>(message.arguments()[1]), "why");
}

TEST(Message, is_said_in_another_language) {
  const Translation german = [](const std::string& text) -> std::string {
    return text == "row {0}" ? "Zeile {0}" : "{1} in {0}";
  };
  const Message message("{0} has {1}", Message("row {0}", 7), "it");
  EXPECT_EQ(message.in(german), "it in Zeile 7");
  // What a translator has got wrong is shown as it is.
  const Translation wrong = [](const std::string&) { return "{1} {0 {x} {"; };
  EXPECT_EQ(Message("row {0}", 7).in(wrong), "{1} {0 {x} {");
}

TEST(InputError, says_its_message_in_english) {
  const InputError error("{0}: {1}.", "file.svg", Message("it is empty"));
  EXPECT_STREQ(error.what(), "file.svg: it is empty.");
  EXPECT_STREQ(error.message().text(), "{0}: {1}.");
}

}  // namespace
}  // namespace gradmesh
