#pragma once

#include "app/document/document.h"

namespace gradmesh {

/// A .hemesh file: one mesh, called "mesh".
class HemeshDocument : public Document {
 public:
  HemeshDocument(std::string_view bytes, const std::string& name);

  static bool recognises(std::string_view bytes) { return bytes.starts_with("HEMESH"); }
  static std::shared_ptr<const WritingRules> rules_of_new(const std::string& name);
  static std::string write_new(const NewDocument& document);

  const Format& format() const override { return format_named("hemesh"); }
  std::vector<MeshEntry> selected(const std::vector<std::string>& ids) const override;
  const Mesh& mesh(const MeshEntry&) const override { return mesh_; }
  /// Returns the name of the file, as the mesh has none.
  std::string title(const MeshEntry&) const override;
  /// Returns the identity, as y points down in the file already.
  Affine view(const MeshEntry&) const override { return {}; }
  /// Returns the padding that the authors of the paper use.
  FramePadding padding() const override { return {.share = 0, .length = 0.03}; }
  Message describe(const MeshEntry&) const override { return Message("{0}", name()); }
  ChosenPatches rectangle(const std::string& id) const override;
  std::shared_ptr<const WritingRules> rules(const MeshEntry& entry, bool stays_one) const override;
  void check_writing(const WriteOptions& writing) const override;
  bool can_be_one(const MeshEntry& entry) const override;
  /// Does nothing, as the format holds meshes of any shape, and several colours at one point.
  void check_one(const Mesh&) const override {}
  std::shared_ptr<const WritingRules> rules_of_one(const MeshEntry& entry) const override {
    return rules(entry, false);
  }
  void write_as_one(const std::vector<std::pair<MeshEntry, Mesh>>& meshes, int) override;

 protected:
  void replace(const std::vector<ChangedMesh>& meshes, MetricKind metric,
               const WriteOptions& writing) override;
  std::string changed_bytes() const override { return text_; }

 private:
  void take(const Mesh& mesh);

  /// The mesh as the text holds it, so that half-edges have the numbers that any reader gives them.
  Mesh mesh_;
  std::string text_;
};

}  // namespace gradmesh
