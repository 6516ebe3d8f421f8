#include "app/tiles_of_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/clamped_int.h"
#include "mesh/boundary.h"
#include "metric/metric.h"
#include "raster/picture.h"
#include "raster/seen_areas.h"

namespace gradmesh {
namespace {

/// The largest FLIP, in the mean of the pixels that the mesh covers, at which tiles show the same,
/// and at how many pixels it is measured: tiles are as fine as a page needs.
constexpr double same_look = 0.05;
constexpr int pixels_compared = 350;
/// The least share of the box around both that each of their boxes has.
constexpr double least_overlap = 0.8;
/// How many pictures are compared at most; what is left then stays beside its mesh.
constexpr int most_comparisons = 1000;

Box box_of(const std::vector<FlatArea>& tiles) {
  Box box;
  for (const FlatArea& tile : tiles)
    for (const std::vector<glm::dvec2>& polygon : tile.area.outline)
      for (const glm::dvec2 point : polygon) box.add(point);
  return box;
}

double area(const Box& box) { return box.empty() ? 0 : box.size().x * box.size().y; }

bool lie_together(const Box& a, const Box& b) {
  return area(overlap(a, b)) >= least_overlap * std::max(area(a), area(b));
}

using Level = std::array<std::uint8_t, 3>;

Level levels(const glm::dvec3& color) {
  Level all;
  for (int channel = 0; channel < 3; ++channel)
    all[std::size_t(channel)] = std::uint8_t(clamped_int(std::round(255 * color[channel]), 0, 255));
  return all;
}

/// The least and the largest levels of some pixels.
struct Range {
  Level least = {255, 255, 255}, most = {0, 0, 0};

  void add(const Level& color) {
    for (std::size_t c = 0; c < 3; ++c) {
      least[c] = std::min(least[c], color[c]);
      most[c] = std::max(most[c], color[c]);
    }
  }
  Level nearest(Level color) const {
    for (std::size_t c = 0; c < 3; ++c)
      if (least[c] <= most[c]) color[c] = std::clamp(color[c], least[c], most[c]);
    return color;
  }
};

/// Returns the colour nearest to each tile's that the mesh has where the tile is seen, its corners
/// included: they lie between its pixels and those beside them.
std::vector<Level> nearest(const MeshPicture& picture, const std::vector<int>& seen,
                           const std::vector<FlatArea>& tiles) {
  const int width = picture.covered.width, height = picture.covered.height;
  std::vector<Range> ranges(tiles.size());
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      if (!*picture.covered.at(x, y)) continue;
      const auto [red, green, blue, opacity] = picture.samples.pixel(x, y);
      for (int v = std::max(y - 1, 0); v <= std::min(y + 1, height - 1); ++v)
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, width - 1); ++u) {
          const int tile = seen[std::size_t(v) * std::size_t(width) + std::size_t(u)];
          if (tile >= 0) ranges[std::size_t(tile)].add({red, green, blue});
        }
    }
  std::vector<Level> all;
  for (std::size_t n = 0; n < tiles.size(); ++n)
    all.push_back(ranges[n].nearest(levels(tiles[n].color)));
  return all;
}

/// Returns the mean FLIP, over what a mesh covers, of tiles in its coordinates and of tiles whose
/// colours the mesh has where they are. The mesh itself is 0.2 and more away from Inkscape's tiles,
/// of any mesh: they are as large as its patches, and have the colour of one corner.
double difference(const Mesh& mesh, const std::vector<FlatArea>& tiles) {
  const Frame frame = fit_frame(mesh, {}, pixels_compared);
  // The opacities of a mesh are a mask of its tiles.
  const MeshPicture picture = picture_of(mesh, frame);
  const std::vector<int> seen = seen_areas(tiles, frame);
  const std::vector<Level> colors = nearest(picture, seen, tiles);
  Image like_mesh(frame.width, frame.height, frame.ground), flat = like_mesh;
  int covered = 0;
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x) {
      if (!*picture.covered.at(x, y)) continue;
      ++covered;
      const int tile = seen[std::size_t(y) * std::size_t(frame.width) + std::size_t(x)];
      const auto [red, green, blue, opacity] = picture.samples.pixel(x, y);
      like_mesh.set_pixel(x, y, tile < 0 ? Level{red, green, blue} : colors[std::size_t(tile)]);
      if (tile >= 0) flat.set_pixel(x, y, levels(tiles[std::size_t(tile)].color));
    }
  const Plane map = make_metric(MetricKind::flip, std::move(like_mesh))->map(flat);
  return covered > 0 ? mean(map) * double(map.pixels()) / covered : 1;
}

}  // namespace

std::vector<const FlatTiles*> tiles_of_meshes(const std::vector<PageObject>& objects,
                                              const std::vector<Affine>& places,
                                              const std::vector<FlatTiles>& groups) {
  std::vector<const FlatTiles*> found(objects.size(), nullptr);
  int comparisons = 0;
  std::vector<Box> boxes;
  for (const FlatTiles& group : groups) boxes.push_back(box_of(group.tiles));
  for (std::size_t n = 0; n < objects.size(); ++n) {
    const PageObject& object = objects[n];
    const Affine& place = places[object.page];
    if (object.stroke || place.determinant() == 0) continue;
    const Box box = bounding_box(object.mesh, place);
    double least = same_look;
    for (std::size_t k = 0; k < groups.size(); ++k) {
      // The import makes one tile of a patch, or several.
      if (groups[k].tiles.size() < std::size_t(object.patches) || !lie_together(box, boxes[k]) ||
          std::ranges::find(found, &groups[k]) != found.end() || ++comparisons > most_comparisons)
        continue;
      std::vector<FlatArea> tiles = groups[k].tiles;
      for (FlatArea& tile : tiles) tile.area = mapped(std::move(tile.area), place.inverse());
      const double apart = difference(object.mesh, tiles);
      if (apart > least) continue;
      least = apart;
      found[n] = &groups[k];
    }
  }
  return found;
}

}  // namespace gradmesh
