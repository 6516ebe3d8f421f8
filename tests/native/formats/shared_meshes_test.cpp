#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <ostream>

#include "formats/hemesh/hemesh.h"
#include "mesh/validate.h"
#include "random_meshes.h"
#include "same_mesh.h"

/// The authors' meshes, which are not part of the project: each test is skipped without them.
namespace gradmesh {
namespace {

using test::difference;
using test::junctions;
using test::same;

Mesh read(const std::string& text) { return build_mesh(read_hemesh(text, "test.hemesh")); }

struct SharedMesh {
  const char* name;
  int patches, junctions;
};

void PrintTo(const SharedMesh& mesh, std::ostream* out) { *out << mesh.name; }

/// Empty where the file is absent.
std::string shared_text(const std::string& name) {
  std::ifstream file(std::filesystem::path(GRADMESH_SHARED_DIR) / "meshes" / (name + ".hemesh"));
  return {std::istreambuf_iterator<char>(file), {}};
}

class SharedHemesh : public ::testing::TestWithParam<SharedMesh> {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(GRADMESH_SHARED_DIR "/meshes"))
      GTEST_SKIP() << "the authors' meshes are not beside the project, in ../shared/meshes";
  }
};

TEST_P(SharedHemesh, is_read_and_written_back_the_same) {
  const auto [name, patches, expected_junctions] = GetParam();
  const Mesh mesh = read(shared_text(name));
  EXPECT_EQ(validate(mesh), std::vector<std::string>{});
  EXPECT_EQ(mesh.face_count(), patches);
  EXPECT_EQ(junctions(mesh), std::size_t(expected_junctions));
  const std::string text = write_hemesh(mesh);
  const Mesh again = read(text);
  EXPECT_TRUE(same(mesh, again));
  EXPECT_EQ(write_hemesh(again), text);
}

TEST_P(SharedHemesh, is_still_the_same_after_merges) {
  const Mesh mesh = test::without_own_tangents(
      test::changed_mesh(read_hemesh(shared_text(GetParam().name), "shared"), 5, 60));
  EXPECT_EQ(validate(mesh), std::vector<std::string>{});
  const std::string text = write_hemesh(mesh);
  EXPECT_TRUE(same(mesh, read(text)));
  EXPECT_EQ(write_hemesh(read(text)), text);
}

INSTANTIATE_TEST_SUITE_P(
    All, SharedHemesh,
    ::testing::Values(SharedMesh{"teardrop", 25, 0}, SharedMesh{"global-refinement", 36, 0},
                      SharedMesh{"modifiedgr", 36, 0}, SharedMesh{"apple", 80, 0},
                      SharedMesh{"banana", 92, 0}, SharedMesh{"global-tulips", 102, 0},
                      SharedMesh{"global_duck", 230, 0}, SharedMesh{"local-refinement", 16, 10},
                      SharedMesh{"junction-recolor-demo", 3, 1},
                      SharedMesh{"sharp-color-transition", 4, 0}, SharedMesh{"L", 3, 0},
                      SharedMesh{"U", 4, 0}, SharedMesh{"save_1", 12, 1}));

TEST(SharedHemeshBranches, stay) {
  for (const char* name : {"L", "U"}) {
    const std::string text = shared_text(name);
    if (text.empty()) GTEST_SKIP() << "the authors' meshes are not beside the project";
    const Mesh mesh = read(text);
    for (const Halfedge h : mesh.halfedges())
      EXPECT_EQ(can_merge(mesh, h),
                mesh[h].twin.valid() ? MergeObstacle::branch : MergeObstacle::boundary);
  }
}

/// Fixes the sign of the twists (see HemeshFile): where the authors split a patch exactly, merging
/// two parts and splitting the result again gives the parts back, their twists among them.
TEST(SharedHemeshTwists, are_those_of_exact_splits) {
  const std::string text = shared_text("global-refinement");
  if (text.empty()) GTEST_SKIP() << "the authors' meshes are not beside the project";
  Mesh mesh = read(text);
  Journal journal(mesh);
  int tried = 0;
  for (const Face f : mesh.faces()) {
    const Halfedge right = mesh.sides(f)[1];
    if (can_merge(mesh, right) != MergeObstacle::none) continue;
    const Patch before = mesh.patch(f);
    const double r = test::split_factor(mesh, right);
    merge(journal, right);
    const Patch left = mesh.patch(f).split_v(r)[0];
    journal.undo();
    EXPECT_LE(difference(left, before), 2e-5);
    double twist = 0;
    for (int k = 0; k < 4; ++k)
      for (int channel = 0; channel < 3; ++channel)
        twist = std::max(twist, std::abs(before.twist(k).color[channel]));
    tried += twist > 1e-3;
  }
  EXPECT_GT(tried, 10);
}

}  // namespace
}  // namespace gradmesh
