#include "session/picture.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <stdexcept>

#include "base/clamped_int.h"
#include "base/limits.h"
#include "draw/heat_scale.h"
#include "form/smooth_colors.h"
#include "raster/hidden.h"
#include "raster/painting.h"
#include "reference/weights.h"
#include "session/canvas.h"
#include "session/overlay.h"

namespace gradmesh {
namespace {

using Ground = SessionView::Ground;

/// Inks that can be told apart on light and dark pictures, also without seeing red or green.
const Ink gone_ink{glm::dvec3(0.90, 0.35, 0.0), 1.0, 3.2},
    come_ink{glm::dvec3(0.0, 0.6, 1.0), 1.0, 2.4};
const Ink fixed_ink{glm::dvec3(0.1), 0.45, 1.4};
const Ink more_ink{glm::dvec3(0.0, 0.35, 0.85), 0.6, 1.2},
    less_ink{glm::dvec3(0.85, 0.45, 0.0), 0.6, 1.2};
const Ink mark_ink{glm::dvec3(0.34, 0.70, 0.91), 0.9, 2.0};

class PicturePainter {
 public:
  PicturePainter(const Session& session, const SessionView& view)
      : session_(session), view_(view), frame_{view.width, view.height, view.to_pixels} {}

  Image paint() {
    Image image = ground();
    veil_hidden(image);
    const Image original = of_original(image);
    const std::shared_ptr<const Analysis> known = what_is_known();
    if (known) Overlay::fade(image);
    Canvas canvas(image, view_.density);
    draw_hatched(canvas);
    draw_weights(canvas);
    if (known) draw_known(canvas, *known);
    if (view_.lines && !known) draw_lines(canvas, shown(), view_.to_pixels);
    if (view_.handles) draw_handles(canvas);
    if (view_.proposal && session_.hands().proposal())
      draw_proposal(canvas, *session_.hands().proposal());
    canvas.lines({view_.lasso}, below_lines);
    canvas.lines({view_.lasso}, come_ink);
    copy(original, original.window(), image);
    return image;
  }

 private:
  /// Returns where the line between original and result is.
  int split_pixel() const {
    return clamped_int(std::round(view_.split * view_.width), 0, view_.width);
  }
  /// Returns the part of the picture that shows the original, on which nothing is drawn; without
  /// pixels where the result is not beside it.
  Image of_original(const Image& image) const {
    Image part(Window{0, 0, view_.ground == Ground::halves ? split_pixel() : 0, view_.height});
    copy(image, part.window(), part);
    return part;
  }

  /// What of the mesh is not seen in the document is pale.
  void veil_hidden(Image& image) const {
    const std::optional<VisibleArea>& seen = session_.shown().problem().layout().visible;
    if (!seen) return;
    constexpr int share = 5;
    const HiddenPixels hidden(*seen, frame_);
    for (int y = 0; y < image.height; ++y)
      for (const HiddenPixels::Run run : hidden.row(y))
        for (int x = run.begin; x < run.end; ++x)
          for (int c = 0; c < 3; ++c) {
            std::uint8_t& sample = *image.at(x, y, c);
            sample = std::uint8_t(255 - (255 - sample) / share);
          }
  }

  Image painted(const Mesh& mesh) const { return paint_whole(mesh, frame_).image; }
  /// Returns the faces of the mesh as it is now that are seen at the pixels, as of Painting::top.
  Raster<std::uint32_t, 1> top_faces() const {
    const Mesh& mesh = session_.mesh();
    Raster<std::uint32_t, 1> top = paint_whole(mesh, frame_).top;
    if (!mesh.is_smooth()) return top;
    const std::vector<Face> faces = faces_of_painted_mesh(mesh);
    for (std::uint32_t& sample : top.samples)
      if (const Face part = TopFace(sample).face(); part.valid())
        sample = TopFace().with(faces[std::size_t(part.value)]).sample();
    return top;
  }
  const Mesh& shown() const {
    const Proposal* const proposal = view_.proposal ? session_.hands().proposal() : nullptr;
    return (proposal ? proposal->written : session_.shown().now()).surface();
  }

