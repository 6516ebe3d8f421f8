#include "device/tile_painter.h"

#include <algorithm>

#include "egl_shaders.h"
#include "raster/hidden.h"
#include "raster/segments.h"

namespace gradmesh {
namespace {

/// Threads of a group, as in the shaders.
constexpr int block_side = 16, segments_of_group = 64;

int blocks_of(Window window) {
  return ((window.width() + block_side - 1) / block_side) *
         ((window.height() + block_side - 1) / block_side);
}

std::string segments_source() {
  return constant("MOST_LENGTH", most_length) + constant("MOST_KNOT_STEPS", most_knot_steps) +
         constant("MOST_POLISH_STEPS", most_polish_steps) + constant("START_CELLS", start_cells) +
         constant("KNOT_ERROR", knot_error) + constant("SLOPE_ERROR", slope_error) +
         constant("INTERPOLATION_ERROR", interpolation_error) +
         constant("FLATNESS", float(flatness)) + shaders::segments_glsl;
}

template <class T>
void append(const std::vector<T>& from, std::vector<T>& to) {
  to.insert(to.end(), from.begin(), from.end());
}

}  // namespace

std::string tiles_source() { return shaders::tiles_glsl; }

std::vector<std::uint32_t> packed(const Image& image) {
  const std::size_t count = image.pixels();
  std::vector<std::uint32_t> colors(count);
  const std::uint8_t *red = image.samples.data(), *green = red + count, *blue = green + count;
  for (std::size_t i = 0; i < count; ++i)
    colors[i] = red[i] | std::uint32_t(green[i]) << 8 | std::uint32_t(blue[i]) << 16;
  return colors;
}

void Atlas::clear() {
  tiles.clear();
  touched.clear();
  patches.clear();
  spans.clear();
  parameters.clear();
  pixels = segments = paint_blocks = metric_blocks = 0;
}

void Atlas::add(const EditTile& tile, Window measured) {
  if (measured.empty()) measured = {};
  const int index = int(tiles.size()), first_patch = int(patches.size()),
            first_touched = int(touched.size()), first_parameter = int(parameters.size() / 2);
  const int metric_end = metric_blocks + blocks_of(measured);
  append(tile.touched, touched);
  tiles.push_back({tile.window, measured, pixels, first_touched, int(touched.size()), paint_blocks,
                   metric_blocks, metric_end});
  append(tile.parameters, parameters);
  for (TilePatch patch : tile.patches) {
    patch.tile = index;
    patches.push_back(patch);
  }
  for (TileSpan span : tile.spans) {
    span.patch += first_patch;
    span.segments_before += segments;
    if (span.parameters >= 0) span.parameters += first_parameter;
    spans.push_back(span);
  }
  pixels += tile.window.width() * tile.window.height();
  segments += tile.segments;
  paint_blocks += blocks_of(tile.window);
  metric_blocks = metric_end;
}

void FrameImage::set(const Frame& frame, const Painting& painting) {
  set(painting.image);
  std::vector<std::uint32_t> numbers(painting.top.samples.size());
  std::ranges::transform(painting.top.samples, numbers.begin(), [](std::uint32_t sample) {
    return std::uint32_t(TopFace(sample).face().value + 1);
  });
  if (frame.hidden)
    for (int y = 0; y < height; ++y)
      for (const HiddenPixels::Run& run : frame.hidden->row(y))
        std::fill_n(numbers.begin() + std::size_t(y) * width + run.begin, run.end - run.begin,
                    hidden_number);
  tops.write(std::span<const std::uint32_t>(numbers));
}

void FrameImage::set(const Image& image) {
  width = image.width;
  height = image.height;
  colors.write(std::span<const std::uint32_t>(packed(image)));
}

TilePainter::TilePainter(const Device::Use& use)
    : clear_(use.program(shader_source({tiles_source(), shaders::clear_glsl}))),
      cover_(use.program(shader_source({tiles_source(), segments_source(), shaders::cover_glsl}))),
      shade_(use.program(shader_source({tiles_source(), segments_source(), shaders::shade_glsl}))) {
  std::vector<float> bases;
  for (const InterpolationBases* of_kind : {&hermite_bases, &linear_bases})
    for (const InterpolationBasis& of_length : *of_kind)
      for (const auto& weights : of_length)
        bases.insert(bases.end(), weights.begin(), weights.end());
  bases_.write(std::span<const float>(bases));
}

void TilePainter::paint(const Atlas& atlas, const FrameImage* picture) {
  tiles_.write(std::span(atlas.tiles));
  touched_.write(std::span(atlas.touched));
  patches_.write(std::span(atlas.patches));
  spans_.write(std::span(atlas.spans));
  parameters_.write(std::span(atlas.parameters));
  tops_.reserve(std::size_t(atlas.pixels) * sizeof(std::uint32_t));
  colors_.reserve(std::size_t(atlas.pixels) * sizeof(std::uint32_t));

  const auto start = [&](const Program& program, int count) {
    program.use();
    program.set("count", count);
    if (picture) program.set("frame_size", picture->width, picture->height);
    tiles_.bind(0);
  };
  start(clear_, atlas.paint_blocks);
  clear_.set("begins_white", picture == nullptr);
  (picture ? picture->colors : colors_).bind(1);
  (picture ? picture->tops : tops_).bind(2);
  touched_.bind(3);
  colors_.bind(4);
  tops_.bind(5);
  clear_.run(atlas.paint_blocks);

  const int groups = (atlas.segments + segments_of_group - 1) / segments_of_group;
  for (const Program* program : {&cover_, &shade_}) {
    start(*program, atlas.segments);
    patches_.bind(1);
    spans_.bind(2);
    parameters_.bind(3);
    tops_.bind(4);
    if (program == &shade_) {
      colors_.bind(5);
      bases_.bind(6);
    }
    program->run(groups);
  }
}

}  // namespace gradmesh
