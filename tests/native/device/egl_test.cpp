#include <gtest/gtest.h>

#include <filesystem>
#include <map>

#include "app/document/frames.h"
#include "app/pages/read_document.h"
#include "app/runs/devices.h"
#include "app/runs/runs.h"
#include "branch_meshes.h"
#include "device/device_errors.h"
#include "device/egl_rasterizer.h"
#include "mesh/rectangle.h"
#include "meshes.h"
#include "ops/merge/merge.h"
#include "problems.h"
#include "random_meshes.h"
#include "raster/hidden.h"
#include "same_mesh.h"
#include "trial/edit_error.h"

/// The device against the software path: pictures, errors of edits, and what is merged in the end.
/// On whatever EGL offers: on Mesa's llvmpipe where there is no hardware.
namespace gradmesh {
namespace {

/// Skips a test where there is no device.
class OnDevice : public testing::Test {
 protected:
  void SetUp() override {
    device_ = Device::open(false);
    if (!device_) GTEST_SKIP() << "EGL offers no device with OpenGL 4.3 or OpenGL ES 3.2.";
  }

  std::shared_ptr<Device> device_;
};

/// At most one level at one pixel in a thousand.
void expect_same_picture(const Rasterizer& on_device, const Mesh& mesh, const Frame& frame) {
  const Image expected = make_software_rasterizer()->paint(mesh, frame);
  const Image painted = on_device.paint(mesh, frame);
  const std::size_t count = expected.pixels();
  std::size_t differing = 0;
  int largest = 0, darkest = 255;
  for (std::size_t i = 0; i < count; ++i) {
    int most = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const int here = expected.samples[c * count + i];
      most = std::max(most, std::abs(painted.samples[c * count + i] - here));
      darkest = std::min(darkest, here);
    }
    differing += most > 0;
    largest = std::max(largest, most);
  }
  EXPECT_LT(darkest, 250) << "nothing is painted";
  EXPECT_LE(largest, 1);
  EXPECT_LE(double(differing), 0.001 * double(count));
}

const std::filesystem::path samples = GRADMESH_SOURCE_DIR "/samples";

TEST_F(OnDevice, paints_the_samples) {
  const auto rasterizer = make_egl_rasterizer(device_);
  for (const auto& file : std::filesystem::directory_iterator(samples)) {
    if (file.path().extension() != ".svg") continue;
    SCOPED_TRACE(file.path().filename().string());
    const auto document = read_document(file.path());
    for (const MeshEntry& entry : document->meshes()) {
      const Mesh mesh = document->mesh(entry);
      expect_same_picture(*rasterizer, mesh, frame_of(*document, entry, mesh, 400));
    }
  }
}

/// From hardly bent to folded over and over, in both colour models, with T-junctions.
TEST_F(OnDevice, paints_folds_and_t_junctions) {
  const auto rasterizer = make_egl_rasterizer(device_);
  for (unsigned seed = 0; seed < 24; ++seed) {
    SCOPED_TRACE(seed);
    const MeshParts parts =
        test::grid_parts({.rows = 4,
                          .columns = 3,
                          .position_noise = 0.05 + 0.05 * double(seed % 12),
                          .color_noise = 0.4,
                          .color_model = seed % 2 ? ColorModel::bicubic : ColorModel::bilinear},
                         seed);
    const Mesh mesh = test::changed_mesh(parts, seed, 6);
    expect_same_picture(*rasterizer, mesh, fit_frame(mesh, {}, 250));
  }
}

TEST_F(OnDevice, paints_opacities_and_leaves_hidden_pixels_white) {
  const auto rasterizer = make_egl_rasterizer(device_);
  const auto document = read_document(samples / "opacity.svg");
  for (const MeshEntry& entry : document->meshes()) {
    const Mesh mesh = document->mesh(entry);
    Frame frame = frame_of(*document, entry, mesh, 300);
    frame.masked_opacity = true;
    expect_same_picture(*rasterizer, mesh, frame);
    const double radius = 80;
    const glm::dvec2 centre =
        frame.to_pixels.inverse().point(0.5 * glm::dvec2(frame.width, frame.height));
    const double unit = radius / std::sqrt(std::abs(frame.to_pixels.determinant()));
    VisibleArea area;
    area.sets = {{{{{centre + unit * glm::dvec2(-1, -1), centre + unit * glm::dvec2(1, -1),
                     centre + unit * glm::dvec2(0, 1)}}}}};
    frame.hidden = std::make_shared<HiddenPixels>(area, frame);
    expect_same_picture(*rasterizer, mesh, frame);
  }
}

/// Merges and splits, one after the other; of meshes that lie over themselves too, where what was
/// below comes to light.
TEST_F(OnDevice, measures_edits) {
  for (const MetricKind metric : {MetricKind::flip, MetricKind::ssim})
    for (unsigned seed = 0; seed < 6; ++seed) {
      SCOPED_TRACE(seed);
      std::mt19937 random(seed);
      Mesh mesh = test::grid_mesh(
          {.rows = 5, .columns = 4, .position_noise = seed < 3 ? 0.1 : 0.5, .color_noise = 0.3},
          seed);
      EditError error = test::edit_error(mesh, mesh, fit_frame(mesh, {}, 120), metric);
      Journal journal(mesh);
      for (int step = 0; step < 6; ++step) {
        const auto on_device = error.on_device(device_);
        test::change_at_random(journal, random);
        EditTile tile;
        error.describe(journal, journal.depth() - 1, tile);
        on_device->submit(std::span(&tile, 1));
        const double rise = on_device->rises().front() / double(error.pixels());
        EXPECT_NEAR(rise, error.after_edits(journal, journal.depth() - 1) - error.error(), 1e-6);
        error.accept(journal);
      }
    }
}

/// Every way of choosing merges the same on both: the same documents to the byte.
class SampleOnDevice : public OnDevice, public testing::WithParamInterface<std::string> {};

TEST_P(SampleOnDevice, is_merged_the_same) {
  const std::filesystem::path file = samples / (GetParam() + ".svg");
  for (const MetricKind metric : {MetricKind::flip, MetricKind::ssim}) {
    // What was priced for one method is not priced again for the next.
    std::map<int, PriceTable> prices, prices_on_device;
    PriceFiles none({});
    for (const std::string& method : method_names()) {
      if (method == "manual") continue;
      SCOPED_TRACE(std::string(method) + ", " + name(metric));
      RunOptions options;
      options.method = method;
      options.metric = metric;
      options.resolution = 64;
      options.device_lost = [](const DeviceError& fault) { ADD_FAILURE() << fault.what(); };
      const auto document = read_document(file);
      for (const MeshEntry& entry : document->meshes()) {
        const Problem expected = problem_of(*document, entry, options, none);
        const Problem found = problem_of(*document, entry, options, none);
        expected.price_with({&prices[entry.index]});
        found.price_with(
            {&prices_on_device[entry.index], [&] { return device_; }, options.device_lost});
        // Smooth meshes are merged by lines whatever is asked for.
        const Method& used = method_named(method);
        if (!suits(used, expected.mesh())) continue;
        StopWatch watch(0, {});
        const SimplifyResult here = simplify(expected, used, watch);
        const SimplifyResult there = simplify(found, used, watch);
        EXPECT_EQ(here.renderer, "software");
        EXPECT_EQ(there.renderer, used.needs_prices ? device_->info().name : "software");
        EXPECT_EQ(here.patches_after, there.patches_after);
        EXPECT_EQ(here.error, there.error);
        EXPECT_TRUE(test::same(here.mesh, there.mesh));
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Samples, SampleOnDevice,
                         testing::Values("ellipse", "face", "fruit", "opacity", "photo", "smooth",
                                         "stroke", "tensor", "transformed", "two"),
                         [](const auto& sample) { return sample.param; });

/// Wherever the device is lost, the cores go on, and the person is told once.
TEST_F(OnDevice, a_lost_device_changes_nothing) {
  const Mesh start = build_mesh(test::cross(3));
  const auto patches_left = [&](RunOptions options) {
    Mesh mesh = start;
    options.resolution = 150;
    options.epsilon = 0.02;
    options.method = "gqe";
    const SimplifyResult result = simplify(mesh, options);
    return std::pair(result.patches_after, result.error);
  };
  const auto expected = patches_left({});
  // As many uses as one that is not lost takes: its objects, the picture, batches, their numbers.
  for (int uses = 1; uses < 100; ++uses) {
    SCOPED_TRACE(uses);
    RunOptions options;
    options.device = Device::open(false);
    options.device->lose_after(uses);
    int told = 0;
    options.device_lost = [&](const DeviceError& error) {
      ++told;
      EXPECT_STREQ(error.what(), "the device was lost");
    };
    EXPECT_EQ(patches_left(options), expected);
    if (told == 0) {
      EXPECT_GT(uses, 4);
      return;
    }
    EXPECT_EQ(told, 1);
    // It is not asked again.
    EXPECT_EQ(patches_left(options), expected);
    EXPECT_EQ(told, 1);
  }
}

TEST_F(OnDevice, a_frame_beyond_its_memory_is_refused) {
  if (device_->info().is_hardware) GTEST_SKIP() << "how much it has is not known";
  // Mesa's programs take buffers of 128 MiB at most; this one is larger.
  const Frame frame{8192, 4097};
  EXPECT_THROW(DeviceErrors(device_, MetricKind::flip, Image(frame.width, frame.height), frame),
               DeviceError);
}

/// `auto` decides by what was measured.
TEST(Renderer, takes_the_faster_one) {
  const Speeds speeds{{0.01, 1e-7}, {0.2, 1e-9}};
  EXPECT_FALSE(faster(speeds, 1e5).takes_device);
  EXPECT_TRUE(faster(speeds, 1e7).takes_device);
  EXPECT_EQ(faster(speeds, 1e7).reason.english(),
            "pricing takes about 0.21 s on the device and 1 s in software");
}

TEST(Renderer, has_names) {
  for (const Renderer r : {Renderer::automatic, Renderer::software, Renderer::egl})
    EXPECT_EQ(renderer_named(name(r)), r);
  EXPECT_THROW(renderer_named("vulkan"), std::invalid_argument);
  EXPECT_EQ(open_device(Renderer::software), nullptr);
}

/// Four pairs of halves in a square of two by two patches. With the two above merged one such pair
/// is left, as no two patches merge across the side with the T-junction; with the two below merged
/// too, a pair that fills the square.
TEST(PricedPixels, are_those_of_patches_that_can_merge) {
  Mesh mesh = test::grid_mesh({.rows = 2, .columns = 2});
  const Frame frame = fit_frame(mesh, {}, 300);
  const auto pixels = [&] { return priced_pixels(mesh, frame, MetricKind::ssim); };
  Journal journal(mesh);
  const double half = pixels() / 4;
  merge(journal, test::between(mesh, Face{0}, Face{1}));
  const double with_t_junction = pixels();
  merge(journal, test::between(mesh, Face{2}, Face{3}));
  const double whole = pixels();
  EXPECT_LT(half, 0.6 * whole);
  EXPECT_EQ(with_t_junction, half);
}

TEST_F(OnDevice, its_speed_is_measured) {
  const Speeds speeds = measure_speeds(device_, 1);
  EXPECT_GT(speeds.software.per_pixel, 0);
  EXPECT_GT(speeds.device.per_pixel, 0);
}

}  // namespace
}  // namespace gradmesh
