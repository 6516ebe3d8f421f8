#include <gtest/gtest.h>

#include <filesystem>

#include "document/document.h"
#include "error/edit_error.h"
#include "random_meshes.h"
#include "raster/egl/edit_errors.h"
#include "raster/egl/egl_rasterizer.h"

/// The device against the software path. Runs on whatever EGL offers, on Mesa's llvmpipe where there
/// is no hardware; skipped where there is no EGL.
namespace gradmesh {
namespace {

class OnDevice : public testing::Test {
 protected:
  void SetUp() override {
    device_ = Device::open(false);
    if (!device_) GTEST_SKIP() << "EGL offers no device with OpenGL 4.3 or OpenGL ES 3.2.";
  }

  std::shared_ptr<Device> device_;
};

struct Differences {
  std::size_t pixels = 0;
  int largest = 0;
};

Differences differences(const Image& a, const Image& b) {
  Differences found;
  const std::size_t count = a.pixels();
  for (std::size_t i = 0; i < count; ++i) {
    int most = 0;
    for (std::size_t c = 0; c < 3; ++c)
      most = std::max(most, std::abs(a.samples[c * count + i] - b.samples[c * count + i]));
    found.pixels += most > 0;
    found.largest = std::max(found.largest, most);
  }
  return found;
}

/// The images as the issue bounds them: one level at one pixel in a thousand.
void expect_same_picture(const std::shared_ptr<Device>& device, const Mesh& mesh,
                         const Frame& frame) {
  const Image software = make_software_rasterizer()->paint(mesh, frame);
  const Image painted = make_egl_rasterizer(device)->paint(mesh, frame);
  const Differences found = differences(software, painted);
  EXPECT_LE(found.largest, 1);
  EXPECT_LE(double(found.pixels), 0.001 * double(software.pixels()));
  ::testing::Test::RecordProperty("pixels", int(found.pixels));
  std::printf("%zu of %zu differ, by at most %d\n", found.pixels, software.pixels(), found.largest);
}

TEST_F(OnDevice, paints_the_samples_as_the_software_does) {
  const std::filesystem::path folder = std::filesystem::path(GRADMESH_SOURCE_DIR) / "samples";
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    if (file.path().extension() != ".svg") continue;
    SCOPED_TRACE(file.path().filename().string());
    const auto document = Document::read_file(file.path());
    for (const MeshEntry& entry : document->meshes()) {
      const Mesh mesh = document->mesh(entry);
      expect_same_picture(device_, mesh, document->frame(entry, mesh, 400));
    }
  }
}

TEST_F(OnDevice, measures_random_edits_as_the_software_does) {
  for (const MetricKind metric : {MetricKind::flip, MetricKind::ssim})
    for (unsigned seed = 0; seed < 4; ++seed) {
      SCOPED_TRACE(seed);
      std::mt19937 random(seed);
      Mesh mesh = test::grid_mesh(
          {.rows = 5, .columns = 4, .position_noise = 0.1, .color_noise = 0.3}, seed);
      const Frame frame = fit_frame(mesh, {}, 180);
      const Image original = make_software_rasterizer()->paint(mesh, frame);
      EditError error(mesh, mesh, frame, metric);
      EditErrors on_device(device_, metric, original, frame);
      EditTiler tiler;
      Journal journal(mesh);
      for (int step = 0; step < 8; ++step) {
        const auto state = error.state();
        on_device.start(state->painting);
        test::change_at_random(journal, random);
        const double after = error.after_edits(journal, journal.depth() - 1);
        EditTile tile;
        tiler.make(mesh, frame, journal.touched_since(journal.depth() - 1), frame.window(),
                   state->painting, tile);
        on_device.submit(std::span(&tile, 1));
        const double rise = on_device.rises().front() / double(state->map.pixels());
        EXPECT_NEAR(rise, after - error.error(), 1e-6);
        error.accept(journal);
      }
    }
}

}  // namespace
}  // namespace gradmesh
