#include "app/document/hemesh_document.h"

#include <algorithm>

#include "base/utf8_path.h"
#include "formats/hemesh/hemesh.h"
#include "formats/text/excerpt.h"
#include "mesh/build.h"
#include "mesh/color_model.h"
#include "mesh/subdivide.h"

namespace gradmesh {
namespace {

std::string text_of(const Mesh& mesh) {
  if (mesh.color_model() == ColorModel::bicubic) return write_hemesh(mesh);
  return write_hemesh(build_mesh(as_bicubic(subdivided(mesh, 1))));
}

class HemeshRules : public WritingRules {
 public:
  explicit HemeshRules(std::string name) : name_(std::move(name)) {}

  WrittenForm form(const Mesh& mesh, const Frame&) const override {
    return {build_mesh(read_hemesh(text_of(mesh), name_))};
  }

 private:
  const std::string name_;
};

}  // namespace

HemeshDocument::HemeshDocument(std::string_view bytes, const std::string& name)
    : Document(DocumentFile(name, bytes)) {
  entries_ = {{0, "mesh", std::nullopt, false}};
  const MeshParts parts = read_hemesh(bytes, name);
  mesh_ = naming(entries_.front(), [&] { return build_mesh(parts); });
}

std::shared_ptr<const WritingRules> HemeshDocument::rules_of_new(const std::string& name) {
  return std::make_shared<HemeshRules>(name);
}

std::string HemeshDocument::write_new(const NewDocument& document) {
  return text_of(document.mesh);
}

std::vector<MeshEntry> HemeshDocument::selected(const std::vector<std::string>& ids) const {
  for (const std::string& id : ids)
    if (id != entries_.front().id)
      throw InputError("{0}: there is no mesh with the id {1}, the only one is called \"mesh\".",
                       name(), excerpt(id));
  return entries_;
}

std::string HemeshDocument::title(const MeshEntry&) const {
  return utf8_path(name()).stem().string();
}

std::shared_ptr<const WritingRules> HemeshDocument::rules(const MeshEntry&, bool) const {
  return rules_of_new(name());
}

void HemeshDocument::replace(const std::vector<ChangedMesh>& meshes, MetricKind,
                             const WriteOptions&) {
  take(meshes.front().written.mesh);
}

void HemeshDocument::take(const Mesh& mesh) {
  text_ = text_of(mesh);
  mesh_ = build_mesh(read_hemesh(text_, name()));
}

ChosenPatches HemeshDocument::rectangle(const std::string& id) const {
  return whole(selected({id}).front());
}

bool HemeshDocument::can_be_one(const MeshEntry&) const {
  return std::ranges::any_of(mesh_.points(), [&](Point p) { return mesh_[p].is_junction(); });
}

void HemeshDocument::write_as_one(const std::vector<std::pair<MeshEntry, Mesh>>& meshes, int) {
  take(meshes.front().second);
  mark_changed();
}

void HemeshDocument::check_writing(const WriteOptions& writing) const {
  if (writing.keep_original)
    throw InputError("{0}: a .hemesh file holds one mesh, so no original can be kept in it.",
                     name());
}

}  // namespace gradmesh
