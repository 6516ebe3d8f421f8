// Meshes as code of SwiftUI and Compose: what the code says, painted, looks like the mesh.
#include "app/export/publish_code.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "app/document/svg_document.h"
#include "app/pages/read_document.h"
#include "app/runs/convert.h"
#include "app/runs/runs.h"
#include "code_reader.h"
#include "form/smooth_colors.h"
#include "formats/code/compose_code.h"
#include "formats/code/swift_code.h"
#include "mesh/boundary.h"
#include "metric/metric.h"
#include "raster/hidden.h"
#include "raster/rasterizer.h"

using namespace gradmesh;
using namespace gradmesh::test;

namespace {

constexpr CodeLanguage both_languages[] = {CodeLanguage::swift, CodeLanguage::compose};

/// Returns the FLIP of what the code paints against the mesh of the document.
double flip_of_code(const SvgDocument& document, const MeshEntry& entry, const MeshCode& code) {
  const Mesh& mesh = document.mesh(entry);
  const SvgDocument::Place place = document.place(entry);
  const Affine to_page = place.to_page * place.to_user;
  Frame frame = fit_frame(mesh, to_page, 350);
  const Box box = bounding_box(mesh, to_page);
  Frame code_frame = frame;
  code_frame.to_pixels = frame.to_pixels * to_page.inverse() * Affine::translation(box.low()) *
                         Affine::scaling(box.size());
  if (place.seen) frame.hidden = std::make_shared<HiddenPixels>(*place.seen, frame);
  if (!code.clips.empty()) {
    VisibleArea seen;
    for (const FilledOutline& clip : code.clips) seen.sets.push_back({clip});
    code_frame.hidden = std::make_shared<HiddenPixels>(seen, code_frame);
  }
  const auto rasterizer = make_software_rasterizer();
  const Image original = mesh.is_smooth() ? rasterizer->paint(painted_mesh(mesh), frame)
                                          : rasterizer->paint(mesh, frame);
  const Image made = rasterizer->paint(painted_by(code), code_frame);
  return mean(make_metric(MetricKind::flip, original)->map(made));
}

std::unique_ptr<Document> drawing(const std::string& body) {
  return parse_document(
      "<svg xmlns='http://www.w3.org/2000/svg' width='100' height='100'><defs>"
      "<meshgradient id='m' gradientUnits='userSpaceOnUse' x='10' y='10'><meshrow><meshpatch>"
      "<stop path='l 80 0' style='stop-color:#ff0000'/>"
      "<stop path='l 0 40' style='stop-color:#00ff00'/>"
      "<stop path='l -80 0' style='stop-color:#0000ff;stop-opacity:0.5'/>"
      "<stop path='l 0 -40' style='stop-color:#ffffff'/></meshpatch></meshrow></meshgradient>"
      "</defs>" +
          body + "</svg>",
      "drawing.svg");
}

std::vector<std::string> sentences(const PublishedCode& mesh) {
  std::vector<std::string> said;
  for (const Message& message : mesh.lost) said.push_back(message.english());
  return said;
}

bool says(const PublishedCode& mesh, const std::string& words) {
  for (const std::string& sentence : sentences(mesh))
    if (sentence.find(words) != std::string::npos) return true;
  return false;
}

const std::string rectangle_of = "<rect id='r' x='10' y='10' width='80' height='40' fill='url(#m)'";

}  // namespace

TEST(PublishCode, paints_the_samples) {
  int meshes = 0;
  for (const auto& file : std::filesystem::directory_iterator(GRADMESH_SOURCE_DIR "/samples")) {
    if (file.path().extension() != ".svg") continue;
    for (const CodeLanguage language : both_languages) {
      const auto document = read_document(file.path());
      const auto published = publish_code(*document, language);
      const auto entries = document->selected({});
      ASSERT_EQ(published.meshes.size(), entries.size());
      for (std::size_t i = 0; i < entries.size(); ++i) {
        const PublishedCode& made = published.meshes[i];
        const MeshCode code = read_code(made.source);
        const double flip =
            flip_of_code(dynamic_cast<const SvgDocument&>(*document), entries[i], code);
        const bool differs = says(made, "inner points") || says(made, "smooth colours");
        // Opacities of 8 bits change many colours by one level.
        const double rounding = is_translucent(document->mesh(entries[i])) ? 0.006 : 0.002;
        EXPECT_LT(flip, differs ? 0.03 : rounding) << file.path() << made.id;
        ++meshes;
      }
    }
  }
  EXPECT_GT(meshes, 16);
}

