#include "app/runs/price_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <random>
#include <sstream>

#include "app/document/document.h"
#include "base/error.h"
#include "base/hash.h"
#include "files/atomic_file.h"
#include "meshes.h"
#include "problems.h"
#include "random_meshes.h"
#include "simplify/simplify.h"

namespace gradmesh {
namespace {

using test::grid_mesh;

/// A path of this test's own, without a file.
std::filesystem::path scratch(const std::string& name) {
  const auto folder = std::filesystem::path(testing::TempDir()) /
                      testing::UnitTest::GetInstance()->current_test_info()->name();
  std::filesystem::create_directories(folder);
  std::filesystem::remove(folder / name);
  return folder / name;
}

RunOptions small_options(MetricKind metric = MetricKind::ssim) {
  RunOptions options;
  options.metric = metric;
  options.resolution = 80;
  options.epsilon = 0.05;
  return options;
}

/// A mesh with edges that can be merged and, at T-junctions, edges that cannot.
Mesh mixed_mesh() {
  std::mt19937 random(3);
  const test::GridOptions grid{
      .rows = 6, .columns = 6, .position_noise = 0.03, .color_noise = 0.03};
  return test::changed_mesh(test::grid_parts(grid, random), 3, 10, 2);
}

PriceTable analysis_of(const Mesh& mesh, RunOptions options) {
  PriceTable analysis;
  options.analysis = &analysis;
  test::analyze_regions(mesh, options);
  return analysis;
}

void write(const std::filesystem::path& path, const std::vector<PriceTable>& analyses) {
  PriceFiles files({{}, path});
  for (const PriceTable& a : analyses) files.start(a.key, Mesh()) = a;
  files.save();
}

/// The prices in the file for this mesh.
std::map<Region, Price> loaded(const std::filesystem::path& path, const PriceTableKey& key,
                               const Mesh& mesh) {
  return PriceFiles({path, {}}).start(key, mesh).prices;
}

/// The sentence with which `work` is refused.
template <class Work>
std::string refusal(const Work& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << "nothing was refused";
  return "";
}

TEST(AnalysisFile, gives_back_what_was_written) {
  const Mesh first = mixed_mesh(), second = grid_mesh();
  const RunOptions options = small_options();
  PriceTable a = analysis_of(first, options);
  const PriceTable b = analysis_of(second, options);
  a.prices.begin()->second = {INFINITY};
  std::next(a.prices.begin())->second.exact = false;
  const auto path = scratch("prices.json");
  write(path, {a, b});

  EXPECT_EQ(loaded(path, a.key, first), a.prices);
  EXPECT_EQ(loaded(path, b.key, second), b.prices);
  EXPECT_GT(a.prices.size(), 20u);
}

TEST(AnalysisFile, what_was_loaded_is_saved_with_what_was_added) {
  const Mesh first = mixed_mesh(), second = grid_mesh();
  RunOptions options = small_options();
  const PriceTable a = analysis_of(first, options), b = analysis_of(second, options);
  const auto path = scratch("prices.json"), more = scratch("more.json");
  write(path, {a, {b.key, {*b.prices.begin()}}});
  PriceFiles files({path, more});
  options.analysis = &files.start(b.key, second);
  test::analyze_regions(second, options);
  files.save();
  EXPECT_EQ(loaded(more, a.key, first), a.prices);
  EXPECT_EQ(loaded(more, b.key, second), b.prices);
}

TEST(AnalysisFile, loaded_prices_serve_every_epsilon_below_and_every_omega_and_kappa) {
  const Mesh mesh = mixed_mesh();
  RunOptions options = small_options();
  const auto path = scratch("prices.json");
  write(path, {analysis_of(mesh, options)});
  for (const std::string method : {"gqe", "gqe1"})
    for (const double epsilon : {0.05, 0.02})
      for (const double omega : {0.0, 0.5}) {
        options.method = method;
        options.epsilon = epsilon;
        options.omega = omega;
        Mesh fresh = mesh, known = mesh;
        PriceTable priced;
        options.analysis = &priced;
        const SimplifyResult without = simplify(fresh, options);
        PriceFiles files({path, {}});
        PriceTable& analysis = files.start(test::problem(mesh, options).price_key(), mesh);
        const std::size_t prices = analysis.prices.size();
        options.analysis = &analysis;
        const SimplifyResult with = simplify(known, options);
        const auto measured = std::ranges::count_if(
            priced.prices, [](const auto& price) { return std::isfinite(price.second.error); });
        EXPECT_GT(measured, 0);
        EXPECT_EQ(with.evaluations, without.evaluations - measured);
        EXPECT_EQ(analysis.prices.size(), prices);
        EXPECT_EQ(with.error, without.error);
        ASSERT_EQ(known.face_count(), fresh.face_count());
        for (const Face f : fresh.faces()) EXPECT_EQ(known.patch(f), fresh.patch(f));
      }
}

TEST(AnalysisFile, says_what_differs) {
  const Mesh mesh = grid_mesh();
  const RunOptions options = small_options();
  const auto path = scratch("prices.json");
  write(path, {analysis_of(mesh, options)});
  const std::string start = path.string() + ": this analysis ";
  const auto refused = [&](const Mesh& wanted, const RunOptions& with) {
    return refusal([&] { loaded(path, test::problem(wanted, with).price_key(), wanted); });
  };

  EXPECT_EQ(refused(grid_mesh({.rows = 4}), options),
            start + "is of another mesh, or the mesh was changed since.");
  EXPECT_EQ(refused(mesh, small_options(MetricKind::flip)),
            start + "was made with the metric ssim, not flip.");
  RunOptions other = options;
  other.resolution = 90;
  EXPECT_EQ(refused(mesh, other), start + "was made at 80 x 80 pixels, not 90 x 90 pixels.");
  other = options;
  other.view = Affine::scaling({-1, 1});
  EXPECT_EQ(refused(mesh, other),
            start + "was made before the mesh was moved, transformed or clipped.");
  std::mt19937 random(1);
  MeshParts parts = test::grid_parts({}, random);
  parts.color_model = ColorModel::bicubic;
  const Mesh bicubic = build_mesh(parts);
  other = options;
  other.original = original_of(std::make_shared<const Mesh>(mesh));
  EXPECT_EQ(refused(bicubic, other), start + "was made in the color model bilinear, not bicubic.");
}

TEST(AnalysisFile, of_several_the_closest_is_told_about) {
  const Mesh mesh = grid_mesh();
  const auto path = scratch("prices.json");
  RunOptions coarse = small_options();
  coarse.resolution = 40;
  write(path, {analysis_of(grid_mesh({.rows = 4}), small_options()), analysis_of(mesh, coarse)});
  EXPECT_EQ(refusal([&] { loaded(path, test::problem(mesh, small_options()).price_key(), mesh); }),
            path.string() + ": this analysis was made at 40 x 40 pixels, not 80 x 80 pixels.");
}

TEST(AnalysisFile, refuses_other_and_empty_files) {
  const auto path = scratch("prices.json");
  EXPECT_NE(refusal([&] { PriceFiles({path, {}}); }).find("cannot be read"), std::string::npos);
  for (const char* text : {"", "{}", "HEMESH\n", "<svg/>"}) {
    write_bytes(path, text);
    EXPECT_EQ(refusal([&] {
                PriceFiles({path, {}});
              }),
              path.string() + ": this is no file with an analysis.");
  }
  write_bytes(path, R"({"format": "gradmesh analysis", "version": 7})");
  EXPECT_EQ(refusal([&] {
              PriceFiles({path, {}});
            }),
            path.string() +
                ": this analysis has the format version 7, but only version 2 is known here.");
  write(path, {});
  const Mesh mesh = grid_mesh();
  EXPECT_EQ(refusal([&] {
              PriceFiles({path, {}}).start(test::problem(mesh, small_options()).price_key(), mesh);
            }),
            path.string() + ": this analysis holds no mesh.");
}

TEST(AnalysisFile, no_damage_passes) {
  const Mesh mesh = grid_mesh();
  const RunOptions options = small_options();
  const PriceTable analysis = analysis_of(mesh, options);
  const auto path = scratch("prices.json");
  write(path, {analysis});
  const std::string whole = read_bytes(path);
  std::mt19937 random(5);
  for (int i = 0; i < 200; ++i) {
    std::string text = whole;
    if (i % 2 == 0) {
      text.resize(random() % (text.size() - 2));
    } else {
      text[random() % (text.size() - 1)] = "0123456789,]}\"e-n"[random() % 17];
    }
    write_bytes(path, text);
    try {
      // Only where the damage changed nothing that is said.
      EXPECT_EQ(loaded(path, analysis.key, mesh), analysis.prices) << text;
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).rfind(path.string() + ": ", 0), 0u) << error.what();
    }
  }
}

