#include "formats/svg/write/write_blocks.h"

#include <algorithm>
#include <utility>

#include "form/block_outline.h"
#include "formats/svg/read/read_group.h"
#include "formats/svg/xml/edit.h"
#include "formats/text/number.h"
#include "mesh/boundary.h"

namespace gradmesh {
namespace {

/// Returns the polygon with coordinates in the step; one of 0 stands for digits that suffice.
std::string path_data(const std::vector<glm::dvec2>& polygon, double step, int digits) {
  const auto number = [&](double x) {
    return step > 0 ? format_multiple(x, step) : format_number(x, digits);
  };
  std::string d;
  for (const glm::dvec2 p : polygon)
    d.append(d.empty() ? "M" : " ").append(number(p.x)).append(",").append(number(p.y));
  return d + "Z";
}

}  // namespace

BlocksWriter::BlocksWriter(SvgDocument& document, xmlNode* defs, const WrittenMesh& written,
                           std::string id, std::string fallback)
    : document_(document),
      defs_(defs),
      written_(written),
      id_(std::move(id)),
      fallback_(std::move(fallback)) {}

Box BlocksWriter::write(xmlNode* parent, xmlNode* before, MeshChannel channel,
                        const BlockIds& ids) const {
  const bool color = channel != MeshChannel::opacity;
  // A tenth of what an outline is grown by, which need not be exact.
  const double margin = seam_margin(), step = decimal_step(0.1 * margin);
  const Box mesh_box = bounding_box(written_.mesh, {});
  const GradientFormat format{.coons_tolerance = written_.form.coons_tolerance,
                              .channel = channel,
                              .in_style = !document_.styles().is_empty(),
                              .step = written_.form.step,
                              .rounding = rounding_within(mesh_box)};
  Box box;
  int face = 0;
  for (const Rectangle& block : written_.form.blocks) {
    const auto [path_id, gradient_id] = ids_of(block, ids);
    std::string gradient = write_block_gradient(document_, defs_, written_.mesh, block, format,
                                                id_ + (color ? "-mesh" : "-opacity"));
    const auto is_free = [&](const std::string& id) { return !id.empty() && !document_.find(id); };
    if (is_free(gradient_id)) {
      document_.set_id(document_.find(gradient), gradient_id);
      gradient = gradient_id;
    }
    xmlNode* path = add_child(parent, "path");
    if (before) xmlAddPrevSibling(before, path);
    if (is_free(path_id))
      document_.set_id(path, path_id);
    else
      document_.give_id(path, id_ + (color ? "-block" : "-opacity-block"));
    const std::vector<glm::dvec2> outline = grown_outline(written_.mesh, block, margin);
    for (const glm::dvec2 p : outline) box.add(p);
    set_attribute(path, "d", path_data(outline, step, digits_within(mesh_box, outline_digits)));
    set_attribute(path, "style", style(gradient, channel));
    set_attribute(path, "face", std::to_string(face), gradmesh_namespace, "gradmesh");
    face += int(block.tops.size());
  }
  return box;
}

std::pair<std::string, std::string> BlocksWriter::ids_of(const Rectangle& block,
                                                         const BlockIds& ids) const {
  if (ids.empty()) return {};
  int first = written_.mesh.face(block.tops.front()).value, last = first;
  for (const Halfedge top : block.tops) {
    const int face = written_.mesh.face(top).value;
    first = std::min(first, face);
    last = std::max(last, face);
  }
  const int count = int(block.tops.size());
  const auto found = ids.find({first, count});
  return found != ids.end() && last - first + 1 == count ? found->second : BlockIds::mapped_type();
}

std::string BlocksWriter::style(const std::string& gradient, MeshChannel channel) const {
  std::string style = "fill:url(#" + gradient + ")";
  if (channel != MeshChannel::opacity && !fallback_.empty()) style += " " + fallback_;
  // What the object's paint and opacity leave to inherit must not act here.
  return style + ";fill-rule:nonzero;fill-opacity:1;stroke:none";
}

/// Returns by how much outlines are grown: enough that a path's smoothed edge stays off the mesh
/// even if the whole mesh is shown as small as 50 pixels.
double BlocksWriter::seam_margin() const {
  Box box;
  for (const Point p : written_.mesh.points()) box.add(written_.mesh.position(p));
  return 0.02 * std::max(box.size().x, box.size().y);
}

}  // namespace gradmesh