TEST(PublishCode, holds_a_patch_as_it_is) {
  for (const CodeLanguage language : both_languages) {
    const auto document = drawing(rectangle_of + "/>");
    const auto published = publish_code(*document, language);
    ASSERT_EQ(published.meshes.size(), 1U);
    EXPECT_TRUE(published.meshes[0].lost.empty());
    EXPECT_EQ(published.source, published.meshes[0].source);
    const MeshCode code = read_code(published.source);
    ASSERT_EQ(code.grids.size(), 1U);
    EXPECT_TRUE(code.clips.empty());
    EXPECT_FALSE(code.smooth);
    EXPECT_DOUBLE_EQ(code.aspect_ratio, 2);
    const std::vector<CodeVertex>& v = code.grids[0].vertices;
    ASSERT_EQ(v.size(), 4U);
    EXPECT_EQ(v[0].position, glm::dvec2(0, 0));
    EXPECT_EQ(v[1].position, glm::dvec2(1, 0));
    EXPECT_EQ(v[2].position, glm::dvec2(0, 1));
    EXPECT_EQ(v[3].position, glm::dvec2(1, 1));
    EXPECT_NEAR(v[0].handles[2].x, 1.0 / 3, 1e-5);
    EXPECT_EQ(v[0].handles[0], v[0].position);
    EXPECT_EQ(v[0].color, glm::dvec4(1, 0, 0, 1));
    EXPECT_NEAR(v[3].color.a, 0.5, 1.0 / 255);
  }
}

TEST(PublishCode, follows_transforms_to_the_page) {
  const auto document =
      drawing("<g transform='scale(1 3)'>" + rectangle_of + " transform='rotate(90)'/></g>");
  const auto published = publish_code(*document, CodeLanguage::swift);
  const MeshCode code = read_code(published.source);
  EXPECT_NEAR(code.aspect_ratio, 40.0 / 240, 1e-5);
  EXPECT_EQ(code.grids[0].vertices[0].position, glm::dvec2(1, 0));
  EXPECT_EQ(code.grids[0].vertices[1].position, glm::dvec2(1, 1));
}

TEST(PublishCode, clips_where_the_shape_hides_some_of_the_mesh) {
  for (const CodeLanguage language : both_languages) {
    const auto document = drawing(
        "<path id='p' fill-rule='evenodd' d='M10 10h80v40h-80z M20 20h20v20h-20z' "
        "fill='url(#m)'/>");
    const MeshCode code = read_code(publish_code(*document, language).source);
    ASSERT_EQ(code.clips.size(), 1U);
    EXPECT_EQ(code.clips[0].rule, FillRule::evenodd);
    ASSERT_EQ(code.clips[0].outline.size(), 2U);
    EXPECT_EQ(code.clips[0].outline[1][0], glm::dvec2(0.125, 0.25));
    EXPECT_EQ(code.clips[0].outline[1].size(), 4U);
  }
}

TEST(PublishCode, holds_the_opacity_of_object_and_groups) {
  const auto document = drawing("<g opacity='0.5'>" + rectangle_of + " style='opacity:0.5'/></g>");
  EXPECT_NE(publish_code(*document, CodeLanguage::swift).source.find(".opacity(0.25)"),
            std::string::npos);
  EXPECT_NE(publish_code(*document, CodeLanguage::compose).source.find(".alpha(0.25f)"),
            std::string::npos);
}

TEST(PublishCode, tells_what_is_left_out) {
  const std::string defs =
      "<defs><mask id='k'><rect x='0' y='0' width='50' height='50' fill='white'/></mask>"
      "<clipPath id='c' clipPathUnits='objectBoundingBox'><circle r='1'/></clipPath>"
      "<filter id='f'/></defs>";
  const std::vector<std::pair<std::string, std::string>> cases{
      {rectangle_of + " mask='url(#k)'/>", "a mask is left out"},
      {rectangle_of + " clip-path='url(#c)'/>", "a clip path is left out"},
      {rectangle_of + " filter='url(#f)'/>", "a filter is left out"},
      {rectangle_of + " style='mix-blend-mode:multiply'/>", "a blend mode is left out"},
      {rectangle_of + " stroke='black'/>", "the stroke of the object is left out"},
      {"<text id='t' x='10' y='50' fill='url(#m)'>Text</text>", "not only the text"},
      {"<path id='s' d='M10 20h80' fill='none' stroke='url(#m)' stroke-width='9'/>",
       "not only the stroke"}};
  for (const auto& [body, words] : cases) {
    const auto document = drawing(defs + body);
    const std::string before = document->bytes();
    const auto published = publish_code(*document, CodeLanguage::swift);
    ASSERT_EQ(published.meshes[0].lost.size(), 1U) << words;
    EXPECT_TRUE(says(published.meshes[0], words)) << sentences(published.meshes[0])[0];
    EXPECT_EQ(document->bytes(), before);
  }
}

