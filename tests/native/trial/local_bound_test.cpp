// The bound on the error of small parts: its windows, single edits, and whole results.
#include <gtest/gtest.h>

#include <filesystem>
#include <ostream>

#include "app/pages/read_document.h"
#include "app/runs/runs.h"
#include "base/error.h"
#include "mesh/color_model.h"
#include "mesh/rectangle.h"
#include "metric/block_maxima.h"
#include "metric/local_mean.h"
#include "problems.h"
#include "random_meshes.h"
#include "raster/painting.h"
#include "trial/edit_error.h"

namespace gradmesh {
namespace {

Plane random_map(Window window, std::mt19937& random) {
  std::uniform_real_distribution<float> unit(0, 1);
  Plane map(window);
  // Mostly small, as error maps are, and now and then nothing at all.
  for (float& value : map.samples) value = unit(random) < 0.3F ? 0 : std::pow(unit(random), 20.0F);
  return map;
}

/// By the definition, one window after another.
double naive_local_mean(const Plane& map, int x, int y) {
  const Window window = Window{x, y, x + 32, y + 32}.clipped(map.window());
  double sum = 0;
  for (int v = window.y0; v < window.y1; ++v)
    for (int u = window.x0; u < window.x1; ++u) sum += *map.at(u, v);
  return sum / (window.width() * window.height());
}

double naive_largest(const Plane& map) {
  double largest = 0;
  for (int y = 0; y <= std::max(0, map.height - 32); ++y)
    for (int x = 0; x <= std::max(0, map.width - 32); ++x)
      largest = std::max(largest, naive_local_mean(map, x, y));
  return largest;
}

TEST(LocalMean, of_every_window_once_whatever_the_size) {
  std::mt19937 random(4);
  for (const auto& [width, height] : {std::pair(1, 1), {5, 90}, {31, 33}, {32, 32}, {70, 41}}) {
    const Plane map = random_map({0, 0, width, height}, random);
    int windows = 0;
    for_each_local_mean(map, [&](int x, int y, double mean) {
      EXPECT_NEAR(mean, naive_local_mean(map, x, y), 1e-12);
      ++windows;
    });
    EXPECT_EQ(windows, std::max(1, width - 31) * std::max(1, height - 31));
    EXPECT_NEAR(largest_local_mean(map), naive_largest(map), 1e-12);
  }
  EXPECT_EQ(largest_local_mean(Plane()), 0);
}

/// A part of the map gets other values, and only its blocks are looked at again.
TEST(BlockMaxima, follow_a_part_that_changes) {
  std::mt19937 random(6);
  for (const auto& [width, height] : {std::pair(20, 90), {33, 31}, {150, 110}}) {
    Plane map = random_map({0, 0, width, height}, random);
    const Window changed = Window{width / 2, 5, width / 2 + 9, 40}.clipped(map.window());
    *map.at(changed.x0, changed.y0) = 9;
    BlockMaxima values(map.window());
    values.add(map);
    EXPECT_EQ(values.largest(), 9);
    fill(map, changed, 0.0F);
    const Window blocks = values.whole_blocks(changed);
    EXPECT_EQ(blocks.united(changed), blocks);
    Plane part(blocks);
    copy(map, blocks, part);
    values.clear(blocks);
    values.add(part);
    BlockMaxima afresh(map.window());
    afresh.add(map);
    EXPECT_EQ(values.largest(), afresh.largest());
    EXPECT_TRUE(values.whole_blocks({width, 0, width + 5, 5}).empty());
  }
}

TEST(LocalMean, of_a_part_is_that_of_the_whole_to_the_last_bit) {
  std::mt19937 random(5);
  Plane map = random_map({0, 0, 150, 110}, random);
  // Up to the largest value that weights make of a distance.
  for (float& value : map.samples) value = std::min(8.0F, 32 * value);
  Raster<double, 1> means(map.window());
  for_each_local_mean(map, [&](int x, int y, double mean) { *means.at(x, y) = mean; });
  for (const Window window : {Window{3, 7, 60, 39}, {100, 20, 150, 110}, {17, 0, 49, 32}}) {
    Plane part(window);
    for (int y = window.y0; y < window.y1; ++y)
      std::copy_n(map.at(window.x0, y), window.width(), part.at(window.x0, y));
    for_each_local_mean(part, [&](int x, int y, double mean) { EXPECT_EQ(mean, *means.at(x, y)); });
  }
}

/// What is looked at around an edit must say the same as the whole frame.
void check_edits(const Mesh& original, const Mesh& start, unsigned seed, double bound, int& held,
                 int& broken) {
  std::mt19937 random(seed);
  Mesh mesh = start;
  EditError error = test::edit_error(original, start, fit_frame(original, {}, 180),
                                     MetricKind::flip, true, bound);
  Journal journal(mesh);
  for (int step = 0; step < 20; ++step) {
    test::change_at_random(journal, random);
    error.after_edits(journal, journal.depth() - 1);
    const FrameError whole = error.whole_frame(mesh);
    ASSERT_EQ(error.keeps_local_bound(), whole.keeps_local_bound) << "step " << step;
    EXPECT_EQ(whole.keeps_to(whole.mean), whole.keeps_local_bound);
    EXPECT_FALSE(whole.keeps_to(whole.mean - 1e-9));
    ++(whole.keeps_local_bound ? held : broken);
    if (whole.keeps_local_bound) {
      error.accept(journal);
    } else {
      journal.undo();
    }
  }
}

TEST(LocalBound, around_an_edit_is_that_of_the_whole_frame) {
  int held = 0, broken = 0;
  for (unsigned seed = 0; seed < 6; ++seed) {
    const Mesh mesh =
        test::grid_mesh({.rows = 5, .columns = 4, .position_noise = 0.1, .color_noise = 0.1}, seed);
    for (const double bound : {0.05, 0.15}) check_edits(mesh, mesh, seed, bound, held, broken);
  }
  EXPECT_GT(held, 20);
  EXPECT_GT(broken, 20);
}

TEST(LocalBound, a_window_above_it_from_the_start_may_stay_and_not_get_worse) {
  const Mesh original =
      test::grid_mesh({.rows = 5, .columns = 4, .position_noise = 0.1, .color_noise = 0.1}, 3);
  std::mt19937 random(3);
  Mesh start = original;
  Journal journal(start);
  for (int i = 0; i < 8; ++i) test::change_at_random(journal, random);
  const Frame frame = fit_frame(original, {}, 180);
  const double there =
      test::edit_error(original, start, frame, MetricKind::flip).whole_frame(start).local;
  ASSERT_GT(there, 0.05);
  const EditError error = test::edit_error(original, start, frame, MetricKind::flip, true, 0.01);
  EXPECT_TRUE(error.whole_frame(start).keeps_local_bound);
  EXPECT_FALSE(test::edit_error(original, original, frame, MetricKind::flip, true, 0.01)
                   .whole_frame(start)
                   .keeps_local_bound);
  int held = 0, broken = 0;
  for (unsigned seed = 0; seed < 3; ++seed) check_edits(original, start, seed, 0.01, held, broken);
  EXPECT_GT(broken, 0);
}

/// The largest local error of what a document's mesh has become, read again from what would be
/// written; of translucent ones the larger on white and on black.
double written_largest(const Document& before, const Document& after, const MeshReport& report,
                       MetricKind metric) {
  const Mesh mesh = parse_document(after.bytes(), "after")->mesh(after.selected({report.id})[0]);
  Frame frame = report.result.frame;
  const Mesh original = before.mesh(before.selected({report.id})[0]);
  frame.masked_opacity = mesh.color_model() == ColorModel::bilinear && !mesh.is_smooth() &&
                         is_translucent(mesh) &&
                         !method_named(report.result.method).keeps_rectangle;
  double largest = 0;
  for (const int ground : {255, 0}) {
    if (ground == 0 && !is_translucent(original)) continue;
    Frame plain = frame;
    plain.masked_opacity = false;
    plain.ground = frame.ground = std::uint8_t(ground);
    const auto reference = make_metric(metric, paint_whole(original, plain).image);
    largest = std::max(largest, naive_largest(reference->map(paint_whole(mesh, frame).image)));
  }
  return largest;
}

struct Case {
  std::filesystem::path file;
  std::string method;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.file.filename().string() << " " << c.method;
}

class Results : public ::testing::TestWithParam<Case> {};

/// With a bound that bites: below the largest local error of the result without one.
TEST_P(Results, keep_to_the_bound_as_written) {
  const auto& [file, method] = GetParam();
  if (!std::filesystem::exists(file))
    GTEST_SKIP() << file.filename() << " is not among the authors' meshes in ../shared/meshes";
  const auto before = read_document(file);
  RunOptions options;
  options.method = method;
  options.epsilon = 0.03;
  options.resolution = 160;
  for (const MeshEntry& entry : before->selected({})) {
    const Mesh& mesh = before->mesh(entry);
    if (!mesh.is_smooth() && !suits(method_named(method), mesh)) continue;
    const auto free = read_document(file), bound = read_document(file);
    options.max_local_error.reset();
    const auto without = simplify(*free, {entry.id}, options, {}, {}).front();
    EXPECT_NEAR(without.result.local_error,
                written_largest(*before, *free, without, options.metric), 1e-12);
    options.max_local_error = 0.6 * without.result.local_error;
    const auto with = simplify(*bound, {entry.id}, options, {}, {}).front();
    EXPECT_LE(with.result.error, options.epsilon);
    EXPECT_LE(with.result.local_error, *options.max_local_error);
    EXPECT_NEAR(with.result.local_error, written_largest(*before, *bound, with, options.metric),
                1e-12);
  }
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const std::string& method : method_names()) {
    if (method == "manual") continue;
    const std::filesystem::path root = GRADMESH_SOURCE_DIR, shared = GRADMESH_SHARED_DIR;
    for (const char* name : {"ellipse", "face", "fruit", "opacity", "photo", "stroke", "tensor",
                             "two", "transformed", "smooth"})
      all.push_back({root / "samples" / (std::string(name) + ".svg"), method});
    for (const char* name : {"apple", "teardrop", "modifiedgr"})
      all.push_back({shared / "meshes" / (std::string(name) + ".hemesh"), method});
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(All, Results, ::testing::ValuesIn(cases()), [](const auto& c) {
  std::string text = std::string(c.param.method) + "_" + c.param.file.stem().string();
  std::ranges::replace(text, '-', '_');
  return text;
});

TEST(LocalBound, may_keep_a_target_from_being_reached) {
  const Mesh original =
      test::grid_mesh({.rows = 6, .columns = 6, .position_noise = 0.03, .color_noise = 0.03}, 5);
  RunOptions options;
  options.resolution = 150;
  options.patches = 3;
  Mesh free = original, bound = original;
  EXPECT_LE(simplify(free, options).patches_after, 3);
  options.max_local_error = 0.1;
  const SimplifyResult result = simplify(bound, options);
  EXPECT_GT(result.patches_after, 3);
  EXPECT_LT(result.patches_after, 36);
  EXPECT_LE(result.local_error, 0.1);
}

TEST(LocalBound, prices_know_nothing_of_it) {
  const Mesh mesh =
      test::grid_mesh({.rows = 5, .columns = 5, .position_noise = 0.03, .color_noise = 0.03}, 5);
  RunOptions options;
  options.resolution = 150;
  PriceTable free, bound;
  options.analysis = &free;
  test::analyze_regions(mesh, options);
  options.max_local_error = 0.01;
  options.analysis = &bound;
  Mesh merged = mesh;
  simplify(merged, options);
  EXPECT_EQ(bound.key, free.key);
  EXPECT_EQ(bound.prices, free.prices);
}

TEST(LocalBound, refuses_a_manual_merge_that_breaks_it_but_tells_the_error) {
  const auto document =
      read_document(std::filesystem::path(GRADMESH_SOURCE_DIR) / "samples" / "fruit.svg");
  RunOptions options;
  options.method = "manual";
  options.edges = {5, 60};
  options.epsilon = 1;
  const double there = preview(*document, {}, options, {}).front().result.local_error;
  ASSERT_GT(there, 0);
  options.max_local_error = there / 2;
  EXPECT_EQ(preview(*document, {}, options, {}).front().result.local_error, there);
  try {
    simplify(*document, {}, options, {}, {});
    FAIL() << "the bound is broken";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("or than the bound in a small part."),
              std::string::npos);
  }
  options.max_local_error = there;
  EXPECT_EQ(simplify(*document, {}, options, {}, {}).front().result.local_error, there);
}

TEST(LocalBound, refuses_what_makes_no_sense) {
  Mesh mesh = test::grid_mesh();
  RunOptions options;
  for (const double bound : {-0.1, 1.1, std::numeric_limits<double>::quiet_NaN()}) {
    options.max_local_error = bound;
    EXPECT_THROW(simplify(mesh, options), std::invalid_argument);
  }
}

}  // namespace
}  // namespace gradmesh
