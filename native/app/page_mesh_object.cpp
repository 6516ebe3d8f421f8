#include "app/page_mesh_object.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <numbers>

#include "base/error.h"
#include "form/handles.h"
#include "form/smooth_colors.h"
#include "formats/svg/values/mesh_outline.h"
#include "formats/text/number.h"
#include "mesh/boundary.h"
#include "mesh/build.h"
#include "metric/metric.h"
#include "raster/rasterizer.h"
#include "simplify/options.h"

namespace gradmesh {
namespace {

/// The largest FLIP at which a mesh looks as the page does for certain.
constexpr double same_look = 0.01;
/// How far, of 255, Illustrator's patches are from the smooth colours that they stand for, at most:
/// the picture of the page is no nearer to them than that. The share of the pixels for which it
/// must hold leaves out edges and seams.
constexpr int accuracy_of_pages = 4;
constexpr double most_pixels = 0.95;
/// The width in pixels of a line of width 0, which PDF shows as thin as can be seen, and SVG not at
/// all.
constexpr double thinnest_line = 1;

Mesh in_pixels(MeshParts parts) {
  transform(parts, Affine::scaling(glm::dvec2(pixels_per_point)));
  return build_mesh(parts);
}

/// What a page shows of a shading, to which meshes are compared.
class PageLook {
 public:
  explicit PageLook(const Mesh& page)
      : frame_(fit_frame(page, {}, usual_resolution)),
        rasterizer_(make_software_rasterizer()),
        metric_(make_metric(MetricKind::flip, rasterizer_->paint(page, frame_))) {}

  struct Difference {
    double flip;
    bool is_accurate;
  };
  Difference difference(const Mesh& mesh) const {
    const Image seen = rasterizer_->paint(mesh.is_smooth() ? painted_mesh(mesh) : mesh, frame_);
    return {mean(metric_->map(seen)), is_accurate(seen)};
  }

 private:
  /// Returns true if the picture is as near to the page's as that is to smooth colours.
  bool is_accurate(const Image& seen) const {
    const Image& page = metric_->reference();
    std::size_t painted = 0, near = 0;
    for (std::size_t pixel = 0; pixel < page.pixels(); ++pixel) {
      bool is_white = true, is_near = true;
      for (std::size_t n = 3 * pixel; n < 3 * pixel + 3; ++n) {
        is_white = is_white && page.samples[n] == 255 && seen.samples[n] == 255;
        is_near = is_near && std::abs(page.samples[n] - seen.samples[n]) <= accuracy_of_pages;
      }
      if (is_white) continue;
      ++painted;
      if (is_near) ++near;
    }
    return double(near) >= most_pixels * double(painted);
  }