TEST(PublishCode, never_lets_an_id_into_code) {
  for (const CodeLanguage language : both_languages) {
    const auto document = drawing(
        "<rect id='a*/&#10;fatalError()&#x2028;x' x='10' y='10' width='80' height='40' "
        "fill='url(#m)'/>");
    const std::string code = publish_code(*document, language).source;
    EXPECT_EQ(code.find("\nfatalError"), std::string::npos);
    EXPECT_EQ(code.find("*/"), std::string::npos);
    EXPECT_EQ(code.find("\xe2\x80\xa8"), std::string::npos);
    EXPECT_TRUE(is_published_code(code));
  }
}

TEST(PublishCode, puts_all_meshes_into_one_file_under_their_names) {
  const auto document = drawing(rectangle_of + "/>" + rectangle_of + " class='b'/>" + "<g id='R'>" +
                                rectangle_of + "/></g>");
  const auto published = publish_code(*document, CodeLanguage::compose);
  ASSERT_EQ(published.meshes.size(), 3U);
  EXPECT_EQ(published.meshes[0].name, "R");
  for (const PublishedCode& mesh : published.meshes) {
    EXPECT_NE(published.source.find("fun " + mesh.name + "("), std::string::npos);
    EXPECT_NE(published.source.find("object " + mesh.name + "Data {"), std::string::npos);
  }
}

TEST(PublishCode, stacks_the_blocks_of_a_simplified_mesh) {
  const auto document = read_document(GRADMESH_SOURCE_DIR "/samples/fruit.svg");
  RunOptions options;
  options.method = "gqe";
  options.epsilon = 0.02;
  simplify(*document, {}, options);
  const MeshEntry entry = document->selected({}).front();
  ASSERT_TRUE(entry.simplified);
  for (const CodeLanguage language : both_languages) {
    const PublishedCode made = publish_code(*document, language).meshes.at(0);
    const MeshCode code = read_code(made.source);
    EXPECT_EQ(int(code.grids.size()), document->objects(entry));
    EXPECT_TRUE(says(made, "side by side"));
    const double flip = flip_of_code(dynamic_cast<const SvgDocument&>(*document), entry, code);
    EXPECT_LT(flip, 0.002);
  }
}

TEST(PublishCode, of_large_meshes_has_no_large_methods) {
  MeshCode mesh;
  mesh.id = "large";
  mesh.name = "Large";
  CodeGrid& grid = mesh.grids.emplace_back(CodeGrid{70, 30, {}});
  for (int i = 0; i <= 70; ++i)
    for (int j = 0; j <= 30; ++j) {
      CodeVertex& vertex = grid.vertices.emplace_back();
      vertex.position = {j / 30.0, i / 70.0};
      vertex.handles.fill(vertex.position);
      vertex.color = {i / 70.0, j / 30.0, 0, 1};
    }
  const std::string code = compose_code({mesh}, "here");
  EXPECT_EQ(read_code(code).grids[0].vertices.size(), 71U * 31U);
  std::size_t longest = 0;
  for (std::size_t at = code.find("ArrayOf("); at != std::string::npos;
       at = code.find("ArrayOf(", at + 1)) {
    const std::string list = code.substr(at, code.find(')', at) - at);
    longest = std::max(longest, std::size_t(std::ranges::count(list, ',')));
  }
  EXPECT_LE(longest, 4000U);
  EXPECT_GT(longest, 3000U);
  EXPECT_EQ(read_code(swift_code({mesh}, "here")).grids[0].vertices.size(), 71U * 31U);
}

TEST(PublishCode, refuses_other_documents) {
  const auto svg = drawing(rectangle_of + "/>");
  const auto document = convert(*svg, svg->meshes().front(), format_named("hemesh"), {}).document;
  EXPECT_THROW(publish_code(*document, CodeLanguage::swift), InputError);
}
