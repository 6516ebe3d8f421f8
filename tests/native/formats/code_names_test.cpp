// Names of meshes in code: whatever the ids, identifiers of both languages, and all different.
#include "formats/code/code_names.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <regex>
#include <set>

#include "formats/code/code_text.h"

using namespace gradmesh;

namespace {

const std::regex identifier("[A-Z][A-Za-z0-9_]*");

std::string small_letters(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return text;
}

/// Returns a random text of pieces that names stumble over.
std::string random_id(std::mt19937& random) {
  static const std::vector<std::string> pieces{
      "a",   "b",   "B",  "mesh", "data",         "Data", "1",    "2",    "_2",
      "-",   "_",   " ",  "\n",   "*/",           "//",   "\"",   "\\",   "${",
      "`",   "é",   "Ω",  "\xff", "\xe2\x80\xa8", "self", "Type", "View", "box",
      "any", "int", "0x", "."};
  std::string id;
  for (auto count = random() % 4; count > 0; --count) id += pieces[random() % pieces.size()];
  return id;
}

}  // namespace

TEST(CodeNames, are_made_of_letters_and_digits_of_ids) {
  CodeNames names;
  EXPECT_EQ(names.take("page-1-mesh-2"), "Page1Mesh2");
  EXPECT_EQ(names.take("sky"), "Sky");
  EXPECT_EQ(names.take("leftWing"), "LeftWing");
  EXPECT_EQ(names.take("3d"), "Mesh3d");
  EXPECT_EQ(names.take(""), "Mesh1");
  EXPECT_EQ(names.take("\xc3\xa4-b"), "B");
}

TEST(CodeNames, differ_by_more_than_capitals) {
  CodeNames names;
  EXPECT_EQ(names.take("box1"), "Box1");
  EXPECT_EQ(names.take("Box-1"), "Box1_2");
  EXPECT_EQ(names.take("BOX1"), "BOX1_3");
  EXPECT_EQ(names.take("wing"), "Wing");
  EXPECT_EQ(names.take("wing-data"), "WingData2");
  EXPECT_EQ(names.take("WingData"), "WingData3");
}

TEST(CodeNames, hide_nothing_of_the_toolkits) {
  CodeNames names;
  EXPECT_EQ(names.take("view"), "ViewMesh");
  EXPECT_EQ(names.take("self"), "SelfMesh");
  EXPECT_EQ(names.take("Circle"), "CircleMesh");
}

TEST(CodeNames, are_identifiers_whatever_the_ids) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    std::mt19937 random(seed);
    CodeNames names, again;
    std::set<std::string> all;
    std::vector<std::string> ids;
    for (int i = 0; i < 40; ++i) ids.push_back(random_id(random));
    for (const std::string& id : ids) {
      const std::string name = names.take(id);
      EXPECT_TRUE(std::regex_match(name, identifier)) << seed << ": " << name;
      EXPECT_LE(name.size(), 64U);
      EXPECT_TRUE(all.insert(small_letters(name)).second) << seed << ": " << name;
      EXPECT_TRUE(all.insert(small_letters(name) + "data").second) << seed << ": " << name;
      EXPECT_EQ(again.take(id), name) << seed;
    }
  }
}

TEST(CodeNames, of_long_ids_are_short) {
  CodeNames names;
  EXPECT_LT(names.take(std::string(10000, 'a')).size(), 64U);
  EXPECT_LT(names.take(std::string(10000, 'a')).size(), 64U);
}

TEST(CodeText, of_comments_stays_in_its_line) {
  EXPECT_EQ(comment_text("a\nb\r\tc"), "a?b??c");
  EXPECT_EQ(comment_text("*/ /* x"), "*? /? x");
  EXPECT_EQ(comment_text("\xe2\x80\xa8\xe2\x80\xae|\xff\xc3"), "??|??");
  EXPECT_EQ(comment_text("\xc3\xa4.svg"), "\xc3\xa4.svg");
  EXPECT_LT(comment_text(std::string(1000, '*')).size(), 100U);
}

TEST(CodeText, has_short_numbers) {
  EXPECT_EQ(code_number(code_steps(0.25)), "0.25");
  EXPECT_EQ(code_number(code_steps(1 - 1e-9)), "1");
  EXPECT_EQ(code_number(code_steps(-1e-9)), "0");
  EXPECT_EQ(code_number(code_steps(-0.00001)), "-0.00001");
  EXPECT_EQ(code_number(code_steps(12.5)), "12.5");
  EXPECT_EQ(code_color({1, 0.5, 0, 1}), "0xFFFF8000");
}
