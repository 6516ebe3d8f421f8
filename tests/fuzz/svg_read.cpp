#include <optional>
#include <string>

#include "app/document/frames.h"
#include "app/document/svg_document.h"
#include "app/export/info.h"
#include "formats/svg/gradient/mesh_gradient.h"
#include "formats/svg/tree/visible.h"
#include "mesh/build.h"
#include "target.h"

namespace gradmesh::fuzz {
namespace {

/// The first patches that are looked at closely, so that no input takes seconds.
constexpr int few = 16;

/// Every mesh of the document as its object's user sees it.
void check_meshes(std::string_view bytes) {
  std::optional<SvgDocument> document;
  if (!accepts([&] { document.emplace(bytes, input_name); })) return;
  for (const MeshEntry& entry : document->meshes()) {
    if (entry.index >= few) break;
    accepts([&] {
      const Mesh mesh = document->mesh(entry);
      require_sound(mesh);
      const Frame frame = frame_of(*document, entry, mesh, 100);
      require(frame.width >= 1 && frame.height >= 1 && frame.width <= 100 && frame.height <= 100,
              "the picture has the size that was asked for");
    });
    accepts([&] { document->block(entry.id); });
    accepts([&] { document->rectangle(entry.id); });
  }
}

/// The meshes that can be read; nothing stands for those that cannot.
std::vector<std::optional<Mesh>> meshes(SvgTree& document) {
  std::vector<std::optional<Mesh>> list;
  for (const MeshObject& object : mesh_objects(document)) {
    accepts([&] { visible_area(document, object); });
    accepts([&] { to_document(object); });
    list.emplace_back();
    if (object.gradient) accepts([&] { list.back() = build_mesh(read_mesh(document, object)); });
    if (int(list.size()) == few) break;
  }
  return list;
}

/// The document as it was read is written as one that holds the same meshes.
void check_writing(std::string_view bytes) {
  accepts([&] {
    SvgTree document = SvgTree::parse(bytes, input_name);
    const auto before = meshes(document);
    must_accept(
        [&] {
          SvgTree again = SvgTree::parse(document.serialize(), input_name);
          require(meshes(again) == before, "the meshes are the same");
        },
        "what was written can be read");
  });
}

}  // namespace

void check(std::string_view bytes) {
  check_meshes(bytes);
  check_writing(bytes);
}

}  // namespace gradmesh::fuzz
