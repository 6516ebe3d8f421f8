#include "app/runs/convert.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <stdexcept>

#include "app/document/frames.h"
#include "app/document/originals.h"
#include "form/smooth_colors.h"
#include "mesh/boundary.h"
#include "mesh/build.h"
#include "mesh/color_model.h"
#include "mesh/subdivide.h"
#include "simplify/adapt.h"
#include "simplify/options.h"

namespace gradmesh {
namespace {

void check(const ConvertOptions& options) {
  if (options.subdivide && (*options.subdivide < 1 || *options.subdivide > 32))
    throw std::invalid_argument("patches can be subdivided into 1 to 32 each way.");
  if (!(options.epsilon >= 0 && options.epsilon <= 1))
    throw std::invalid_argument("epsilon must be between 0 and 1.");
  if (options.subdivide && options.must_keep_epsilon)
    throw std::invalid_argument(
        "patches are split into as many or until epsilon is kept, not both.");
  check_resolution(options.resolution);
}

/// Gives corners that meet the same colour where their colours differ by rounding only: blocks
/// would end there as at a step in colour.
void join_colors(MeshParts& parts) {
  constexpr double rounding = 0.1 / 255;
  constexpr int row[] = {0, 0, 3, 3}, column[] = {0, 3, 3, 0};
  const Mesh mesh = build_mesh(parts);
  std::map<Point, glm::dvec4> colors;
  for (const Face f : mesh.faces()) {
    Patch& patch = parts.patches[f.value];
    for (int k = 0; k < 4; ++k) {
      glm::dvec4& color = patch.c[row[k]][column[k]].color;
      const auto [first, added] = colors.emplace(mesh.origin(mesh.sides(f)[k]), color);
      if (glm::distance(first->second, color) < rounding) color = first->second;
    }
    make_color_bilinear(patch);
  }
}

/// Returns the map between the coordinates of two formats under which the longer side of `box`
/// has `length` units and its middle lies at `middle`.
Affine fitted(const Box& box, double length, glm::dvec2 middle) {
  const double scale = length / std::max(box.size().x, box.size().y);
  const glm::dvec2 center = 0.5 * (box.low() + box.high());
  return Affine::translation(middle) * Affine::scaling(glm::dvec2(scale)) *
         Affine::translation(-center);
}

class Converter {
 public:
  Converter(const Document& from, const MeshEntry& entry, const Format& to,
            const ConvertOptions& options)
      : from_(from),
        entry_(entry),
        to_(to),
        options_(options),
        read_(from.mesh(entry)),
        source_(read_.is_smooth() ? build_mesh(with_smooth_colors(read_)) : read_) {
    frame_of(from, entry, source_, options.resolution);  // Throws where the mesh has no size.
  }

  Conversion run() {
    if (to_ != from_.format()) place();
    Conversion conversion = start();
    conversion.lost_opacity = !to_.holds_opacity && is_translucent(source_);
    const bool is_exact = to_.holds(ColorModel::bicubic);
    const Problem problem = this->problem(conversion);
    const Candidate made = is_exact ? problem.measure(exact_mesh()) : bilinear(problem);
    const Mesh& mesh = made.mesh;
    conversion.error = made.error;
    conversion.document = to_.read(
        to_.write({mesh, conversion.original, problem.frame(), page_, from_.translation()}),
        from_.name());
    if (!is_exact && options_.must_keep_epsilon && conversion.error > options_.epsilon)
      throw InputError(
          "{0}: in {1} its error is {2} at least, with {3} patches, which is above epsilon.",
          from_.name(), to_.label, std::to_string(conversion.error), mesh.face_count());
    return conversion;
  }

 private:
  /// Places the mesh as documents of the new format have it.
  void place() {
    const Box box = bounding_box(source_, from_.view(entry_));
    const glm::dvec2 size = box.size() * (to_.length / std::max(box.size().x, box.size().y));
    if (to_.margin) page_ = size + 2 * *to_.margin;
    place_ = fitted(box, to_.length, 0.5 * page_) * from_.view(entry_);
  }

