#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/image.h"
#include "io/svg_document.h"
#include "io/svg_objects.h"
#include "mesh/mesh.h"
#include "raster/rasterizer.h"
#include "simplify/simplify.h"

namespace gradmesh {

struct MeshReport {
  std::string id;
  SimplifyResult result;
};

/// A document and the meshes in it: what the command line and the Python package work with.
/// Everything throws InputError with one sentence that names the file and the element.
class Document {
 public:
  static Document read_file(const std::filesystem::path& path);
  static Document parse(std::string_view bytes, const std::string& name);

  const std::string& name() const { return name_; }
  const std::vector<MeshObject>& objects() const { return objects_; }
  /// The objects with these ids, or inside elements with these ids; all where there are no ids.
  /// Never empty.
  std::vector<MeshObject> selected(const std::vector<std::string>& ids) const;

  Mesh mesh(const MeshObject& object) const;
  /// Paints one object's mesh in a frame of its own.
  Image render(const MeshObject& object, int resolution, const Rasterizer& rasterizer) const;

  /// Simplifies the selected objects in place, each against itself as it was. An object that does
  /// not come out with fewer patches stays as it is. `options.view` is set for each object. Where
  /// this throws, the document is as it was.
  std::vector<MeshReport> simplify(const std::vector<std::string>& ids, SimplifyOptions options);

  /// The document; the very bytes that were read where nothing was changed.
  std::string bytes() const;
  void write_file(const std::filesystem::path& path) const;

 private:
  Document(SvgDocument svg, std::string name, std::string original);

  SvgDocument svg_;
  std::string name_, original_;
  std::vector<MeshObject> objects_;
  bool changed_ = false;
};

/// "Gradient mesh: 42 of 144 patches, FLIP 0.0098".
std::string mesh_label(int patches, int patches_before, MetricKind metric, double error);

}  // namespace gradmesh