/// The text of a file that holds these analyses, which are JSON in its shortest form.
std::string file_of(const std::string& analyses) {
  Hash hash;
  hash.add(analyses);
  std::ostringstream text;
  text << R"({"format": "gradmesh analysis", "version": 2, "checksum": ")" << std::hex
       << std::setw(16) << std::setfill('0') << hash.value() << R"(", "analyses": )" << analyses
       << "}";
  return text.str();
}

TEST(AnalysisFile, takes_whole_numbers_only_where_those_are_meant) {
  const auto with = [](const std::string& width, const std::string& face) {
    return file_of(R"([{"original":"1","content":"2","metric":"flip","width":)" + width +
                   R"(,"height":5,"color_model":"bicubic","prices":[[)" + face +
                   R"(,0,1,2,0.5,true]]}])");
  };
  EXPECT_EQ(parse_analyses(with("4", "3"), "prices").front().key.width, 4);
  for (const std::string number : {"4.0", "1e+300", "4294967300", "18446744073709551616", "null"})
    for (const std::string& text : {with(number, "3"), with("4", number)})
      EXPECT_EQ(refusal([&] { parse_analyses(text, "prices"); }),
                "prices: this analysis is damaged or cut off.");
}

TEST(AnalysisFile, refuses_brackets_without_end) {
  const std::string brackets = std::string(100'000, '[') + std::string(100'000, ']');
  const std::string before = R"({"format": "gradmesh analysis", "version": )";
  for (const std::string& text : {before + brackets + "}", before + std::string(100'000, '['),
                                  before + R"(2, "analyses": )" + brackets + "}"})
    EXPECT_EQ(refusal([&] { parse_analyses(text, "prices"); }),
              "prices: this analysis is damaged or cut off.");
}

TEST(AnalysisFile, refuses_regions_that_are_not_in_the_mesh) {
  const Mesh mesh = grid_mesh();
  const RunOptions options = small_options();
  const PriceTableKey key = test::problem(mesh, options).price_key();
  const auto path = scratch("prices.json");
  for (const Region& region :
       {Region{Face{-1}, 0, 1, 2}, Region{Face{9}, 0, 1, 2}, Region{Face{0}, 4, 1, 2},
        Region{Face{0}, -1, 1, 2}, Region{Face{0}, 0, 0, 2}, Region{Face{0}, 0, 1, 1 << 30},
        Region{Face{0}, 0, 4, 1}, Region{Face{4}, 2, 2, 2}}) {
    write(path, {PriceTable{key, {{region, {0.5}}}}});
    EXPECT_EQ(refusal([&] { loaded(path, key, mesh); }),
              path.string() + ": this analysis has a region that is not in the mesh, at patch " +
                  std::to_string(region.face.value) + ".");
  }
}

}  // namespace
}  // namespace gradmesh
