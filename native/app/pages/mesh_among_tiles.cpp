#include "app/pages/mesh_among_tiles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vector_relational.hpp>

#include "base/clamped_int.h"
#include "mesh/boundary.h"
#include "metric/metric.h"
#include "raster/seen_areas.h"

namespace gradmesh {
namespace {

/// At how many pixels pictures are compared: tiles are as fine as a page needs.
constexpr int pixels_compared = 350;

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

/// Calls `use` with the pixel at a place and those beside it, as far as they are in the frame.
void for_around(int x, int y, const Frame& frame, const auto& use) {
  for (int v = std::max(y - 1, 0); v <= std::min(y + 1, frame.height - 1); ++v)
    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, frame.width - 1); ++u) use(u, v);
}

/// Returns the index of the tile that is seen at a pixel; -1 if none is.
int tile_at(const std::vector<int>& seen, const Frame& frame, int x, int y) {
  return seen[std::size_t(y) * std::size_t(frame.width) + std::size_t(x)];
}

/// Returns the colour nearest to each tile's that the mesh has where the tile is seen, its corners
/// included: they lie between its pixels and those beside them.
std::vector<Level> nearest(const MeshImage& picture, const Frame& frame,
                           const std::vector<int>& seen, const std::vector<FlatArea>& tiles) {
  std::vector<Range> ranges(tiles.size());
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x) {
      if (!*picture.covered.at(x, y)) continue;
      const auto [red, green, blue, opacity] = picture.samples.pixel(x, y);
      const Level color{red, green, blue};
      for_around(x, y, frame, [&](int u, int v) {
        const int tile = tile_at(seen, frame, u, v);
        if (tile >= 0) ranges[std::size_t(tile)].add(color);
      });
    }
  std::vector<Level> all;
  for (std::size_t n = 0; n < tiles.size(); ++n)
    all.push_back(ranges[n].nearest(levels(tiles[n].color)));
  return all;
}

/// Returns true if tiles leave more of a mesh bare than what smoothed edges do.
bool leave_bare(const MeshImage& picture, const Frame& frame, const std::vector<int>& seen) {
  constexpr double most = 0.005;
  int covered = 0, bare = 0;
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x) {
      if (!*picture.covered.at(x, y)) continue;
      ++covered;
      bool is_inside = tile_at(seen, frame, x, y) < 0;
      for_around(x, y, frame, [&](int u, int v) { is_inside &= *picture.covered.at(u, v) != 0; });
      bare += is_inside;
    }
  return bare > most * covered;
}

bool is_near(const Level& a, const Level& b) {
  // What is more is seen, and what is less is rounding, or a space of colours converted in another
  // way.
  constexpr int most = 8;
  for (std::size_t c = 0; c < 3; ++c)
    if (std::abs(int(a[c]) - int(b[c])) > most) return false;
  return true;
}

/// Corners of tiles, to be found again.
class Corners {
 public:
  explicit Corners(double rounding) : rounding_(rounding) {}

  void add(const FlatArea& tile) {
    for (const std::vector<glm::dvec2>& polygon : tile.area.outline)
      corners_.insert(corners_.end(), polygon.begin(), polygon.end());
  }
  void sort() { std::ranges::sort(corners_, {}, &glm::dvec2::x); }

  /// Returns true if two corners of a tile are among these, which are sorted.
  bool join(const FlatArea& tile) const {
    int joined = 0;
    for (const std::vector<glm::dvec2>& polygon : tile.area.outline)
      for (const glm::dvec2 corner : polygon)
        if ((joined += has(corner)) == 2) return true;
    return false;
  }

 private:
  bool has(glm::dvec2 corner) const {
    auto near = std::ranges::lower_bound(corners_, corner.x - rounding_, {}, &glm::dvec2::x);
    for (; near != corners_.end() && near->x <= corner.x + rounding_; ++near)
      if (std::abs(near->y - corner.y) <= rounding_) return true;
    return false;
  }

  const double rounding_;
  std::vector<glm::dvec2> corners_;
};

}  // namespace

Box box_of(std::span<const FlatArea> tiles) {
  Box box;
  for (const FlatArea& tile : tiles)
    for (const std::vector<glm::dvec2>& polygon : tile.area.outline)
      for (const glm::dvec2 point : polygon) box.add(point);
  return box;
}

MeshAmongTiles::MeshAmongTiles(const Mesh& mesh, const Affine& place)
    : box_(bounding_box(mesh, place)),
      to_mesh_(place.inverse()),
      frame_(fit_frame(mesh, {}, pixels_compared)),
      picture_(picture_of(mesh, frame_)) {}

