// Strokes that meshes of pages paint, as objects of SVG.
#include <gtest/gtest.h>

#include "app/document/document.h"
#include "app/pages/page_documents.h"
#include "app/pages/read_document.h"
#include "base/error.h"
#include "pdf_shadings.h"

namespace gradmesh {
namespace {

/// The SVG of a page of 72 x 72 points, on which a mesh covers 72 x 72 points, y up, and which has
/// this content once the mesh is what strokes.
std::string svg_of(const std::string& content) {
  const std::string document =
      pdf_document("/MediaBox [0 0 72 72] /Resources << /Pattern << /p 6 0 R >> >>",
                   "/Pattern CS /p SCN " + content,
                   {square_shading(), "<< /PatternType 2 /Shading 5 0 R /Matrix [8 0 0 8 0 0] >>"});
  return read_pages(document, "a.pdf", {})->bytes();
}

bool holds(const std::string& svg, const std::string& part) { return svg.find(part) != svg.npos; }

TEST(StrokedPages, HaveTheStrokeInPixels) {
  const std::string svg = svg_of("6 w 1 J 2 j 3 M [9 4.5] 1.5 d 12 12 m 24 36 48 36 60 12 c S");
  EXPECT_TRUE(holds(svg, "d=\"M16,80 C32,48 64,48 80,80\"")) << svg;
  EXPECT_TRUE(holds(svg,
                    "style=\"fill:none;stroke:url(#page-1-mesh-1-mesh1);stroke-width:8;"
                    "stroke-linecap:round;stroke-linejoin:bevel;stroke-miterlimit:3;"
                    "stroke-dasharray:12,6;stroke-dashoffset:2\""))
      << svg;
  EXPECT_FALSE(holds(svg, "clipPath")) << svg;
  const auto read = parse_document(svg, "a.svg");
  ASSERT_EQ(read->meshes().size(), 1U);
  EXPECT_EQ(read->meshes()[0].role, PaintRole::stroke);
  EXPECT_EQ(read->mesh(read->meshes()[0]).face_count(), 1);
}

TEST(StrokedPages, ShowTheThinnestLine) {
  EXPECT_TRUE(holds(svg_of("0 w 12 12 m 60 12 l S"), ";stroke-width:1;"));
}

TEST(StrokedPages, AreClippedWhereSomethingIsHidden) {
  const std::string line = "6 w 1 j 12 12 m 60 12 l S";
  // The mesh is larger than either, its stroke than the second.
  EXPECT_FALSE(holds(svg_of("8 8 56 8 re W n " + line), "clip-path"));
  EXPECT_TRUE(holds(svg_of("10 10 52 4 re W n " + line), "<clipPath"));
  EXPECT_THROW(svg_of("8 40 56 8 re W n " + line), InputError);
  // Nothing of the mesh reaches the stroke.
  EXPECT_THROW(svg_of("6 w 1 j 80 12 m 90 12 l S"), InputError);
}

}  // namespace
}  // namespace gradmesh
