#include "app/export/publish.h"

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <stdexcept>
#include <utility>
#include <variant>

#include "app/document/svg_document.h"
#include "app/export/smallest_picture.h"
#include "base/clamped_int.h"
#include "base/limits.h"
#include "files/image_file.h"
#include "form/linear_colors.h"
#include "formats/svg/values/mesh_outline.h"
#include "formats/svg/values/path.h"
#include "mesh/boundary.h"
#include "raster/hidden.h"
#include "raster/picture.h"

namespace gradmesh {
namespace {

/// Pictures of a document that have no more pixels together, some 100 kB, are small as they are.
constexpr std::int64_t few_pixels = 360 * 360;

/// Returns the box around the outlines of a set, which are in mesh units, as `view` shows them.
Box box_of(const std::vector<FilledOutline>& set, const Affine& view) {
  Box box;
  for (const FilledOutline& filled : set)
    for (const std::vector<glm::dvec2>& polygon : filled.outline)
      for (const glm::dvec2 p : polygon) box.add(view.point(p));
  return box;
}

Box common(const Box& a, const Box& b) {
  Box box;
  const glm::dvec2 low = glm::max(a.low(), b.low()), high = glm::min(a.high(), b.high());
  if (b.empty() || low.x > high.x || low.y > high.y) return box;
  box.add(low);
  box.add(high);
  return box;
}

/// Makes the picture of one mesh.
class MeshPublisher {
 public:
  MeshPublisher(const SvgDocument& document, const MeshEntry& entry, double scale)
      : mesh_(document.mesh(entry)), place_(document.place(entry)) {
    report_.id = entry.id;
    choose_frame(scale);
  }

  /// Returns the number of pixels of the mesh's picture at the chosen scale.
  std::int64_t pixels() const { return std::int64_t(frame_.width) * frame_.height; }

  /// Returns what shows the mesh. A picture has no more pixels than it needs if `saves`.
  SvgDocument::Look look(bool saves) {
    MeshImage picture = picture_of(mesh_, frame_);
    const bool is_cut = !shape_lies_inside(picture);
    if (place_.fills_shape && !is_cut) {
      if (auto colors = linear_colors(mesh_, coons_tolerance(frame_))) {
        report_.as = colors->stops.size() == 1 ? PublishedAs::color : PublishedAs::linear_gradient;
        colors->start = place_.to_user.point(colors->start);
        colors->end = place_.to_user.point(colors->end);
        return *std::move(colors);
      }
    }
    const std::string outline = is_cut ? outline_around(picture) : "";
    // Where no path will do the picture ends by itself, in whole pixels.
    const bool ends_itself = is_cut && outline.empty();
    if (ends_itself) clear_uncovered(picture);
    AnyImage shown = any_image(std::move(picture.samples), !is_translucent(mesh_) && !ends_itself);
    if (saves) shown = smallest_picture(std::move(shown), seen_of(picture));
    PlacedPng placed;
    placed.place = box_;
    std::visit(
        [&](const auto& image) {
          report_.width = image.width;
          report_.height = image.height;
          placed.png = png_bytes(image);
        },
        shown);
    if (!outline.empty()) {
      placed.outline = outline;
      placed.outline_to_user = place_.to_user;
    }
    report_.bytes = placed.png.size();
    return placed;
  }

  const PublishedMesh& report() const { return report_; }

 private:
  /// Lays the frame around what is seen of the mesh.
  void choose_frame(double scale) {
    Box seen = bounding_box(mesh_, place_.to_user);
    if (place_.seen)
      for (const auto& set : place_.seen->sets) seen = common(seen, box_of(set, place_.to_user));
    if (place_.reach) seen = common(seen, *place_.reach);
    shows_nothing_ = seen.empty();
    if (shows_nothing_) seen.add(place_.to_user.point(mesh_.position(*mesh_.points().begin())));

    const Affine grid = document_pixels();
    // What lies around blurs into what is seen where a picture is enlarged.
    const glm::dvec2 margin(std::max(1.0, std::ceil(2 / scale)));
    const glm::dvec2 low = glm::floor(grid.point(seen.low())) - margin;
    const glm::dvec2 size = glm::ceil(grid.point(seen.high())) + margin - low;
    scale = std::min(scale, double(limits().resolution) / std::max(size.x, size.y));
    frame_.width = clamped_int(size.x * scale, 1, INT_MAX);
    frame_.height = clamped_int(size.y * scale, 1, INT_MAX);
    frame_.to_pixels =
        Affine::scaling(glm::dvec2(scale)) * Affine::translation(-low) * grid * place_.to_user;
    box_.add(grid.inverse().point(low));
    box_.add(grid.inverse().point(low + glm::dvec2(frame_.width, frame_.height) / scale));
  }