double MeshAmongTiles::difference_to(std::span<const FlatArea> tiles) const {
  std::vector<FlatArea> placed(tiles.begin(), tiles.end());
  for (FlatArea& tile : placed) tile.area = mapped(std::move(tile.area), to_mesh_);
  const std::vector<int> seen = seen_areas(placed, frame_);
  if (leave_bare(picture_, frame_, seen)) return 1;
  const std::vector<Level> colors = nearest(picture_, frame_, seen, placed);
  Image like_mesh(frame_.width, frame_.height, frame_.ground), flat = like_mesh;
  int covered = 0;
  for (int y = 0; y < frame_.height; ++y)
    for (int x = 0; x < frame_.width; ++x) {
      if (!*picture_.covered.at(x, y)) continue;
      ++covered;
      const int tile = tile_at(seen, frame_, x, y);
      const auto [red, green, blue, opacity] = picture_.samples.pixel(x, y);
      like_mesh.set_pixel(x, y, tile < 0 ? Level{red, green, blue} : colors[std::size_t(tile)]);
      if (tile >= 0) flat.set_pixel(x, y, levels(placed[std::size_t(tile)].color));
    }
  const Plane map = make_metric(MetricKind::flip, std::move(like_mesh))->map(flat);
  return covered > 0 ? mean(map) * double(map.pixels()) / covered : 1;
}

MeshAmongTiles::Part MeshAmongTiles::longest_part(std::span<const FlatArea> tiles,
                                                  const std::vector<bool>& taken) const {
  // So many of its own are worth one other between them.
  constexpr int worth_of_other = 3;
  std::vector<bool> is_own(tiles.size());
  Part longest, part;
  int gain = 0, most = 0;
  for (std::size_t n = 0; n < tiles.size(); ++n) {
    const bool may_be = !taken[n] && is_within(tiles[n]);
    is_own[n] = may_be && has_color_of(tiles[n]);
    gain += is_own[n] ? 1 : -worth_of_other;
    if (!may_be || gain < 0) {
      part.begin = n + 1;
      gain = 0;
    }
    part.end = n + 1;
    if (gain > most) {
      most = gain;
      longest = part;
    }
  }
  Corners own(2e-4 * std::max(box_.size().x, box_.size().y));
  for (std::size_t n = longest.begin; n < longest.end; ++n)
    if (is_own[n]) own.add(tiles[n]);
  own.sort();
  for (std::size_t n = longest.begin; n < longest.end; ++n)
    if (!is_own[n] && !own.join(tiles[n])) return {};
  // Its first ones and its last ones may have other colours, too.
  const auto may_be = [&](std::size_t n) {
    return !taken[n] && is_within(tiles[n]) && own.join(tiles[n]);
  };
  while (longest.begin > 0 && may_be(longest.begin - 1)) --longest.begin;
  while (longest.end < tiles.size() && may_be(longest.end)) ++longest.end;
  return longest;
}

bool MeshAmongTiles::is_within(const FlatArea& tile) const {
  const Box box = box_of(std::span(&tile, 1));
  // Of the box's size: what rounding may do, and what smoothed edges are covered by.
  const glm::dvec2 margin = 0.01 * box_.size();
  return glm::all(glm::greaterThanEqual(box.low(), box_.low() - margin)) &&
         glm::all(glm::lessThanEqual(box.high(), box_.high() + margin));
}

/// Returns true if the mesh has the colour of a tile at one of its corners.
bool MeshAmongTiles::has_color_of(const FlatArea& tile) const {
  const Affine to_pixels = frame_.to_pixels * to_mesh_;
  const Level color = levels(tile.color);
  const auto is_of_mesh = [&](glm::dvec2 corner) {
    const glm::dvec2 at = to_pixels.point(corner);
    Range range;
    for_around(clamped_int(std::floor(at.x), 0, frame_.width - 1),
               clamped_int(std::floor(at.y), 0, frame_.height - 1), frame_, [&](int u, int v) {
                 const auto [red, green, blue, opacity] = picture_.samples.pixel(u, v);
                 range.add({red, green, blue});
               });
    return is_near(range.nearest(color), color);
  };
  return std::ranges::any_of(tile.area.outline, [&](const std::vector<glm::dvec2>& polygon) {
    return std::ranges::any_of(polygon, is_of_mesh);
  });
}

}  // namespace gradmesh
