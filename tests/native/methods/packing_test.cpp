#include "methods/merging/packing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numeric>
#include <optional>
#include <random>

#include "base/parallel.h"
#include "base/progress.h"
#include "formats/hemesh/hemesh.h"
#include "mesh/build.h"
#include "methods/merging/regions.h"
#include "problems.h"

namespace gradmesh {
namespace {

constexpr int many_nodes = 100000;

using Items = std::vector<PackingItem>;

struct Totals {
  int saved = 0;
  double price = 0;
};

/// Nothing where two of the items overlap.
std::optional<Totals> totals(const Items& items, const Packing& packing) {
  Totals sum;
  PatchSet taken = PatchSet(items.front().patches.face_slots());
  for (const int i : packing) {
    if (taken.overlaps(items[i].patches)) return {};
    taken.add(items[i].patches);
    sum.saved += items[i].saved;
    sum.price += items[i].price;
  }
  return sum;
}

/// A rectangle of a grid of 4 x 5 patches, or any two or three of them: with these the rows of the
/// patches do not tell everything that excludes each other.
PatchSet random_patches(std::mt19937& random, bool rectangle, int& count) {
  PatchSet patches(20);
  count = 0;
  if (rectangle) {
    const auto below = [&](int end) { return int(random() % unsigned(end)); };
    const int rows = 1 + below(3), columns = 2 + below(3);
    const int top = below(5 - rows), left = below(6 - columns);
    for (int r = 0; r < rows; ++r)
      for (int c = 0; c < columns; ++c, ++count) patches.add(Face{5 * (top + r) + left + c});
    return patches;
  }
  for (const int wanted = 2 + random() % 2; count < wanted;) {
    const Face face{int(random() % 7)};
    if (patches.contains(face)) continue;
    patches.add(face);
    ++count;
  }
  return patches;
}

/// Prices from `lowest` to 1.
Items random_items(std::mt19937& random, int number, bool rectangles, double lowest) {
  std::uniform_real_distribution<double> price(lowest, 1);
  Items items;
  for (int i = 0; i < number; ++i) {
    int count = 0;
    PatchSet patches = random_patches(random, rectangles, count);
    items.push_back({std::move(patches), count - 1, price(random)});
  }
  return items;
}

/// Tries every set.
Totals best_of_all(const Items& items, double gamma) {
  Totals best;
  for (unsigned set = 0; set < 1u << items.size(); ++set) {
    Packing packing;
    for (int i = 0; i < int(items.size()); ++i)
      if (set >> i & 1) packing.push_back(i);
    const auto sum = totals(items, packing);
    if (!sum || sum->price > gamma) continue;
    if (std::pair(-sum->saved, sum->price) < std::pair(-best.saved, best.price)) best = *sum;
  }
  return best;
}

void expect_best_of_all(bool rectangles, double lowest) {
  for (unsigned seed = 0; seed < 150; ++seed) {
    std::mt19937 random(seed);
    const Items items = random_items(random, 1 + int(random() % 12), rectangles, lowest);
    const double gamma = 0.02 * double(random() % 150);
    const BestPacking found = best_packing(items, gamma, {}, many_nodes);
    const Totals wanted = best_of_all(items, gamma);
    const auto sum = totals(items, found.items);
    ASSERT_TRUE(sum) << "seed " << seed;
    EXPECT_TRUE(found.proven) << "seed " << seed;
    EXPECT_LE(sum->price, gamma) << "seed " << seed;
    EXPECT_EQ(sum->saved, wanted.saved) << "seed " << seed;
    EXPECT_NEAR(sum->price, wanted.price, 2e-6 * gamma) << "seed " << seed;
    EXPECT_TRUE(std::ranges::is_sorted(found.items)) << "seed " << seed;
  }
}

TEST(Packing, is_the_best_of_all_sets_of_rectangles) { expect_best_of_all(true, 0.01); }
TEST(Packing, is_the_best_of_all_sets_of_any_patches) { expect_best_of_all(false, 0.01); }
/// Against the picture of another mesh a merge may also lower the error.
TEST(Packing, is_the_best_of_all_sets_with_prices_below_zero) { expect_best_of_all(true, -0.5); }

TEST(Packing, of_nothing_is_empty) {
  EXPECT_EQ(best_packing({}, 1, {}, many_nodes).items, Packing{});
  std::mt19937 random(1);
  const Items items = random_items(random, 9, true, 0.01);
  EXPECT_EQ(best_packing(items, 0, {}, many_nodes).items, Packing{});
}

TEST(Packing, has_room_for_what_others_pay_for) {
  Items items;
  for (int i = 0; i < 3; ++i) {
    items.push_back({PatchSet(6), 1, std::vector{-2.0, 2.5, 1e12}[i]});
    items[i].patches.add(Face{2 * i});
    items[i].patches.add(Face{2 * i + 1});
  }
  EXPECT_EQ(best_packing(items, 1, {}, many_nodes).items, (Packing{0, 1}));
  EXPECT_EQ(best_packing(items, 0.4, {}, many_nodes).items, Packing{0});
}

/// A real mesh's worth of rectangles, in which the search has to branch.
Items hard_items() {
  std::mt19937 random(5);
  return random_items(random, 400, true, 0.01);
}

TEST(Packing, is_not_worse_than_the_start_when_nodes_run_out) {
  const Items items = hard_items();
  bool has_run_out = false;
  for (int i = 1; i <= 30; ++i) {
    const double gamma = 0.03 * i;
    const Packing best = best_packing(items, gamma, {}, many_nodes).items;
    EXPECT_EQ(best_packing(items, gamma, best, 0).items, best);
    const BestPacking early = best_packing(items, gamma, {}, 1);
    const auto sum = totals(items, early.items);
    ASSERT_TRUE(sum);
    EXPECT_LE(sum->price, gamma);
    has_run_out = has_run_out || !early.proven;
  }
  EXPECT_TRUE(has_run_out);
}

TEST(Packing, is_the_same_on_every_thread) {
  const Items items = hard_items();
  const auto packing = [&](std::size_t i) {
    return best_packing(items, 0.1 * double(i), {}, many_nodes);
  };
  std::vector<Packing> found(16);
  parallel_for(found.size(), [&](std::size_t i) { found[i] = packing(i).items; });
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i], packing(i).items) << i;
}

