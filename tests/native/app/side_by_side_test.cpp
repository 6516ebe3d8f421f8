// Runs over several meshes at the same time (app/runs/side_by_side.h).
#include "app/runs/side_by_side.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>

namespace gradmesh {
namespace {

std::vector<Progress> two_meshes() { return {{0, 1, 4, 0, 0, 0, 2}, {0, 1, 9, 0, 0, 1, 2}}; }

/// Tells until the caller has cancelled.
void tell_until_cancelled(SideBySide& runs, std::size_t mesh) {
  const ProgressCallback tell = runs.progress_of(mesh);
  while (tell({1, 2, 4, 0.1, 0})) std::this_thread::yield();
}

TEST(SideBySide, are_all_cancelled_by_a_caller_who_has_enough) {
  int told = 0;
  SideBySide runs([&](const Progress&) { return ++told < 3; }, two_meshes());
  runs.run(2, 2, [&](std::size_t mesh) { tell_until_cancelled(runs, mesh); });
  EXPECT_EQ(told, 3);
}

TEST(SideBySide, throw_what_the_caller_throws) {
  SideBySide runs([](const Progress&) -> bool { throw std::domain_error("of the caller"); },
                  two_meshes());
  EXPECT_THROW(runs.run(2, 2,
                        [&](std::size_t mesh) {
                          tell_until_cancelled(runs, mesh);
                          throw std::range_error("of the work");
                        }),
               std::domain_error);
}

TEST(SideBySide, throw_what_the_work_throws) {
  SideBySide runs([](const Progress&) { return true; }, two_meshes());
  EXPECT_THROW(runs.run(2, 1, [](std::size_t) { throw std::range_error("of the work"); }),
               std::range_error);
}

TEST(SideBySide, are_told_of_one_after_the_other) {
  std::vector<std::size_t> meshes;
  SideBySide runs(
      [&](const Progress& now) {
        if (meshes.empty() || meshes.back() != now.mesh) meshes.push_back(now.mesh);
        return true;
      },
      two_meshes());
  // The second one ends first.
  std::atomic<bool> has_ended = false;
  runs.run(2, 2, [&](std::size_t job) {
    const std::size_t mesh = 1 - job;
    if (mesh == 0)
      while (!has_ended) std::this_thread::yield();
    runs.progress_of(mesh)({1, 2, 4, 0.1, 0});
    runs.end(mesh);
    has_ended = true;
  });
  EXPECT_EQ(meshes, (std::vector<std::size_t>{0, 1}));
}

}  // namespace
}  // namespace gradmesh
