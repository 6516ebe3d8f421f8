// What goes wrong in the middle of a run: no memory, a fault on another thread, a person who stops.
#include <gtest/gtest.h>

#include <atomic>
#include <climits>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <new>
#include <random>

#include "app/pages/read_document.h"
#include "app/runs/runs.h"
#include "base/error.h"
#include "base/parallel.h"
#include "mesh/validate.h"
#include "meshes.h"

namespace {

/// How many allocations succeed before one fails, and whether all fail from there on. Off: below 0.
std::atomic<long> left = -1;
std::atomic<bool> and_all_after = false;
std::atomic<long> counted = 0;

bool allocation_fails() {
  ++counted;
  long n = left;
  while (n > 0 && !left.compare_exchange_weak(n, n - 1)) {
  }
  if (n != 0) return false;
  if (!and_all_after) left = -1;
  return true;
}

#ifdef _WIN32
void* allocate_aligned(std::size_t size, std::size_t alignment) {
  return _aligned_malloc(size, alignment);
}
void free_aligned(void* memory) { _aligned_free(memory); }
#else
void* allocate_aligned(std::size_t size, std::size_t alignment) {
  return std::aligned_alloc(alignment, (size + alignment - 1) & ~(alignment - 1));
}
void free_aligned(void* memory) { std::free(memory); }
#endif

void* allocate(std::size_t size, std::size_t alignment) {
  if (allocation_fails()) throw std::bad_alloc();
  void* const memory = alignment ? allocate_aligned(size, alignment) : std::malloc(size ? size : 1);
  if (!memory) throw std::bad_alloc();
  return memory;
}

}  // namespace

void* operator new(std::size_t size) { return allocate(size, 0); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocate(size, std::size_t(alignment));
}
/// The library's would call the first, a sanitizer's would not; std::stable_sort does with less.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return allocation_fails() ? nullptr : std::malloc(size ? size : 1);
}
// GCC takes the library's operator new for what allocated the memory.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"
#endif
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { free_aligned(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { free_aligned(memory); }

namespace gradmesh {
namespace {

using test::grid_mesh;

std::string sample(const std::string& name) {
  std::ifstream file(std::string(GRADMESH_SOURCE_DIR) + "/samples/" + name);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// All that a run over an SVG document does, from bytes to bytes.
std::string read_simplify_write(const std::string& bytes) {
  RunOptions options;
  options.resolution = 32;
  options.epsilon = 0.02;
  const auto document = parse_document(bytes, "drawing.svg");
  simplify(*document, {}, options);
  return document->bytes();
}

class Faults : public testing::Test {
 protected:
  ~Faults() override { left = -1; }

  /// The run with that many allocations that succeed: whether it told of the one that failed. Where
  /// it did not, because that one could be done without, the result must be right.
  bool decides(long successes, bool all_after) {
    and_all_after = all_after;
    left = successes;
    bool told = false;
    std::string result;
    try {
      result = read_simplify_write(bytes_);
    } catch (const std::bad_alloc&) {
      told = true;
    } catch (const InputError&) {
      told = true;
    }
    left = -1;
    EXPECT_TRUE(told || result == usual_);
    return told;
  }

  const std::string bytes_ = sample("tensor.svg");
  const std::string usual_ = read_simplify_write(bytes_);
};

TEST_F(Faults, an_allocation_that_fails_ends_the_run_with_an_exception) {
  counted = 0;
  EXPECT_EQ(read_simplify_write(bytes_), usual_);
  const long all = counted;
  ASSERT_GT(all, 5000);

  std::mt19937 random(1);
  std::uniform_int_distribution<long> any(0, all - 1);
  int told = 0, runs = 0;
  // Reading and writing allocate often and in many places, merging over and over in the same.
  for (long n = 0; n < 2000; n += 13) told += decides(n, n % 2), ++runs;
  for (int i = 0; i < 60; ++i) told += decides(any(random), i % 2), ++runs;
  EXPECT_GT(told, runs * 9 / 10);
  EXPECT_EQ(read_simplify_write(bytes_), usual_);
}

TEST_F(Faults, a_document_whose_run_failed_is_as_it_was) {
  RunOptions options;
  options.resolution = 32;
  for (const long n : {10, 100, 1000, 3000}) {
    const auto document = parse_document(bytes_, "drawing.svg");
    and_all_after = true;
    left = n;
    EXPECT_THROW(simplify(*document, {}, options), std::bad_alloc);
    left = -1;
    EXPECT_EQ(document->bytes(), bytes_);
    simplify(*document, {}, options);  // and can still be simplified
    EXPECT_NE(document->bytes(), bytes_);
  }
}

TEST_F(Faults, of_a_worker_reach_the_caller) {
  std::atomic<int> done = 0;
  const auto body = [&](std::size_t i) {
    ++done;
    if (i == 77) throw std::runtime_error("from a worker");
  };
  EXPECT_THROW(parallel_for(1000, body), std::runtime_error);
  EXPECT_GT(done, 0);
}

/// Simplifies until it has said `most` times how far it is; how often it did.
long run_until(long most, Mesh& mesh, RunOptions options) {
  long said = 0;
  options.progress = [&](const Progress&) { return ++said < most; };
  const SimplifyResult result = simplify(mesh, options);
  EXPECT_EQ(result.stopped == Stopped::cancelled, said == most);
  EXPECT_EQ(result.patches_after, mesh.face_count());
  EXPECT_LE(result.error, options.epsilon);
  EXPECT_EQ(validate(mesh), std::vector<std::string>{});
  return said;
}

TEST(Cancelling, leaves_a_mesh_that_keeps_to_epsilon_wherever_it_happens) {
  std::mt19937 random(3);
  int cancelled = 0;
  for (int i = 0; cancelled < 1000 && i < 2000; ++i) {
    RunOptions options;
    options.method = method_names()[std::size_t(i) % 8];
    ASSERT_NE(options.method, "manual");
    options.metric = i % 3 ? MetricKind::flip : MetricKind::ssim;
    options.resolution = 40;
    options.epsilon = 0.02;
    options.seed = std::uint64_t(i);
    options.threads = 1 + i % 2;
    const Mesh original = grid_mesh(
        {.rows = 4, .columns = 4, .position_noise = 0.03, .color_noise = 0.03}, unsigned(i) % 16);
    Mesh mesh = original, stopped = original;
    const long all = run_until(LONG_MAX, mesh, options);
    ASSERT_GE(all, 1);
    const long point = std::uniform_int_distribution<long>(1, all)(random);
    // How often one of two threads gets to say so follows the moment, so that the point may be
    // beyond the end.
    cancelled += run_until(point, stopped, options) == point;
  }
  EXPECT_EQ(cancelled, 1000);
}

}  // namespace
}  // namespace gradmesh
