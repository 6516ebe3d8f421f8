// The table of formats: whatever is in it can be told apart, read and made.
#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

#include "app/document/document.h"
#include "app/document/formats.h"
#include "app/pages/read_document.h"
#include "app/runs/convert.h"

using namespace gradmesh;

namespace {

std::unique_ptr<Document> sample() {
  return read_document(GRADMESH_SOURCE_DIR "/samples/ellipse.svg");
}

}  // namespace

TEST(Formats, differ_in_name_and_extension) {
  std::set<std::string> names, extensions;
  for (const Format& format : all_formats()) {
    EXPECT_TRUE(names.insert(format.name).second) << format.name;
    EXPECT_TRUE(extensions.insert(format.extension).second) << format.extension;
    if (format.compressed_extension) {
      EXPECT_TRUE(extensions.insert(*format.compressed_extension).second) << format.name;
    }
    EXPECT_FALSE(format.color_models.empty()) << format.name;
  }
}

TEST(Formats, are_found_by_name_and_extension) {
  for (const Format& format : all_formats()) {
    EXPECT_EQ(&format_named(format.name), &format);
    EXPECT_EQ(format_of("folder/mesh" + format.extension), &format);
    if (format.compressed_extension) {
      EXPECT_EQ(format_of("mesh" + *format.compressed_extension), &format);
    }
  }
  EXPECT_EQ(format_of("mesh.png"), nullptr);
  EXPECT_EQ(format_of("mesh"), nullptr);
  EXPECT_THROW(format_named("png"), std::invalid_argument);
}

TEST(Formats, recognise_what_they_write) {
  const auto svg = sample();
  for (const Format& format : all_formats()) {
    std::string bytes = svg->bytes();
    if (format != svg->format())
      bytes = convert(*svg, svg->meshes().front(), format, {}).document->bytes();
    for (const Format& other : all_formats())
      EXPECT_EQ(other.recognises(bytes), other == format) << other.name << ", " << format.name;
    // Whatever the name of the file promises.
    EXPECT_EQ(format_of_content(bytes, "mesh.svg"), format);
    EXPECT_EQ(parse_document(bytes, "mesh")->format(), format);
  }
}

TEST(Formats, of_content_that_none_recognises_is_what_the_name_promises) {
  for (const Format& format : all_formats())
    EXPECT_EQ(format_of_content("", "mesh" + format.extension), format);
  EXPECT_EQ(format_of_content("", "mesh"), all_formats().front());
}

TEST(Formats, hold_the_colours_of_their_meshes) {
  const auto svg = sample();
  for (const Format& format : all_formats()) {
    EXPECT_TRUE(format.holds(format.color_models.front())) << format.name;
    if (format == svg->format()) continue;
    const Conversion made = convert(*svg, svg->meshes().front(), format, {});
    const Mesh& mesh = made.document->mesh(made.document->meshes().front());
    EXPECT_EQ(mesh.color_model(), made.document->color_model()) << format.name;
  }
}