  const Frame frame_;
  const std::unique_ptr<Rasterizer> rasterizer_;
  const std::unique_ptr<Metric> metric_;
};

/// Returns the handles of the first form with the patches of the page that fits together.
int handles_of_page(const std::vector<MeshForm>& forms) {
  for (const MeshForm& form : forms) try {
      if (form.kind == MeshForm::Kind::page) return count_handles(in_pixels(form.mesh));
    } catch (const InputError&) {
      continue;
    }
  return 0;
}

Box box_of(const PagePath& path) {
  Box box;
  for (const PagePath::Step& step : path.steps)
    for (const glm::dvec2 point : step.points) box.add(point);
  return box;
}

/// Returns a box that holds all that a stroke paints; of its curves it is the exact one, since
/// programs clip by boxes that are hardly larger.
Box box_of(const PageStroke& stroke) {
  const auto& [path, line] = stroke;
  Box curves;
  glm::dvec2 here(0.0);
  for (const auto& [kind, points] : path.steps) {
    if (kind == PagePath::Step::Kind::curve)
      curves.add_cubic(here, points[0], points[1], points[2]);
    else
      curves.add(points[2]);
    here = points[2];
  }
  const double corner = line.cap == LineCap::square ? std::numbers::sqrt2 : 1;
  const double reach = line.join == LineJoin::miter ? std::max(corner, line.miter_limit) : corner;
  const double margin = 0.5 * reach * std::max(line.width, thinnest_line / pixels_per_point);
  Box box;
  box.add(curves.low() - margin);
  box.add(curves.high() + margin);
  return box;
}

/// Returns true if the path is one rectangle along the axes.
bool is_box(const PagePath& path) {
  using Kind = PagePath::Step::Kind;
  std::vector<glm::dvec2> corners;
  for (const auto& [kind, points] : path.steps) {
    if (kind == Kind::curve || (kind == Kind::move && !corners.empty())) return false;
    if (kind != Kind::close && (corners.empty() || corners.back() != points[2]))
      corners.push_back(points[2]);
  }
  if (corners.size() == 5 && corners.back() == corners.front()) corners.pop_back();
  if (corners.size() != 4) return false;
  const bool starts_along_x = corners[0].y == corners[1].y;
  for (std::size_t k = 0; k < 4; ++k) {
    const glm::dvec2 side = corners[(k + 1) % 4] - corners[k];
    if (((k % 2 == 0) == starts_along_x ? side.y : side.x) != 0) return false;
  }
  return true;
}

/// Returns true if a clip path shows all that lies in the box, up to rounding.
bool shows_all(const PagePath& path, const Box& box) {
  constexpr double rounding = 0.01;
  if (!is_box(path)) return false;
  const Box seen = box_of(path);
  return seen.low().x <= box.low().x + rounding && seen.low().y <= box.low().y + rounding &&
         seen.high().x >= box.high().x - rounding && seen.high().y >= box.high().y - rounding;
}

std::string path_data(const PagePath& path) {
  const auto point = [](glm::dvec2 at) {
    return format_number(pixels_per_point * at.x) + "," + format_number(pixels_per_point * at.y);
  };
  std::string data;
  for (const auto& [kind, points] : path.steps) {
    if (!data.empty()) data += ' ';
    switch (kind) {
      case PagePath::Step::Kind::move:
        data += "M" + point(points[2]);
        break;
      case PagePath::Step::Kind::line:
        data += "L" + point(points[2]);
        break;
      case PagePath::Step::Kind::curve:
        data += "C" + point(points[0]) + " " + point(points[1]) + " " + point(points[2]);
        break;
      case PagePath::Step::Kind::close:
        data += "Z";
        break;
    }
  }
  return data;
}

}  // namespace

ChosenForm choose_form(const std::vector<PagePatch>& patches, std::vector<MeshForm> forms) {
  const MeshParts loose = loose_mesh(patches);
  const PageLook page(in_pixels(loose));
  // Without any joints the patches are a mesh as well, whatever they are.
  forms.push_back({loose});
  for (const MeshForm& form : forms) try {
      Mesh mesh = in_pixels(form.mesh);
      const auto [flip, is_accurate] = page.difference(mesh);
      // Smooth colours are what the patches of a page stand for, which are themselves, joined, what
      // the page shows.
      if (flip <= same_look || form.kind == MeshForm::Kind::page ||
          (form.mesh.smooth && form.kind != MeshForm::Kind::joined && is_accurate))
        return {form.kind, std::move(mesh), flip, handles_of_page(forms)};
    } catch (const InputError&) {
      // Patches that do not fit together as these joints say.
      if (&form == &forms.back()) throw;
    }
  throw InputError("it has no patches");
}

std::vector<SvgShape> shapes_of(const Mesh& mesh, const Clips& clips, const PageStroke* stroke) {
  Box box = bounding_box(mesh, Affine::scaling(glm::dvec2(1 / pixels_per_point)));
  if (stroke) {
    box = overlap(box, box_of(*stroke));
    if (box.empty()) return {};
  }
  std::vector<SvgShape> shapes;
  for (auto clip = clips.rbegin(); clip != clips.rend(); ++clip) {
    const Box seen = box_of(**clip);
    if (seen.empty() || !(seen.size().x > 0) || !(seen.size().y > 0) || overlap(seen, box).empty())
      return {};
    if (shows_all(**clip, box)) continue;
    SvgShape shape{path_data(**clip), (*clip)->rule};
    const bool is_there = std::ranges::any_of(
        shapes, [&](const SvgShape& s) { return s.path == shape.path && s.rule == shape.rule; });
    if (!is_there) shapes.push_back(std::move(shape));
  }
  if (stroke)
    shapes.insert(shapes.begin(), {path_data(stroke->path)});
  else if (shapes.empty())
    shapes.push_back({outline_path(mesh)});
  return shapes;
}

SvgStroke svg_stroke(const LineStyle& line) {
  static constexpr std::array<const char*, 3> caps{"butt", "round", "square"};
  static constexpr std::array<const char*, 3> joins{"miter", "round", "bevel"};
  SvgStroke stroke{.width = line.width > 0 ? pixels_per_point * line.width : thinnest_line,
                   .cap = caps[std::size_t(line.cap)],
                   .join = joins[std::size_t(line.join)],
                   .miter_limit = line.miter_limit,
                   .dash_offset = pixels_per_point * line.dash_phase};
  for (const double length : line.dashes) stroke.dashes.push_back(pixels_per_point * length);
  return stroke;
}

}  // namespace gradmesh
