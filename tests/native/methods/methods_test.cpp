#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <ostream>
#include <set>

#include "app/document/document.h"
#include "app/pages/read_document.h"
#include "base/error.h"
#include "branch_meshes.h"
#include "formats/hemesh/hemesh.h"
#include "mesh/rectangle.h"
#include "mesh/subdivide.h"
#include "mesh/validate.h"
#include "ops/merge/merge.h"
#include "random_meshes.h"
#include "simplify/simplify.h"

/// Every method on every kind of mesh: sound, within epsilon, the same again for the same seed.
namespace gradmesh {
namespace {

using test::patches;

/// The authors' meshes, and our own that cover the same ground without them.
const std::vector<std::string> shared_meshes{"L",
                                             "U",
                                             "apple",
                                             "banana",
                                             "teardrop",
                                             "global-refinement",
                                             "modifiedgr",
                                             "global-tulips",
                                             "global_duck",
                                             "junction-recolor-demo",
                                             "save_1",
                                             "local-refinement",
                                             "sharp-color-transition"};
const std::vector<std::string> samples{"ellipse", "face",   "fruit", "opacity",     "photo",
                                       "stroke",  "tensor", "two",   "transformed", "smooth"};
const std::vector<std::string> own_meshes{"l_branch", "u_branch",       "cross",     "ring",
                                          "dumbbell", "two_components", "junctions", "bicubic"};

Mesh own_mesh(const std::string& name) {
  if (name == "l_branch") return build_mesh(test::l_branch());
  if (name == "u_branch") return build_mesh(test::u_branch());
  if (name == "cross") return build_mesh(test::cross(3));
  if (name == "ring") return build_mesh(test::ring(7));
  if (name == "dumbbell") return build_mesh(test::dumbbell());
  if (name == "two_components") return build_mesh(test::two_components());
  const bool bicubic = name == "bicubic";
  const MeshParts parts =
      test::grid_parts({.rows = 5,
                        .columns = 5,
                        .position_noise = 0.04,
                        .color_noise = 0.02,
                        .color_model = bicubic ? ColorModel::bicubic : ColorModel::bilinear},
                       3);
  return bicubic ? build_mesh(parts) : test::changed_mesh(parts, 6, 8);
}

std::filesystem::path shared_file(const std::string& name) {
  return std::filesystem::path(GRADMESH_SHARED_DIR) / "meshes" / (name + ".hemesh");
}

Mesh shared_mesh(const std::string& name) {
  std::ifstream file(shared_file(name));
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  return build_mesh(read_hemesh(text, name));
}

/// The points that must stay: those of the boundary with more than two faces (4.4, Fig. 6).
std::set<Point> branch_points(const Mesh& mesh) {
  std::map<Point, int> faces;
  std::set<Point> boundary;
  for (const Halfedge h : mesh.halfedges()) {
    if (mesh.is_leaf(h)) ++faces[mesh.origin(h)];
    if (!mesh.other_side(h).valid()) boundary.insert({mesh.origin(h), mesh.end(h)});
  }
  std::set<Point> points;
  for (const Point p : boundary)
    if (faces[p] > 2) points.insert(p);
  return points;
}

/// Some edges that can be merged one after another.
std::vector<int> some_edges(const Mesh& original) {
  Mesh mesh = original;
  Journal journal(mesh);
  std::vector<int> edges;
  for (const Halfedge h : original.halfedges())
    if (edges.size() < 3 && mesh[h].alive && can_merge(mesh, h) == MergeObstacle::none) {
      merge(journal, h);
      edges.push_back(h.value);
    }
  return edges;
}

/// Whether what a method leaves is all that it can do: best goes on with what it has fitted, and
/// manual merges what is named.
bool leaves_nothing(const std::string& method) {
  return method != "best" && method != "manual" && method != "plain";
}

/// The patches that are left where a method runs once more on what it has made of the original.
int patches_of_second_run(const Mesh& original, Mesh mesh, RunOptions options) {
  options.analysis = nullptr;
  options.original = original_of(std::make_shared<const Mesh>(original));
  return simplify(mesh, options).patches_after;
}

/// Runs all methods at two thresholds. `price_again`: the second run knows no prices from the
/// first.
void run_all(const Mesh& original, bool price_again) {
  const std::set<Point> branches = branch_points(original);
  for (const double epsilon : {0.005, 0.03}) {
    PriceTable analysis;
    SimplifyResult of_gqe;
    for (const std::string& method : method_names()) {
      SCOPED_TRACE(std::string(method) + ", epsilon " + std::to_string(epsilon));
      RunOptions options;
      options.method = method;
      options.metric = epsilon < 0.01 ? MetricKind::ssim : MetricKind::flip;
      // The person who names edges decides by the preview.
      options.epsilon = method == "manual" ? 1 : epsilon;
      options.resolution = 100;
      options.padding = {.share = 0, .length = 0.03};
      options.seed = 5;
      options.analysis = &analysis;
      if (method == "manual") options.edges = some_edges(original);

      Mesh mesh = original, again = original;
      if (!suits(method_named(method), original)) {
        EXPECT_THROW(simplify(mesh, options), InputError);
        continue;
      }
      const SimplifyResult result = simplify(mesh, options);
      EXPECT_EQ(validate(mesh), std::vector<std::string>{});
      EXPECT_LE(result.error, options.epsilon);
      EXPECT_NEAR(result.error, result.error_added_up, 1e-6);
      EXPECT_EQ(result.patches_after, mesh.face_count());
      for (const Point p : branches) EXPECT_TRUE(mesh[p].alive);
      if (price_again) options.analysis = nullptr;
      options.threads = 1;
      EXPECT_EQ(simplify(again, options).error, result.error);
      EXPECT_EQ(patches(again), patches(mesh));

      if (leaves_nothing(method)) {
        EXPECT_EQ(patches_of_second_run(original, mesh, options), mesh.face_count());
      }
      if (method == "manual") {
        EXPECT_EQ(mesh.face_count(), original.face_count() - int(options.edges.size()));
      }
      if (method == "gqe") of_gqe = result;
      if (method == "gqe1" || method == "best") {
        EXPECT_LE(mesh.face_count(), of_gqe.patches_after);
      }
      if (method == "best" && mesh.face_count() == of_gqe.patches_after) {
        EXPECT_LE(result.error, of_gqe.error);
      }
    }
  }
}

class SharedMeshes : public ::testing::TestWithParam<std::string> {};

TEST_P(SharedMeshes, are_simplified_by_every_method) {
  if (!std::filesystem::exists(shared_file(GetParam())))
    GTEST_SKIP() << GetParam() << " is not among the authors' meshes in ../shared/meshes";
  run_all(shared_mesh(GetParam()), false);
}

class Samples : public ::testing::TestWithParam<std::string> {};

TEST_P(Samples, are_simplified_by_every_method) {
  const auto document =
      read_document(std::filesystem::path(GRADMESH_SOURCE_DIR) / "samples" / (GetParam() + ".svg"));
  for (const MeshEntry& entry : document->selected({})) {
    SCOPED_TRACE(entry.id);
    run_all(document->mesh(entry), false);
  }
}

class OwnMeshes : public ::testing::TestWithParam<std::string> {};

TEST_P(OwnMeshes, are_simplified_by_every_method) { run_all(own_mesh(GetParam()), true); }

std::string test_name(const ::testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::ranges::replace(name, '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Methods, SharedMeshes, ::testing::ValuesIn(shared_meshes), test_name);
INSTANTIATE_TEST_SUITE_P(Methods, Samples, ::testing::ValuesIn(samples), test_name);
INSTANTIATE_TEST_SUITE_P(Methods, OwnMeshes, ::testing::ValuesIn(own_meshes), test_name);

/// Exact parts of one patch: n x n of them (Perfect6).
Mesh parts_of_one(int n) {
  return build_mesh(subdivided(
      test::grid_mesh(
          {.rows = 1, .columns = 1, .position_noise = 0.2, .color_model = ColorModel::bicubic}, 4),
      n));
}

TEST(Methods, leave_one_patch_of_the_parts_of_one) {
  for (const std::string& method : method_names()) {
    Mesh mesh = parts_of_one(5);
    if (method == "manual" || !suits(method_named(method), mesh)) continue;
    RunOptions options;
    options.method = method;
    options.epsilon = 0.02;
    options.resolution = 200;
    simplify(mesh, options);
    EXPECT_EQ(mesh.face_count(), 1) << method;
  }
}

TEST(Methods, leave_one_patch_whatever_the_order_or_no_edge_that_can_be_merged) {
  const Mesh parts = parts_of_one(6);
  for (const std::string method : {"random", "grid", "dual-grid", "motorcycle"})
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      Mesh mesh = parts;
      RunOptions options;
      options.method = method;
      options.epsilon = 1;
      options.resolution = 40;
      options.seed = seed;
      simplify(mesh, options);
      // By chance, T-junctions can end up so that every merge would make a cycle (paper 6.1).
      if (method != "random") {
        EXPECT_EQ(mesh.face_count(), 1) << method << ", seed " << seed;
      }
      for (const Halfedge edge : mesh.halfedges())
        EXPECT_NE(can_merge(mesh, edge), MergeObstacle::none) << method << ", seed " << seed;
    }
}

TEST(Methods, see_across_junctions) {
  for (unsigned seed = 0; seed < 4; ++seed) {
    const Mesh refined = test::locally_refined(ColorModel::bicubic, seed, 16);
    for (const std::string method : {"gqe", "gqe1", "best"}) {
      Mesh mesh = refined;
      RunOptions options;
      options.method = method;
      options.resolution = 100;
      EXPECT_EQ(simplify(mesh, options).patches_after, 1) << method << ", seed " << seed;
    }
  }
}

TEST(Methods, leave_nothing_for_a_second_run) {
  for (unsigned seed = 0; seed < 6; ++seed) {
    const MeshParts parts = test::grid_parts(
        {.rows = 6, .columns = 5, .position_noise = 0.05, .color_noise = 0.03}, seed);
    const Mesh original = seed % 2 == 0 ? build_mesh(parts) : test::changed_mesh(parts, seed, 8);
    for (const std::string& method : method_names()) {
      if (!leaves_nothing(method) || !suits(method_named(method), original)) continue;
      RunOptions options;
      options.method = method;
      options.epsilon = 0.02;
      options.resolution = 100;
      options.seed = seed;
      Mesh mesh = original;
      const int once = simplify(mesh, options).patches_after;
      EXPECT_EQ(patches_of_second_run(original, mesh, options), once)
          << method << ", seed " << seed;
    }
  }
}

TEST(Manual, says_which_edge_cannot_be_merged_and_why) {
  const Mesh original = build_mesh(test::l_branch());
  const auto message = [&](std::vector<int> edges, double epsilon) -> std::string {
    Mesh mesh = original;
    RunOptions options;
    options.method = "manual";
    options.edges = std::move(edges);
    options.epsilon = epsilon;
    options.resolution = 100;
    try {
      simplify(mesh, options);
    } catch (const InputError& error) {
      EXPECT_EQ(patches(mesh), patches(original));
      return error.what();
    }
    return "";
  };
  EXPECT_NE(message({1}, 1).find("half-edge 1 cannot be merged: "), std::string::npos);
  EXPECT_NE(message({0}, 1).find("boundary"), std::string::npos);
  EXPECT_NE(message({99}, 1).find("there is no half-edge 99"), std::string::npos);
  EXPECT_NE(message({-1}, 1).find("there is no half-edge -1"), std::string::npos);
}

TEST(Manual, keeps_to_epsilon_and_to_the_order) {
  const Mesh original = own_mesh("bicubic");
  const std::vector<int> edges = some_edges(original);
  ASSERT_EQ(edges.size(), 3u);
  RunOptions options;
  options.method = "manual";
  options.edges = edges;
  options.epsilon = 1;
  options.resolution = 100;
  Mesh merged = original;
  const double error = simplify(merged, options).error;
  EXPECT_GT(error, 0);
  Mesh by_hand = original;
  Journal journal(by_hand);
  for (const int edge : edges) merge(journal, Halfedge{edge});
  EXPECT_EQ(patches(merged), patches(by_hand));

  options.epsilon = error / 2;
  Mesh refused = original;
  EXPECT_THROW(simplify(refused, options), InputError);
  EXPECT_EQ(patches(refused), patches(original));
}

}  // namespace
}  // namespace gradmesh