  /// Returns the map from the object's user space to pixels that have the size of the document's,
  /// and lie along the axes of the object's user space. If the document's do so as well these are
  /// the same, so that in its own size the document shows pixels of the picture as they are, or
  /// whole ones together.
  Affine document_pixels() const {
    const auto& [linear, offset] = place_.to_page;
    const bool is_straight = linear[0].y == 0 && linear[1].x == 0;
    glm::dvec2 unit(glm::length(linear[0]), glm::length(linear[1]));
    // A transform may leave no width, or no height.
    unit = glm::max(unit, 1e-3 * std::max(unit.x, unit.y));
    const glm::dvec2 turned(linear[0].x < 0 ? -1 : 1, linear[1].y < 0 ? -1 : 1);
    return {glm::dmat2(unit.x, 0, 0, unit.y), is_straight ? turned * offset : glm::dvec2(0.0)};
  }

  /// Returns true if all that is seen is within a pixel of what the mesh covers.
  bool shape_lies_inside(const MeshImage& picture) const {
    if (!place_.seen || shows_nothing_) return false;
    const HiddenPixels hidden(*place_.seen, frame_);
    const auto is_near_mesh = [&](int x, int y) {
      for (int near_y = std::max(0, y - 1); near_y < std::min(frame_.height, y + 2); ++near_y)
        for (int near_x = std::max(0, x - 1); near_x < std::min(frame_.width, x + 2); ++near_x)
          if (*picture.covered.at(near_x, near_y)) return true;
      return false;
    };
    for (int y = 0; y < frame_.height; ++y)
      for (int x = 0; x < frame_.width; ++x)
        if (!*picture.covered.at(x, y) && !hidden.contains(x, y) && !is_near_mesh(x, y))
          return false;
    return true;
  }

  /// Returns a path around all that the mesh paints: its outline or, for a folded mesh, which
  /// paints beyond that, those of all patches. Empty where even these do not hold it.
  std::string outline_around(const MeshImage& picture) const {
    const std::string outline = outline_path(mesh_);
    if (!paints_beyond(outline, picture)) return outline;
    const std::string patches = patches_path(mesh_);
    return paints_beyond(patches, picture) ? "" : patches;
  }

  /// Returns true if the mesh covers pixels that are more than a pixel beyond a path.
  bool paints_beyond(const std::string& path, const MeshImage& picture) const {
    const auto outline = path_outline(path);
    if (!outline) return true;
    const std::vector<FilledOutline> area{{*outline}};
    return covers_beyond(picture, area, frame_);
  }

  /// Makes the picture end where the mesh does.
  static void clear_uncovered(MeshImage& picture) {
    const std::size_t opacities = 3 * picture.samples.pixels();
    for (std::size_t i = 0; i < picture.samples.pixels(); ++i)
      if (!picture.covered.samples[i]) picture.samples.samples[opacities + i] = 0;
  }

  /// Returns 1 for the pixels in which the mesh is seen.
  Raster<std::uint8_t, 1> seen_of(const MeshImage& picture) const {
    Raster<std::uint8_t, 1> seen = picture.covered;
    if (place_.seen && !shows_nothing_) {
      const HiddenPixels hidden(*place_.seen, frame_);
      for (int y = 0; y < seen.height; ++y)
        for (const auto& [begin, end] : hidden.row(y))
          std::fill(seen.at(begin, y), seen.at(end, y), 0);
    }
    return seen;
  }

  const Mesh& mesh_;
  const SvgDocument::Place place_;
  Frame frame_;
  /// True if nothing of the mesh is seen, so that the frame shows some corner of it.
  bool shows_nothing_ = false;
  /// The frame in the object's user space.
  Box box_;
  PublishedMesh report_;
};

}  // namespace

const char* name(PublishedAs as) {
  static constexpr std::array<const char*, 4> names{"picture", "linear gradient", "colour",
                                                    "nothing"};
  return names[std::size_t(as)];
}

std::vector<PublishedMesh> publish(Document& document, const PublishOptions& options) {
  constexpr double largest = 16;
  if (!(options.scale > 0 && options.scale <= largest))
    throw std::invalid_argument("the scale must be above 0, and at most 16.");
  SvgDocument& meshes = as_svg(
      document,
      Message("{0}: only SVG documents are published; gradmesh convert makes one of this file.",
              document.name()));
  std::vector<std::pair<MeshEntry, MeshPublisher>> publishers;
  std::int64_t pixels = 0;
  for (const MeshEntry& entry : meshes.selected({}))
    document.naming(entry, [&] {
      publishers.emplace_back(entry, MeshPublisher(meshes, entry, options.scale));
      pixels += publishers.back().second.pixels();
    });
  std::vector<PublishedMesh> reports;
  std::vector<std::pair<MeshEntry, SvgDocument::Look>> looks;
  for (auto& published : publishers)
    document.naming(published.first, [&] {
      looks.emplace_back(published.first, published.second.look(pixels > few_pixels));
      reports.push_back(published.second.report());
    });
  for (const MeshEntry& entry : meshes.refused({}))
    reports.push_back({.id = entry.id, .as = PublishedAs::nothing, .refused = entry.refused});
  meshes.replace_by(looks);
  return reports;
}

}  // namespace gradmesh
