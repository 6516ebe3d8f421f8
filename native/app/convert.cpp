#include "app/convert.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <stdexcept>

#include "app/hemesh_document.h"
#include "app/svg_meshes.h"
#include "app/svg_rules.h"
#include "form/smooth_colors.h"
#include "formats/hemesh/write_hemesh.h"
#include "formats/svg/write/mesh_outline.h"
#include "formats/svg/write/write_new.h"
#include "mesh/boundary.h"
#include "mesh/build.h"
#include "mesh/color_model.h"
#include "mesh/subdivide.h"
#include "simplify/adapt.h"

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

/// Returns the map between the coordinates of SVG and .hemesh under which the longer side of `box`
/// has `length` units and its middle lies at `middle`.
Affine fitted(const Box& box, double length, glm::dvec2 middle) {
  const double scale = length / std::max(box.size().x, box.size().y);
  const glm::dvec2 center = 0.5 * (box.low() + box.high());
  return Affine::translation(middle) * Affine::scaling(glm::dvec2(scale)) *
         Affine::translation(-center);
}

class Converter {
 public:
  Converter(const Document& from, const MeshEntry& entry, const ConvertOptions& options)
      : from_(from),
        entry_(entry),
        options_(options),
        read_(from.mesh(entry)),
        source_(read_.is_smooth() ? build_mesh(with_smooth_colors(read_)) : read_) {
    from.frame(entry, source_, options.resolution);  // Throws where the mesh has no size.
  }

  Conversion to_svg() {
    constexpr double length = 600, margin = 20;
    const Box box = bounding_box(source_, from_.view(entry_));
    const glm::dvec2 size = box.size() * (length / std::max(box.size().x, box.size().y));
    const SvgPage page{size.x + 2 * margin, size.y + 2 * margin};
    place_ = fitted(box, length, {page.width / 2, page.height / 2}) * from_.view(entry_);
    Conversion conversion = start(DocumentKind::svg);
    const Mesh mesh = bilinear_mesh(page, conversion);
    write_svg(page, mesh, conversion);
    if (options_.must_keep_epsilon && conversion.error > options_.epsilon)
      throw InputError(
          "{0}: in SVG its error is {1} at least, with {2} patches, which is above epsilon.",
          from_.name(), std::to_string(conversion.error), mesh.face_count());
    return conversion;
  }

  Conversion to_hemesh() {
    if (from_.kind() == DocumentKind::svg)
      place_ =
          fitted(bounding_box(source_, from_.view(entry_)), 2, glm::dvec2(0)) * from_.view(entry_);
    Conversion conversion = start(DocumentKind::hemesh);
    conversion.lost_opacity = is_translucent(source_);
    MeshParts patches = parts(options_.subdivide.value_or(1));
    if (patches.color_model == ColorModel::bilinear) patches = as_bicubic(std::move(patches));
    const Mesh mesh = build_mesh(patches);
    measure(conversion, std::make_unique<HemeshDocument>(write_hemesh(mesh), from_.name()));
    return conversion;
  }

 private:
  /// Returns the mesh subdivided, in the new coordinates.
  MeshParts parts(int subdivide) const { return parts(source_, subdivide); }
  MeshParts parts(const Mesh& mesh, int subdivide) const {
    MeshParts result = subdivided(mesh, subdivide);
    transform(result, place_);
    return result;
  }

  Conversion start(DocumentKind to) {
    Conversion conversion;
    conversion.original = build_derived_mesh(parts(options_.original   ? *options_.original
                                                   : read_.is_smooth() ? painted_mesh(read_)
                                                                       : read_,
                                                   1));
    frame_ = fit_frame(conversion.original, {}, options_.resolution,
                       to == from_.kind() ? from_.padding() : FramePadding{});
    metric_ = make_metric(options_.metric, rasterizer_->paint(conversion.original, frame_));
    return conversion;
  }

  /// Returns the mesh in the colour model `bilinear`, with patches as small as the options require.
  Mesh bilinear_mesh(const SvgPage& page, const Conversion& conversion) const {
    if (options_.subdivide) {
      MeshParts patches = as_bilinear(parts(*options_.subdivide));
      join_colors(patches);
      return build_mesh(patches);
    }
    const auto original = std::make_shared<const Mesh>(conversion.original);
    const auto error_of = [&](const Mesh& mesh) {
      Conversion trial;
      trial.original = *original;
      write_svg(page, mesh, trial);
      return trial.error;
    };
    return adapted(build_mesh(parts(1)),
                   {options_.epsilon, error_of, original, frame_, options_.metric})
        .mesh;
  }

  void write_svg(const SvgPage& page, const Mesh& mesh, Conversion& conversion) const {
    const std::string outline = outline_path(conversion.original);
    const std::string label = mesh_label(mesh.face_count()).in(from_.translation());
    const WrittenForm form = block_rules()->form(mesh, frame_);
    const SvgDocument svg = new_svg(page, outline, {mesh, *form.blocks, label, mesh.face_count()});
    measure(conversion, std::make_unique<SvgMeshes>(svg.serialize(), from_.name()));
  }

  /// Puts the document into the conversion and measures its error.
  void measure(Conversion& conversion, std::unique_ptr<Document> document) const {
    const Mesh mesh = document->mesh(document->meshes().front());
    conversion.error = mean(metric_->map(rasterizer_->paint(mesh, frame_)));
    conversion.document = std::move(document);
  }

  const Document& from_;
  const MeshEntry& entry_;
  const ConvertOptions& options_;
  const Mesh read_;
  /// The mesh with colours that both kinds of documents can hold.
  const Mesh source_;
  /// The map from the old mesh's coordinates to the new document's.
  Affine place_;
  /// How the error is measured.
  const std::unique_ptr<Rasterizer> rasterizer_ = make_software_rasterizer();
  Frame frame_;
  std::unique_ptr<Metric> metric_;
};

}  // namespace

Conversion convert(const Document& from, const MeshEntry& entry, DocumentKind to,
                   const ConvertOptions& options) {
  check(options);
  if (to == DocumentKind::hemesh) return Converter(from, entry, options).to_hemesh();
  if (from.kind() == DocumentKind::svg)
    throw InputError("{0} is an SVG document already.", from.name());
  return Converter(from, entry, options).to_svg();
}

}  // namespace gradmesh