  /// Returns the mesh subdivided, in the new coordinates.
  MeshParts parts(int subdivide) const { return parts(source_, subdivide); }
  MeshParts parts(const Mesh& mesh, int subdivide) const {
    MeshParts result = subdivided(mesh, subdivide);
    transform(result, place_);
    return result;
  }

  Conversion start() {
    Conversion conversion;
    conversion.original = build_derived_mesh(parts(options_.original   ? *options_.original
                                                   : read_.is_smooth() ? painted_mesh(read_)
                                                                       : read_,
                                                   1));
    return conversion;
  }

  /// Returns the problem to write the mesh, in the new coordinates, as the new format does.
  Problem problem(const Conversion& conversion) const {
    const auto mesh = std::make_shared<const Mesh>(build_mesh(parts(1)));
    const Layout layout{{}, to_ == from_.format() ? from_.padding() : FramePadding{}};
    Problem result(mesh, original_of(std::make_shared<const Mesh>(conversion.original)), layout,
                   options_.resolution, options_.metric);
    result.bounds.epsilon = options_.epsilon;
    result.rules = to_.rules(from_.name());
    return result;
  }

  /// Returns the mesh in the colour model of the new format, with the same picture.
  Mesh exact_mesh() const {
    MeshParts patches = parts(options_.subdivide.value_or(1));
    const bool becomes_bicubic = to_.color_models.front() == ColorModel::bicubic;
    if (becomes_bicubic && patches.color_model == ColorModel::bilinear)
      patches = as_bicubic(std::move(patches));
    return build_mesh(patches);
  }

  /// Returns the mesh in the colour model `bilinear`, with patches as small as the options require.
  Candidate bilinear(const Problem& problem) const {
    if (!options_.subdivide) return adapted(problem);
    MeshParts patches = as_bilinear(parts(*options_.subdivide));
    join_colors(patches);
    return problem.measure(build_mesh(patches));
  }

  const Document& from_;
  const MeshEntry& entry_;
  const Format& to_;
  const ConvertOptions& options_;
  const Mesh read_;
  /// The mesh with colours that do not follow those of the neighbours.
  const Mesh source_;
  /// The map from the old mesh's coordinates to the new document's, and the size of its page.
  Affine place_;
  glm::dvec2 page_{0.0};
};

/// The share of epsilon up to which patches are split; what is left is for merging.
constexpr double for_splitting = 0.9;

}  // namespace

Conversion convert(const Document& from, const MeshEntry& entry, const Format& to,
                   const ConvertOptions& options) {
  check(options);
  from.check_conversion(to);
  return Converter(from, entry, to, options).run();
}

ConvertedRun convert_for_run(const Document& from, const MeshEntry& entry, const Format& to,
                             RunOptions options) {
  ConvertOptions how;
  how.original = given_original(from, entry);
  how.metric = options.metric;
  how.resolution = options.resolution;
  if (!options.has_target()) how.epsilon = for_splitting * options.epsilon;
  Conversion conversion = convert(from, entry, to, how);
  if (conversion.lost_opacity)
    throw InputError(
        "{0}: the mesh {1} has opacities, which {2} cannot hold; gradmesh convert shows what is "
        "lost.",
        from.name(), entry.id, to.label);
  if (!to.holds(ColorModel::bicubic) && !options.has_target() && conversion.error > options.epsilon)
    throw InputError("{0}: written as {1} its error is {2} at least, above epsilon.", from.name(),
                     to.label, std::to_string(conversion.error));
  conversion.document->set_translation(from.translation());
  options.original = original_of(std::make_shared<const Mesh>(std::move(conversion.original)));
  if (!options.color_model) options.color_model = ColorModel::bilinear;
  return {std::move(conversion.document), std::move(options)};
}

}  // namespace gradmesh
