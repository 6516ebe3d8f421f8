#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/document/document_file.h"
#include "app/document/formats.h"
#include "base/error.h"
#include "formats/svg/tree/objects.h"
#include "mesh/mesh.h"
#include "mesh/rectangle.h"
#include "reference/original.h"

namespace gradmesh {

struct FoundPages;

/// A mesh as its document lists it.
struct MeshEntry {
  /// The place in Document::meshes().
  int index = 0;
  /// The id of the object that the mesh paints; "mesh" in a .hemesh file, which has one mesh and no
  /// names. An object whose fill and stroke are meshes is listed twice.
  std::string id;
  /// The part of the object that the mesh paints; nothing in a .hemesh file.
  std::optional<PaintRole> role;
  /// True if the mesh is a group of blocks that gradmesh wrote.
  bool simplified = false;
  /// True if the mesh is the hidden original of another one. Only its own id chooses it.
  bool kept = false;
  /// The sentence that says why the mesh cannot be read; nothing if the mesh can be read.
  std::optional<Message> refused = std::nullopt;
};

/// A mesh gradient that paints nothing.
struct UnusedMesh {
  std::string id;
  int patches = 0;
};

/// Patches that a person has chosen by an id: those of a block, or all of a mesh that is one
/// rectangle.
struct ChosenPatches {
  MeshEntry entry;
  /// In the mesh of the entry.
  Rectangle rectangle;
};

/// What is read of a document: its meshes, and how a person sees them. All members throw
/// InputError, whose sentence names the file and, if there are several meshes, the element.
class MeshSource {
 public:
  virtual ~MeshSource() = default;

  const std::string& name() const { return file_.name(); }
  const DocumentFile& file() const { return file_; }
  virtual const Format& format() const = 0;
  /// Returns the colour model of the document's meshes.
  ColorModel color_model() const { return format().color_models.front(); }
  /// Returns what was found of a document of pages; null if this was none.
  virtual const FoundPages* pages() const { return nullptr; }
  /// Returns the translation of labels and drawings, which is English by default. Errors are not
  /// translated here, as they carry their messages.
  const Translation& translation() const { return translation_; }

  /// Returns all meshes; empty if there are none.
  const std::vector<MeshEntry>& meshes() const { return entries_; }
  /// Returns the meshes of the objects with these ids and of the objects inside elements with these
  /// ids; all meshes if there are no ids. Leaves out hidden originals, unless the originals are
  /// named themselves, and meshes that cannot be read. Throws if an id names no mesh that can be
  /// read, so the result is never empty.
  virtual std::vector<MeshEntry> selected(const std::vector<std::string>& ids) const = 0;
  /// Returns the meshes that selected() leaves out because they cannot be read. Throws the same
  /// exceptions as selected().
  virtual std::vector<MeshEntry> refused(const std::vector<std::string>&) const { return {}; }
  /// Returns the mesh gradients that paint no object.
  virtual std::vector<UnusedMesh> unused() const { return {}; }

  /// Returns the result of `work`. Adds the names of the file and the element to InputErrors of
  /// `work`, since most of the core does not know the names.
  template <class Work>
  auto naming(const MeshEntry& entry, const Work& work) const {
    try {
      return work();
    } catch (const InputError& error) {
      throw InputError("{0}: {1}", describe(entry), error.message());
    }
  }

  /// Returns the name of a mesh in messages: the file and, if the file may have several meshes, the
  /// element.
  virtual Message describe(const MeshEntry& entry) const = 0;

  /// Returns the mesh of an entry. The mesh is read once. The reference is valid until the document
  /// is next changed.
  virtual const Mesh& mesh(const MeshEntry& entry) const = 0;
  /// Returns the name of a mesh in reports.
  virtual std::string title(const MeshEntry& entry) const { return entry.id; }
  /// Returns the map from mesh units to what the person sees (y down), up to scale.
  virtual Affine view(const MeshEntry& entry) const = 0;
  virtual FramePadding padding() const = 0;
  /// Returns the number of objects that paint the mesh: the blocks of a group, 1 otherwise.
  virtual int objects(const MeshEntry&) const { return 1; }
  /// Returns the block with this id, or the whole mesh with this id if it is one rectangle. Throws
  /// InputError otherwise.
  virtual ChosenPatches rectangle(const std::string& id) const = 0;
  /// Returns the visible area of the mesh; nothing if all of the mesh counts as visible.
  virtual std::optional<VisibleArea> visible_area(const MeshEntry&) const { return std::nullopt; }
  /// Returns what the shapes with these ids cover, as the person sees them (view()). Throws
  /// InputError if one is none, and if the format holds no shapes beside meshes.
  virtual std::vector<FilledOutline> covered(const std::vector<std::string>& ids) const;

  /// Returns the document whose meshes count as originals, whatever this one remembers; null if
  /// there is none.
  const MeshSource* originals() const { return originals_; }
  /// Returns the mesh before it was first simplified; null if the document does not hold it, and if
  /// a person has edited the mesh since.
  virtual std::shared_ptr<const Mesh> remembered_original(const MeshEntry&) const {
    return nullptr;
  }
  /// Returns the picture that the mesh was traced from, in the units of the mesh; null if it was
  /// traced from none, or looks like that no longer (document_picture.h). `resolution` is that at
  /// which it will be painted.
  virtual std::shared_ptr<const Original> traced_original(const MeshEntry&,
                                                          int /*resolution*/) const {
    return nullptr;
  }

 protected:
  explicit MeshSource(DocumentFile file) : file_(std::move(file)) {}

  /// Returns the mesh of an entry, which is not simplified, if it is one rectangle. Throws
  /// InputError otherwise.
  ChosenPatches whole(const MeshEntry& entry) const;

  DocumentFile file_;
  std::vector<MeshEntry> entries_;
  Translation translation_ = [](const std::string& text) { return text; };
  const MeshSource* originals_ = nullptr;
};

/// Returns the mesh that `ids` name or, if there are no ids, the only one of the document. Throws
/// InputError if there are several; the message says that one is chosen with `option`.
MeshEntry one_mesh(const MeshSource& document, const std::vector<std::string>& ids,
                   const std::string& option = "--id");
/// Returns the mesh that `id` names, as above; the only one of the document if `id` is empty.
MeshEntry one_mesh(const MeshSource& document, const std::string& id);

}  // namespace gradmesh
