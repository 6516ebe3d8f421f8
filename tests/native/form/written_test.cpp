// What writing a mesh as blocks adds where nothing was merged: next to nothing.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <optional>

#include "app/document/document.h"
#include "app/document/frames.h"
#include "app/pages/read_document.h"
#include "base/error.h"
#include "corners.h"
#include "form/blocks.h"
#include "form/written_patch.h"
#include "mesh/build.h"
#include "problems.h"
#include "random_meshes.h"
#include "raster/overlaps.h"
#include "trial/edit_error.h"

namespace gradmesh {
namespace {

TEST(MaskColor, has_the_luminance_of_the_opacity) {
  for (int level = 0; level <= 255; ++level) {
    // Greys stay greys, as they were written at first.
    const glm::dvec3 grey(level / 255.0);
    EXPECT_EQ(mask_color(grey.r), grey);
    EXPECT_EQ(mask_opacity(grey), grey.r);
  }
  for (int i = 0; i <= 100000; ++i) {
    const double opacity = i / 100000.0;
    const glm::dvec3 color = mask_color(opacity);
    ASSERT_NEAR(mask_opacity(color), opacity, 0.05 / 255);
    for (int n = 0; n < 3; ++n) {
      ASSERT_EQ(std::round(255 * color[n]) / 255, color[n]);
      ASSERT_TRUE(color[n] >= 0 && color[n] <= 1);
      ASSERT_NEAR(color[n], opacity, 6.0 / 255);
    }
  }
  EXPECT_EQ(mask_color(-1), glm::dvec3(0));
  EXPECT_EQ(mask_color(2), glm::dvec3(1));
}

/// The order in which faces lie over one another is kept, whatever has been merged.
TEST(BlockForm, paints_what_lies_over_itself_as_before) {
  int several = 0;
  for (unsigned seed = 0; seed < 30; ++seed) {
    const Mesh mesh = test::changed_mesh(
        [&] {
          std::mt19937 random(seed);
          return test::grid_parts(
              {.rows = 4, .columns = 5, .position_noise = 0.8, .color_noise = 0.3}, random);
        }(),
        seed, 12);
    const auto overlaps = find_overlaps(mesh, fit_frame(mesh, {}, 300));
    const BlockForm form = block_form(mesh, 0, overlaps);
    std::vector<int> place(mesh.face_slots(), -1);
    int next = 0;
    for (const Rectangle& block : form.blocks)
      for (const Halfedge top : block.tops) {
        EXPECT_EQ(place[mesh.face(top).value], -1);
        place[mesh.face(top).value] = next++;
      }
    EXPECT_EQ(next, mesh.face_count());
    for (const Overlap& overlap : overlaps) {
      EXPECT_LT(overlap.below, overlap.above);
      EXPECT_LT(place[overlap.below.value], place[overlap.above.value]);
    }
    several += overlaps.size() > 10;
  }
  EXPECT_GT(several, 10);
}

/// The error of a mesh that is written as blocks as it is: next to nothing, unless a mask of 8 bits
/// is needed. Half of the pixels behind one may take the next level, for which FLIP charges 0.03.
void expect_free(const Mesh& mesh, const Frame& frame) {
  const BlockForm form = block_form(mesh, coons_tolerance(frame), find_overlaps(mesh, frame));
  const FrameError error =
      MeasuredSurface(*test::reference(mesh, frame), build_mesh(block_parts(mesh, form)),
                      form.masks_opacity, nullptr)
          .error();
  EXPECT_LT(error.mean, form.masks_opacity ? 0.012 : 0.0005);
  EXPECT_LT(error.local, form.masks_opacity ? 0.05 : 0.02);
}

/// Some documents hold meshes that are refused.
std::optional<Mesh> readable_mesh(const Document& document, const MeshEntry& entry) {
  try {
    return document.mesh(entry);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

class Documents : public ::testing::TestWithParam<const char*> {};

TEST_P(Documents, cost_nothing_as_blocks) {
  const std::filesystem::path folder = GetParam();
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not there";
  int meshes = 0;
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    if (file.path().extension() != ".svg") continue;
    const auto document = read_document(file.path());
    for (const MeshEntry& entry : document->meshes()) {
      SCOPED_TRACE(file.path().filename().string() + " " + entry.id);
      const auto mesh = readable_mesh(*document, entry);
      if (!mesh || mesh->is_smooth()) continue;
      expect_free(*mesh, frame_of(*document, entry, *mesh, 700));
      ++meshes;
    }
  }
  EXPECT_GT(meshes, 8);
}

INSTANTIATE_TEST_SUITE_P(, Documents,
                         ::testing::Values(GRADMESH_SOURCE_DIR "/samples",
                                           GRADMESH_SHARED_DIR "/real"));

/// A mesh with T-junctions as a document may hold it; translucent, or lying over itself.
Mesh random_mesh(unsigned seed, bool translucent, bool wild) {
  std::mt19937 random(seed);
  const Mesh changed = test::changed_mesh(
      test::grid_parts(
          {.rows = 4, .columns = 4, .position_noise = wild ? 0.5 : 0.1, .color_noise = 0.3},
          random),
      seed, 10);
  MeshParts parts = block_parts(changed, block_form(changed, 0));
  if (translucent)
    test::change_corners(parts, [&](Value& v) {
      v.color.a = 0.6 + 0.4 * std::sin(v.position.x / 70 + seed) * std::cos(v.position.y / 60);
    });
  return build_mesh(parts);
}

TEST(RandomMeshes, cost_nothing_as_blocks) {
  int masked = 0, over_itself = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    const Mesh mesh = random_mesh(seed, seed % 2 != 0, seed % 3 == 0);
    const Frame frame = fit_frame(mesh, {}, 300);
    expect_free(mesh, frame);
    const auto overlaps = find_overlaps(mesh, frame);
    masked += block_form(mesh, 0, overlaps).masks_opacity;
    over_itself += !overlaps.empty();
  }
  EXPECT_GT(masked, 80);
  EXPECT_GT(over_itself, 40);
}

}  // namespace
}  // namespace gradmesh
