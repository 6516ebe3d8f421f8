#pragma once

#include "app/document.h"
#include "form/reconcile.h"
#include "formats/svg/read/document.h"

namespace gradmesh {

/// Patches of a mesh, row by row as they lie in their block or mesh gradient.
struct Rectangle {
  MeshEntry entry;
  int rows = 0, columns = 0;
  std::vector<Face> faces;
};

/// An SVG document: its meshes are the objects that a mesh gradient paints, and groups of blocks.
class SvgMeshes : public Document {
 public:
  SvgMeshes(std::string_view bytes, const std::string& name);

  DocumentKind kind() const override { return DocumentKind::svg; }
  std::vector<MeshEntry> selected(const std::vector<std::string>& ids) const override;
  std::vector<MeshEntry> refused(const std::vector<std::string>& ids) const override;
  std::vector<UnusedMesh> unused() const override;
  const Mesh& mesh(const MeshEntry& entry) const override { return read(entry).mesh; }
  Affine view(const MeshEntry& entry) const override;
  FramePadding padding() const override { return {}; }

  /// The block whose path has this id. Throws InputError where it is something else.
  Rectangle block(const std::string& id) const;
  /// The same, or the mesh of the object with this id that is not simplified and one rectangle.
  Rectangle rectangle(const std::string& id) const;
  /// Writes an edited mesh in the place of what it was; the error of what is written against the
  /// original that is remembered, or else the mesh as it was. `entry` is then one no more.
  double rewrite(const MeshEntry& entry, const Mesh& mesh, MetricKind metric, int resolution);

  /// Makes of groups of blocks the objects that they stand for again, each painted by one mesh
  /// gradient. The meshes are grids with one colour at each point. All entries are then new.
  void write_as_one(const std::vector<std::pair<MeshEntry, Mesh>>& meshes, int resolution);

 protected:
  Message describe(const MeshEntry& entry) const override;
  std::shared_ptr<const Mesh> remembered_original(const MeshEntry& entry) const override;
  std::optional<VisibleArea> visible_area(const MeshEntry& entry) const override;
  bool is_one_gradient(const MeshEntry& entry) const override {
    return object(entry).gradient != nullptr;
  }
  std::shared_ptr<const WritingRules> rules(const MeshEntry& entry, bool stays_one) const override;
  void replace(const std::vector<SimplifiedMesh>& meshes, MetricKind metric,
               const WriteOptions& writing) override;
  std::vector<UpdateReport> update_edited(const std::vector<MeshEntry>& entries) override;
  std::string changed_bytes() const override { return svg_.serialize(); }

 private:
  /// What is known of an entry once it has been read.
  struct ReadMesh {
    Mesh mesh;
    /// Whether a person has changed it since it was written (mesh of a group).
    bool edited = false;
    /// As of recalled(), once that has been asked.
    std::optional<std::shared_ptr<const Mesh>> recalled = std::nullopt;
  };

  const MeshObject& object(const MeshEntry& entry) const { return objects_[entry.index]; }
  /// Reads the mesh when it is first asked for.
  const ReadMesh& read(const MeshEntry& entry) const;
  /// The mesh of a group as a person has left it, made to fit together again.
  Reconciled group_mesh(const MeshEntry& group) const;
  /// What the group remembers of the mesh before it was first simplified, as the attribute's value.
  std::optional<std::string> memory(const MeshEntry& group) const;
  /// That mesh; null where it remembers none that can be read.
  std::shared_ptr<const Mesh> recalled(const MeshEntry& group) const;
  /// Of a group that was edited, as it will be written: how far it is from what it remembers.
  Message updated_label(const MeshEntry& group, const WrittenForm& form) const;
  void list_meshes();
  /// MeshEntry::refused, found by reading the mesh and placing it.
  std::optional<Message> refusal(const MeshEntry& entry) const;
  /// The meshes that ids name, readable or not. Throws where one names none that can be read.
  std::vector<MeshEntry> named(const std::vector<std::string>& ids) const;

  SvgDocument svg_;
  std::vector<MeshObject> objects_;
  mutable std::vector<std::optional<ReadMesh>> read_;
};

}  // namespace gradmesh
