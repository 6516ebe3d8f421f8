#include "device/tile_metric.h"

#include <map>

#include "egl_shaders.h"
#include "metric/appearance.h"
#include "metric/appearance_taps.h"
#include "metric/colour_matrices.h"
#include "metric/ssim.h"

namespace gradmesh {
namespace {

template <int Radius>
std::string taps(const char* name, const Taps<float, Radius>& values) {
  return constant(name, std::span<const float>(values.at));
}

std::string matrix(const char* name, const Linear& linear) {
  return constant(name, std::span<const float>(linear.m.front().data(), 9));
}

std::string flip_source() {
  const ColourTaps& colour = ColourTaps::get();
  const FeatureTaps& feature = FeatureTaps::get();
  return constant("SHORT_REACH", ColourTaps::short_reach) +
         constant("FEATURE_REACH", FeatureTaps::reach) + taps("LUMINANCE_TAPS", colour.luminance) +
         taps("RED_GREEN_TAPS", colour.red_green) +
         taps("BLUE_YELLOW_WIDE_TAPS", colour.blue_yellow_wide) +
         taps("BLUE_YELLOW_NARROW_TAPS", colour.blue_yellow_narrow) +
         taps("SMOOTH_TAPS", feature.smooth) + taps("SLOPE_TAPS", feature.slope) +
         taps("CURVATURE_TAPS", feature.curvature) + matrix("RGB_TO_OPPONENT", rgb_to_opponent) +
         matrix("OPPONENT_TO_RGB", opponent_to_rgb) + matrix("RGB_TO_WHITE_XYZ", rgb_to_white_xyz) +
         shaders::flip_glsl;
}

std::string ssim_source() { return taps("GAUSSIAN_TAPS", ssim_taps()) + shaders::ssim_glsl; }

/// The shader of a metric and what it needs.
struct MetricShader {
  std::string (*source)();
  /// Number of planes of floats that are kept of the reference image.
  std::size_t planes;
  /// Fills the table that the source reads.
  void (*write_table)(Buffer& table, const Image& reference);
};

/// Returns the shader of a metric. Throws DeviceError for a metric that has none.
const MetricShader& shader_of(MetricKind kind) {
  static const std::map<MetricKind, MetricShader> shaders = {
      {MetricKind::flip,
       {flip_source, 5,
        [](Buffer& table, const Image&) { table.write(std::span<const float>(linear_light())); }}},
      {MetricKind::ssim,
       {ssim_source, 6,
        [](Buffer& table, const Image& reference) {
          table.write(std::span<const std::uint32_t>(packed(reference)));
        }}},
  };
  const auto found = shaders.find(kind);
  if (found == shaders.end())
    throw DeviceError(Message("the metric {0} has no shader", name(kind)));
  return found->second;
}

/// Returns a tile of the whole frame that changes nothing.
AtlasTile whole_frame(const Image& image, int blocks) {
  return {{}, image.window(), 0, 0, 0, 0, 0, blocks};
}

enum class Pass { reference, distances, rises };

std::string pass_source(MetricKind kind, Pass pass) {
  static constexpr const char* names[] = {"REFERENCE", "DISTANCES", "RISES"};
  std::string passes;
  for (int i = 0; i < 3; ++i)
    passes += std::string("#define ") + names[i] + " " + std::to_string(i) + "\n";
  passes += std::string("#define PASS ") + names[int(pass)] + "\n";
  return shader_source({passes, constant("REACH", metric_reach(kind)), tiles_source(),
                        shaders::metric_glsl, shader_of(kind).source()});
}

int blocks_of_frame(int width, int height) { return ((width + 15) / 16) * ((height + 15) / 16); }

}  // namespace

TileMetric::TileMetric(const Device::Use& use, MetricKind kind, const Image& image)
    : reach_(metric_reach(kind)),
      distances_(use.program(pass_source(kind, Pass::distances))),
      rises_(use.program(pass_source(kind, Pass::rises))),
      total_(use.program(shader_source({tiles_source(), shaders::total_glsl}))) {
  FrameImage picture;
  picture.set(image);
  const MetricShader& shader = shader_of(kind);
  shader.write_table(table_, image);
  const std::size_t pixels = image.pixels();
  reference_.reserve(shader.planes * pixels * sizeof(float));
  map_.reserve(pixels * sizeof(float));
  block_rises_.reserve(sizeof(float));
  const AtlasTile whole = whole_frame(image, blocks_of_frame(image.width, image.height));
  whole_.write(std::span(&whole, 1));
  run_whole(use.program(pass_source(kind, Pass::reference)), picture);
}

void TileMetric::run(const Program& program, const Buffer& tiles, int blocks,
                     const FrameImage& picture, const Buffer& colors) {
  program.use();
  program.set("count", blocks);
  program.set("frame_size", picture.width, picture.height);
  program.set("plane_size", picture.width * picture.height);
  tiles.bind(0);
  picture.colors.bind(1);
  colors.bind(2);
  reference_.bind(3);
  map_.bind(4);
  block_rises_.bind(5);
  table_.bind(6);
  program.run(blocks);
}

void TileMetric::run_whole(const Program& program, const FrameImage& picture) {
  run(program, whole_, blocks_of_frame(picture.width, picture.height), picture, picture.colors);
}

void TileMetric::start(const FrameImage& picture) { run_whole(distances_, picture); }

void TileMetric::measure(const Atlas& atlas, const TilePainter& painter,
                         const FrameImage& picture) {
  block_rises_.reserve(std::size_t(atlas.metric_blocks) * sizeof(float));
  totals_.reserve(atlas.tiles.size() * sizeof(float));
  run(rises_, painter.tiles(), atlas.metric_blocks, picture, painter.colors());
  total_.use();
  total_.set("count", int(atlas.tiles.size()));
  painter.tiles().bind(0);
  block_rises_.bind(1);
  totals_.bind(2);
  total_.run(int(atlas.tiles.size()));
}

}  // namespace gradmesh
