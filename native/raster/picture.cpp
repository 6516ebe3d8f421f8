#include "raster/picture.h"

#include <algorithm>
#include <deque>
#include <memory>

#include "form/smooth_colors.h"
#include "mesh/build.h"
#include "mesh/subdivide.h"
#include "raster/hidden.h"
#include "raster/painting.h"
#include "raster/rasterizer.h"

namespace gradmesh {
namespace {

/// Returns the mesh opaque, with its colours or, in their place, with its opacities as greys.
Mesh opaque(const Mesh& mesh, bool shows_opacities) {
  MeshParts parts = subdivided(mesh, 1);
  for (Patch& patch : parts.patches)
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) {
        const bool is_corner = i % 3 == 0 && j % 3 == 0;
        glm::dvec4& color = patch.c[i][j].color;
        const glm::dvec3 shown = shows_opacities ? glm::dvec3(color.a) : glm::dvec3(color);
        color = glm::dvec4(shown, is_corner ? 1 : 0);
      }
  return build_derived_mesh(parts);
}

/// Gives all pixels that are not covered the samples of a nearest one that is, counted in steps to
/// the side, up and down.
void spread(MeshImage& picture) {
  RgbaImage& samples = picture.samples;
  Raster<std::uint8_t, 1> known = picture.covered;
  struct Pixel {
    int x, y;
  };
  std::deque<Pixel> border;
  for (int y = 0; y < samples.height; ++y)
    for (int x = 0; x < samples.width; ++x)
      if (*known.at(x, y)) border.push_back({x, y});
  for (; !border.empty(); border.pop_front()) {
    const auto [x, y] = border.front();
    for (const auto& [next_x, next_y] :
         {Pixel{x - 1, y}, Pixel{x + 1, y}, Pixel{x, y - 1}, Pixel{x, y + 1}}) {
      const bool is_inside =
          next_x >= 0 && next_y >= 0 && next_x < samples.width && next_y < samples.height;
      if (!is_inside || *known.at(next_x, next_y)) continue;
      *known.at(next_x, next_y) = 1;
      samples.set_pixel(next_x, next_y, samples.pixel(x, y));
      border.push_back({next_x, next_y});
    }
  }
}

}  // namespace

MeshImage picture_of(const Mesh& mesh, Frame frame) {
  frame.hidden = nullptr;
  const Mesh painted = mesh.is_smooth() ? painted_mesh(mesh) : mesh;
  const std::unique_ptr<Rasterizer> inkscape = make_cairo_like_rasterizer();
  MeshImage picture{RgbaImage(frame.width, frame.height, 255),
                    Raster<std::uint8_t, 1>(frame.width, frame.height)};
  std::ranges::copy(inkscape->paint(opaque(painted, false), frame).samples,
                    picture.samples.samples.begin());
  if (is_translucent(painted)) {
    const Image opacity = inkscape->paint(opaque(painted, true), frame);
    std::copy_n(opacity.samples.begin(), opacity.pixels(), picture.samples.at(0, 0, 3));
  }
  std::ranges::transform(
      paint_whole(painted, frame).top.samples, picture.covered.samples.begin(),
      [](std::uint32_t sample) { return std::uint8_t(TopFace(sample).face().valid()); });
  spread(picture);
  return picture;
}

bool covers_beyond(const MeshImage& picture, const std::vector<FilledOutline>& set,
                   const Frame& frame) {
  const HiddenPixels beyond(VisibleArea{{set}}, frame);
  const auto is_beyond = [&](int x, int y) {
    for (int near_y = std::max(0, y - 1); near_y < std::min(frame.height, y + 2); ++near_y)
      for (int near_x = std::max(0, x - 1); near_x < std::min(frame.width, x + 2); ++near_x)
        if (!beyond.contains(near_x, near_y)) return false;
    return true;
  };
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x)
      if (*picture.covered.at(x, y) && is_beyond(x, y)) return true;
  return false;
}

}  // namespace gradmesh
