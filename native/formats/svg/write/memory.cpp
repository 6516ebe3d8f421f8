#include "formats/svg/write/memory.h"

#include <algorithm>

#include "base/error.h"
#include "files/base64.h"
#include "files/zip.h"
#include "formats/hemesh/read_hemesh.h"
#include "formats/hemesh/write_hemesh.h"
#include "formats/svg/read/document.h"
#include "formats/svg/read/read_group.h"
#include "formats/svg/write/write_gradient.h"
#include "formats/svg/xml/edit.h"
#include "formats/svg/xml/node.h"
#include "geom/box.h"
#include "mesh/boundary.h"
#include "mesh/build.h"

namespace gradmesh {
namespace {

/// libxml2 takes no attribute beyond ten million bytes, and Inkscape reads with libxml2.
constexpr std::size_t longest_attribute = 9'000'000;
/// Most bytes of a document in a memory: far more than a mesh that fits into the longest attribute
/// takes.
constexpr std::size_t most_bytes = 64 << 20;
/// How many times its size a memory may unpack to, beyond the first bytes. A mesh unpacks to two to
/// twelve times; zlib could pack a thousand times, so that small documents took as much memory as
/// large ones.
constexpr std::size_t most_times = 100, first_bytes = 1 << 16;

std::optional<std::string> unpacked(std::string_view memory) {
  const auto bytes = base64_bytes(memory);
  if (!bytes) return std::nullopt;
  return unzip(*bytes, std::min(most_bytes, first_bytes + most_times * bytes->size()));
}

std::string packed(const std::string& text) {
  std::string memory = base64(zip(text));
  return memory.size() <= longest_attribute ? memory : "";
}

std::string group_document(const Mesh& mesh, const std::vector<Rectangle>& blocks,
                           const GradientFormat& format) {
  SvgDocument document =
      SvgDocument::parse("<svg xmlns=\"" + std::string(svg_namespace) + "\" xmlns:gradmesh=\"" +
                             std::string(gradmesh_namespace) + "\"><defs/><g/></svg>",
                         "memory");
  xmlNode* defs = child_elements(document.root(), "defs").front();
  xmlNode* group = child_elements(document.root(), "g").front();
  const auto own = [](xmlNode* node, const char* name, const std::string& value) {
    set_attribute(node, name, value, gradmesh_namespace, "gradmesh");
  };
  own(group, "version", "1");
  own(group, "curves", format_curves(mesh, blocks));
  int face = 0;
  for (const Rectangle& block : blocks) {
    const std::string gradient = write_block_gradient(document, defs, mesh, block, format, "m");
    xmlNode* path = add_child(group, "path");
    set_attribute(path, "fill", "url(#" + gradient + ")");
    own(path, "face", std::to_string(face));
    face += int(block.tops.size());
  }
  return document.serialize();
}

/// Returns the distance below which a tensor would only show how doubles are rounded.
double rounding(const Mesh& mesh) {
  Box box;
  for (const Point p : mesh.points()) box.add(mesh.position(p));
  return 1e-12 * (box.size().x + box.size().y);
}

MeshParts read(const std::string& text) {
  if (text.starts_with("HEMESH")) return read_hemesh(text, "memory");
  const SvgDocument document = SvgDocument::parse(text, "memory");
  for (const xmlNode* group : child_elements(document.root(), "g"))
    return read_mesh_group(document, group);
  throw InputError("{0}: there are no patches in it.", "memory");
}

}  // namespace

std::string remember(const Mesh& mesh, const std::vector<Overlap>& overlaps) {
  if (mesh.color_model() == ColorModel::bicubic) return packed(write_hemesh(mesh));
  const BlockForm form = block_form(mesh, rounding(mesh), overlaps);
  return packed(group_document(
      mesh, form.blocks,
      {.coons_tolerance = form.coons_tolerance, .channel = MeshChannel::both, .exact = true}));
}

std::string remember_as_written(const Mesh& mesh, const BlockForm& form) {
  return packed(group_document(mesh, form.blocks,
                               {.coons_tolerance = form.coons_tolerance,
                                .channel = MeshChannel::both,
                                .masked_opacity = form.masks_opacity,
                                .rounding = rounding_within(bounding_box(mesh, {}))}));
}

std::optional<MeshParts> recall(std::string_view memory) {
  const auto text = unpacked(memory);
  if (!text) return std::nullopt;
  try {
    MeshParts parts = read(*text);
    build_mesh(parts);
    return parts;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace gradmesh