/// The regions of a mesh that cost at most epsilon.
Items priced_items(Mesh mesh, MetricKind metric, double epsilon) {
  const Mesh original = mesh;
  MergeTrial trial(mesh, test::edit_error(original, mesh, fit_frame(mesh, {}, 150), metric),
                   epsilon);
  PriceTable analysis;
  StopWatch watch{0, {}};
  Items items;
  for (const RegionPrice& r : price_regions(trial, analysis, epsilon, watch)) {
    PackingItem& item =
        items.emplace_back(PackingItem{PatchSet(mesh.face_slots()), r.size() - 1, r.error});
    for (const Face patch : r.patches) item.patches.add(patch);
  }
  return items;
}

/// By Eq. 7.
Packing greedy(const Items& items, double patches, double gamma) {
  Packing order(items.size()), chosen;
  std::iota(order.begin(), order.end(), 0);
  const auto score = [&](int i) {
    return 0.75 * (items[i].saved + 1) / patches - 0.25 * items[i].price / gamma;
  };
  std::ranges::stable_sort(order, [&](int a, int b) { return score(a) > score(b); });
  for (const int i : order) {
    chosen.push_back(i);
    const auto sum = totals(items, chosen);
    if (!sum || sum->price > gamma) chosen.pop_back();
  }
  return chosen;
}

class SharedPrices : public ::testing::TestWithParam<const char*> {};

TEST_P(SharedPrices, leave_the_greedy_set_behind) {
  const std::string name = GetParam();
  const std::filesystem::path path = GRADMESH_SHARED_DIR "/meshes/" + name + ".hemesh";
  std::ifstream file(path);
  if (!file) GTEST_SKIP() << "the authors' meshes are not beside the project, in ../shared/meshes";
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const Mesh mesh = build_mesh(read_hemesh(text, name));
  constexpr double epsilon = 0.005;
  const Items items = priced_items(mesh, MetricKind::ssim, epsilon);
  int more = 0;
  for (int i = 1; i <= 10; ++i) {
    const double gamma = 0.2 * epsilon * i;
    const BestPacking best = best_packing(items, gamma, {}, many_nodes);
    const Totals rival = *totals(items, greedy(items, mesh.face_count(), gamma));
    const auto sum = totals(items, best.items);
    ASSERT_TRUE(sum);
    EXPECT_TRUE(best.proven);
    EXPECT_LE(sum->price, gamma);
    EXPECT_GE(sum->saved, rival.saved);
    if (sum->saved == rival.saved) {
      EXPECT_LE(sum->price, rival.price + 1e-6 * gamma);
    }
    more += sum->saved - rival.saved;
  }
  EXPECT_GT(more, 0);
}

INSTANTIATE_TEST_SUITE_P(Packing, SharedPrices,
                         ::testing::Values("teardrop", "apple", "banana", "global-tulips"),
                         [](const auto& param) {
                           std::string name = param.param;
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace gradmesh
