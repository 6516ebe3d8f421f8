#include "ops/merge_region.h"

#include <gtest/gtest.h>

#include "random_meshes.h"

/// Regions merged one after another, against each merged from scratch.
namespace gradmesh {
namespace {

using test::GridOptions;
using test::patches;

/// What is left of a mesh where a region is merged, and which faces that touched; nothing where it
/// cannot be merged.
struct Merged {
  std::vector<Patch> patches;
  std::vector<Face> touched;

  bool operator==(const Merged&) const = default;
};

Merged result(const Journal& journal) {
  return {patches(journal.mesh()), journal.touched_since(0)};
}

Merged from_scratch(const Mesh& start, const Region& region) {
  const std::vector<Halfedge> tops = region_tops(start, region);
  Mesh mesh = start;
  Journal journal(mesh);
  return !tops.empty() && merge_region(journal, region, tops) ? result(journal) : Merged{};
}

/// Grids, noisy and with T-junctions.
std::vector<Mesh> start_meshes() {
  std::vector<Mesh> meshes;
  for (const ColorModel model : {ColorModel::bilinear, ColorModel::bicubic}) {
    const GridOptions options{5, 6, 0.15, 0.2, model};
    meshes.push_back(test::grid_mesh(options, 4));
    for (unsigned seed = 0; seed < 6; ++seed) {
      std::mt19937 random(seed);
      meshes.push_back(test::changed_mesh(test::grid_parts(options, random), seed, 6));
    }
  }
  return meshes;
}

TEST(RegionMerger, gives_the_same_as_each_region_from_scratch) {
  std::mt19937 random(7);
  int merged = 0;
  for (const Mesh& start : start_meshes()) {
    Mesh mesh = start;
    Journal journal(mesh);
    RegionMerger merger(journal, start);
    const std::vector<Face> faces(start.faces().begin(), start.faces().end());
    Region region{faces[0]};
    for (int i = 0; i < 300; ++i) {
      // Mostly the region before with more or fewer rows or columns.
      if (random() % 4 == 0) region = {faces[random() % faces.size()], int(random() % 4), 1, 1};
      (random() % 2 == 0 ? region.rows : region.columns) = 1 + int(random() % 5);
      const Merged expected = from_scratch(start, region);
      const bool can = !expected.patches.empty();
      ASSERT_EQ(merger.merge(region), can);
      ASSERT_EQ(journal.depth(), can ? std::size_t(region.size() - 1) : 0u);
      ASSERT_EQ(result(journal), can ? expected : (Merged{patches(start), {}}));
      merged += can && region.size() > 1;
    }
    merger.undo();
    EXPECT_EQ(journal.depth(), 0u);
    EXPECT_EQ(patches(mesh), patches(start));
    EXPECT_EQ(mesh.halfedge_slots(), start.halfedge_slots());
  }
  EXPECT_GT(merged, 500);
}

TEST(MergingView, has_at_least_as_many_columns_as_rows_and_is_the_same_region) {
  const Mesh mesh = test::grid_mesh({4, 4});
  for (int rows = 1; rows <= 4; ++rows)
    for (int columns = 1; columns <= 4; ++columns) {
      const Region region{Face{0}, 0, rows, columns};
      const std::vector<Halfedge> tops = region_tops(mesh, region);
      const Region view = merging_view(mesh, region, tops);
      EXPECT_GE(view.columns, view.rows);
      EXPECT_EQ(region_name(mesh, view, region_tops(mesh, view)), region_name(mesh, region, tops));
    }
}

}  // namespace
}  // namespace gradmesh
