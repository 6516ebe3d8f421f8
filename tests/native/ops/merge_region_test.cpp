#include "ops/merge/merge_region.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>

#include "mesh/validate.h"
#include "ops/merge/region_finder.h"
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
  Mesh mesh = start;
  Journal journal(mesh);
  return merge_region(journal, region).valid() ? result(journal) : Merged{};
}

/// Grids, noisy and with T-junctions.
std::vector<Mesh> start_meshes() {
  std::vector<Mesh> meshes;
  for (const ColorModel model : {ColorModel::bilinear, ColorModel::bicubic}) {
    const GridOptions options{5, 6, 0.15, 0.2, model};
    meshes.push_back(test::grid_mesh(options, 4));
    for (unsigned seed = 0; seed < 6; ++seed)
      meshes.push_back(test::changed_mesh(test::grid_parts(options, seed), seed, 6));
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
      ASSERT_EQ(merger.merge(region).valid(), can);
      ASSERT_EQ(journal.depth(), std::size_t(start.face_count() - mesh.face_count()));
      if (!region_tops(start, region).empty() && can) {
        ASSERT_EQ(journal.depth(), std::size_t(region.size() - 1));
      }
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
      const Region view = merging_view(mesh, region);
      EXPECT_GE(view.columns, view.rows);
      EXPECT_EQ(region_name(mesh, view, region_tops(mesh, view)),
                region_name(mesh, region, region_tops(mesh, region)));
    }
}

/// The patches that become one where a region is merged, in rising order; none where it cannot be.
std::vector<Face> merged_patches(const Mesh& start, const Region& region) {
  Mesh mesh = start;
  Journal journal(mesh);
  const Face face = merge_region(journal, region);
  if (!face.valid()) return {};
  EXPECT_EQ(validate(mesh), std::vector<std::string>{});
  std::vector<Face> merged;
  for (const Face f : start.faces())
    if (f == face || !mesh[f].alive) merged.push_back(f);
  return merged;
}

/// Returns the patches, in rising order, of the regions without T-junctions inside that have one
/// row or column more than one of these.
std::vector<std::vector<Face>> larger_grids(const Mesh& mesh, const Region& name) {
  std::vector<std::vector<Face>> grids;
  const auto tops = region_tops(mesh, name);
  if (tops.empty()) return grids;
  for (Region view : region_views(mesh, name, tops)) {
    ++view.columns;
    std::vector<Face> faces;
    for (const Halfedge top : region_tops(mesh, view)) faces.push_back(mesh.face(top));
    std::ranges::sort(faces);
    grids.push_back(std::move(faces));
  }
  return grids;
}

TEST(RegionFinder, names_each_region_by_one_of_its_corners_and_its_patches) {
  int with_junctions = 0, larger_by_grids = 0;
  for (const Mesh& start : start_meshes()) {
    RegionFinder finder(start);
    std::map<std::vector<Face>, Region> names;
    for (const Halfedge edge : start.halfedges()) {
      if (start.is_bar(edge) || !start[edge].twin.valid()) continue;
      const auto found = finder.around(edge);
      if (!found) continue;
      std::vector<FoundRegion> regions{*found};
      const std::vector<std::vector<Face>> grids = larger_grids(start, found->name);
      for (const auto& larger : finder.larger(found->name)) {
        if (!larger) continue;
        EXPECT_TRUE(std::ranges::includes(larger->faces, found->faces));
        EXPECT_GT(larger->faces.size(), found->faces.size());
        const auto named = finder.named(*larger);
        if (!named) continue;
        EXPECT_EQ(named->faces, larger->faces);
        // Pricing does not ask for the name of what is known to be a grid.
        if (std::ranges::find(grids, larger->faces) != grids.end()) {
          EXPECT_FALSE(region_tops(start, named->name).empty());
          ++larger_by_grids;
        }
        regions.push_back(*named);
      }
      for (const FoundRegion& region : regions) {
        EXPECT_EQ(merged_patches(start, region.name), region.faces);
        EXPECT_EQ(finder.find(region.name)->name, region.name);
        // One name for one set of patches, from whichever curve it is reached.
        EXPECT_EQ(names.try_emplace(region.faces, region.name).first->second, region.name);
        const auto tops = region_tops(start, region.name);
        with_junctions += tops.empty();
        if (!tops.empty()) {
          EXPECT_EQ(region_name(start, region.name, tops), region.name);
        }
      }
    }
  }
  EXPECT_GT(with_junctions, 100);
  EXPECT_GT(larger_by_grids, 100);
}

TEST(RegionFinder, finds_the_whole_of_a_locally_refined_patch) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Mesh mesh = test::locally_refined(ColorModel::bicubic, seed, 16);
    RegionFinder finder(mesh);
    for (const Halfedge edge : mesh.halfedges()) {
      if (mesh.is_bar(edge) || !mesh[edge].twin.valid()) continue;
      std::optional<FoundRegion> region = finder.around(edge);
      ASSERT_TRUE(region);
      for (bool grows = true; grows;) {
        grows = false;
        for (const auto& area : finder.larger(region->name)) {
          const auto larger = area ? finder.named(*area) : std::nullopt;
          if (larger && larger->faces.size() > region->faces.size()) region = larger, grows = true;
        }
      }
      EXPECT_EQ(region->faces.size(), 16u);
    }
  }
}

}  // namespace
}  // namespace gradmesh