  Image ground() const {
    switch (view_.ground) {
      case Ground::result:
        return painted(shown());
      case Ground::original:
        return session_.shown().problem().original()->painted(frame_).image;
      case Ground::error:
        return error_map();
      case Ground::halves:
        break;
    }
    Image image = painted(shown());
    const int split = split_pixel();
    Painting left(Window{0, 0, split, view_.height});
    session_.shown().problem().original()->paint(frame_, left);
    copy(left.image, left.window(), image);
    Canvas(image, view_.density)
        .lines({{glm::dvec2(split, 0), glm::dvec2(split, view_.height)}},
               {glm::dvec3(0.5), 1.0, 1.5});
    return image;
  }

  /// Shows the metric's map, which has the pixels of the problem's frame.
  Image error_map() const {
    constexpr double most = 0.3;
    const Plane& map = session_.shown().now().measured->map();
    const Affine to_map = session_.shown().problem().frame().to_pixels * view_.to_pixels.inverse();
    Image image(view_.width, view_.height, 255);
    for (int y = 0; y < view_.height; ++y)
      for (int x = 0; x < view_.width; ++x) {
        const glm::dvec2 at = to_map.point({x + 0.5, y + 0.5});
        const int i = clamped_pixel(std::floor(at.x)), j = clamped_pixel(std::floor(at.y));
        if (i < 0 || j < 0 || i >= map.width || j >= map.height) continue;
        const glm::dvec3 color = heat_color(*map.at(i, j) / most);
        for (int c = 0; c < 3; ++c) *image.at(x, y, c) = std::uint8_t(std::lround(255 * color[c]));
      }
    return image;
  }

  std::vector<glm::dvec2> points(const Mesh& mesh, Halfedge curve) const {
    return points_along(mesh.curve_of(curve), view_.to_pixels);
  }

  void draw_handles(Canvas& canvas) const {
    constexpr double size = 6, straight = 0.3;
    const Mesh& mesh = shown();
    std::vector<glm::dvec2> corners, ends;
    std::vector<std::vector<glm::dvec2>> arms;
    for (const Halfedge side : mesh.curves()) {
      const Cubic<Value> c = mesh.curve_of(side);
      const auto at = [&](const Value& v) { return view_.to_pixels.point(v.position); };
      const glm::dvec2 from = at(c.p0), to = at(c.p1);
      corners.push_back(from);
      corners.push_back(to);
      const glm::dvec2 first = at(c.bezier1()), second = at(c.bezier2());
      if (glm::length(first - glm::mix(from, to, 1.0 / 3)) < straight &&
          glm::length(second - glm::mix(from, to, 2.0 / 3)) < straight)
        continue;
      arms.push_back({from, first});
      arms.push_back({to, second});
      ends.push_back(first);
      ends.push_back(second);
    }
    canvas.lines(arms, {glm::dvec3(0.1, 0.3, 0.8), 0.8, 1.0});
    canvas.squares(ends, size - 2, {glm::dvec3(0.1, 0.3, 0.8), 1.0}, glm::dvec3(1.0));
    canvas.squares(corners, size, {glm::dvec3(1.0), 1.0}, glm::dvec3(0.1, 0.1, 0.1));
  }

  void draw_proposal(Canvas& canvas, const Proposal& proposal) const {
    std::vector<std::vector<glm::dvec2>> gone, come;
    for (const Halfedge curve : proposal.made.gone) gone.push_back(points(session_.mesh(), curve));
    for (const Halfedge curve : proposal.made.come)
      come.push_back(points(proposal.made.mesh, curve));
    canvas.lines(come, come_ink);
    canvas.lines(gone, gone_ink);
  }

  /// Returns what is known and is to be shown; null as long as there is nothing of it to be seen.
  std::shared_ptr<const Analysis> what_is_known() const {
    if (!view_.analysis) return nullptr;
    if (*view_.analysis == AnalysisKind::regions && !view_.patch.valid()) return nullptr;
    const std::shared_ptr<const Analysis> known = session_.shown().analysis(*view_.analysis);
    return known && !known->failure ? known : nullptr;
  }

  void draw_known(Canvas& canvas, const Analysis& known) const {
    const Mesh& mesh = session_.mesh();
    const Raster<std::uint32_t, 1> top = top_faces();
    Overlay overlay(canvas, mesh, view_.to_pixels, top);
    switch (*view_.analysis) {
      case AnalysisKind::prices:
        return overlay.draw_prices(known.prices);
      case AnalysisKind::parts:
        return overlay.draw_parts(known.parts);
      case AnalysisKind::regions:
        break;
    }
    const std::vector<RegionPrice> regions = largest_regions(known, view_.patch);
    const bool is_there = view_.region >= 0 && std::size_t(view_.region) < regions.size();
    overlay.draw_region(view_.patch, is_there ? &regions[std::size_t(view_.region)] : nullptr);
  }

  void draw_hatched(Canvas& canvas) const {
    const std::vector<Face> fixed = session_.shown().protected_faces();
    if (fixed.empty() && view_.marked.empty()) return;
    const Raster<std::uint32_t, 1> top = top_faces();
    hatch(canvas, top, fixed, fixed_ink, 10);
    hatch(canvas, top, view_.marked, mark_ink, 8);
  }

  void draw_weights(Canvas& canvas) const {
    const auto weights = weights_in(frame_, session_.shown().problem().layout().weighted);
    if (!weights) return;
    canvas.hatch(14, more_ink, [&](int x, int y) { return *weights->at(x, y) > 1; });
    canvas.hatch(14, less_ink, [&](int x, int y) { return *weights->at(x, y) < 1; });
  }

  void hatch(Canvas& canvas, const Raster<std::uint32_t, 1>& top, const std::vector<Face>& faces,
             const Ink& ink, double distance) const {
    std::vector<char> is_one(session_.mesh().face_slots(), false);
    for (const Face face : faces)
      if (std::size_t(face.value) < is_one.size()) is_one[std::size_t(face.value)] = true;
    canvas.hatch(distance, ink, [&](int x, int y) {
      const Face face = TopFace(*top.at(x, y)).face();
      return face.valid() && is_one[std::size_t(face.value)];
    });
  }

  const Session& session_;
  const SessionView& view_;
  const Frame frame_;
};

}  // namespace

glm::dvec3 color_at(const Session& session, const SessionView& view, glm::dvec2 pixel) {
  const Frame frame{1, 1, Affine::translation(-glm::floor(pixel)) * view.to_pixels};
  const bool is_original = view.ground == Ground::original ||
                           (view.ground == Ground::halves && pixel.x < view.split * view.width);
  const Image image = is_original ? session.shown().problem().original()->painted(frame).image
                                  : paint_whole(session.shown().now().surface(), frame).image;
  const auto [red, green, blue] = image.pixel(0, 0);
  return glm::dvec3(red, green, blue) / 255.0;
}

SessionView::Ground ground_named(const std::string& name) {
  if (name == "result") return Ground::result;
  if (name == "original") return Ground::original;
  if (name == "halves") return Ground::halves;
  if (name == "error") return Ground::error;
  throw std::invalid_argument("grounds are result, original, halves and error, not '" + name +
                              "'.");
}

Image paint(const Session& session, const SessionView& view) {
  constexpr int most = 16384;
  if (view.width < 1 || view.height < 1 || view.width > most || view.height > most)
    throw std::invalid_argument("a picture has 1 to 16384 pixels a side.");
  return PicturePainter(session, view).paint();
}

}  // namespace gradmesh
