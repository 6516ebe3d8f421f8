#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/document/formats.h"
#include "base/error.h"
#include "base/image.h"
#include "formats/svg/tree/objects.h"
#include "mesh/mesh.h"
#include "mesh/rectangle.h"
#include "problem/problem.h"
#include "raster/rasterizer.h"

namespace gradmesh {

struct FolderMove;
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

/// What an update has found of one mesh.
struct UpdateReport {
  std::string id;
  MeshCounts counts;
  /// The number of objects that paint the mesh, its blocks.
  int objects = 0;
  /// True if a person had edited the mesh.
  bool changed = false;
};

/// How a simplified mesh is put into its document.
struct WriteOptions {
  /// SVG only: true if the document remembers the mesh before the mesh was first simplified
  /// (formats/svg/group/mesh_group.h). Later runs measure against the remembered mesh. The file
  /// becomes larger.
  bool remember_original = true;
  /// SVG only: true if a hidden copy of the object as it was stays directly below the object
  /// (formats/svg/tree/kept.h).
  bool keep_original = false;
};

/// A mesh that was made simpler, or edited, and is to be written in the place of its entry's.
struct ChangedMesh {
  MeshEntry entry;
  Candidate written;
  MeshCounts before;
  /// The frame in which it was measured, and the mesh against which; null if against a picture,
  /// which no document remembers.
  Frame frame;
  std::shared_ptr<const Mesh> original;
};

/// Patches that a person has chosen by an id: those of a block, or all of a mesh that is one
/// rectangle.
struct ChosenPatches {
  MeshEntry entry;
  /// In the mesh of the entry.
  Rectangle rectangle;
};

/// An edited mesh as it was written.
struct Rewritten {
  MeshCounts counts;
  /// The number of objects that paint the mesh.
  int objects;
  /// Against the original, or else against the mesh as it was.
  double error;
};

/// A document of one of the formats, with its meshes. The command line and the Python package work
/// with documents. All members throw InputError, whose sentence names the file and, if there are
/// several meshes, the element.
class Document {
 public:
  virtual ~Document() = default;

  const std::string& name() const { return name_; }
  /// The folders in which files that the document names are looked for, one after the other: that
  /// of its own file, unless they were set. Then nobody knows to which of them its links are
  /// relative, and they stay as they are wherever it is written.
  const std::vector<std::filesystem::path>& folders() const { return folders_; }
  void look_in(std::vector<std::filesystem::path> folders) {
    folders_ = std::move(folders);
    file_.clear();
  }
  /// Says from which file the document was read: what it names is looked for in the folder of that.
  void set_file(const std::filesystem::path& path);
  /// Says that the bytes were compressed, and which these were.
  void set_compressed(std::string_view bytes) { compressed_ = bytes; }
  virtual const Format& format() const = 0;
  /// Returns the colour model of the document's meshes.
  ColorModel color_model() const { return format().color_models.front(); }

  /// Returns the translation of labels and drawings, which is English by default. Errors are not
  /// translated here, as they carry their messages.
  const Translation& translation() const { return translation_; }
  void set_translation(Translation translation) { translation_ = std::move(translation); }

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
  /// Returns the frame in which a mesh of this document is painted and measured.
  Frame frame(const MeshEntry& entry, const Mesh& mesh, int resolution) const;
  /// Returns how a mesh is laid out on pictures. Leaves out what is visible of it if all of the
  /// mesh counts.
  Layout layout(const MeshEntry& entry, bool visible_only) const;
  /// Paints a mesh in its own frame. If there is a document `framed_as`, paints the mesh in the
  /// frame of its counterpart there (common_frames.h), so that the two pictures can be laid on each
  /// other.
  Image render(const MeshEntry& entry, int resolution, const Rasterizer& rasterizer,
               const Document* framed_as = nullptr) const;
  /// Returns the picture that Inkscape paints of the mesh, in the same frame. Throws if the colours
  /// are bicubic, which Inkscape cannot paint.
  Image render_like_inkscape(const MeshEntry& entry, int resolution,
                             const Document* framed_as = nullptr) const;

  /// Makes runs measure against the meshes of another document, whatever this document remembers.
  /// The other document must outlive the runs. Null ends that. If each document has one mesh, runs
  /// measure against that mesh, otherwise against the mesh with the same id.
  void measure_against(const Document* originals) { originals_ = originals; }
  /// Returns the mesh of the other document that corresponds to `entry`, in the units of the mesh
  /// of `entry`; null if measure_against named no document. Throws InputError if no mesh
  /// corresponds.
  std::shared_ptr<const Mesh> given_original(const MeshEntry& entry) const;

  /// Returns the mesh against which runs measure: its given_original, or the original that the mesh
  /// remembers unless a person has edited the mesh since; null if the mesh itself.
  std::shared_ptr<const Mesh> original(const MeshEntry& entry) const;
  /// Returns the picture that the mesh was traced from, in the units of the mesh; null if it was
  /// traced from none, or looks like that no longer (traced_original.h). `resolution` is that at
  /// which it will be painted.
  virtual std::shared_ptr<const Original> traced_original(const MeshEntry&,
                                                          int /*resolution*/) const {
    return nullptr;
  }
  /// Returns true if runs measure against an original that the mesh remembers, unless they are told
  /// otherwise: it can be read, and no person has edited the mesh since.
  bool remembers(const MeshEntry& entry) const { return remembered_original(entry) != nullptr; }
  /// Returns true if the mesh may have been moved away from an original before.
  bool may_differ(const MeshEntry& entry) const {
    return entry.simplified || remembers(entry) || originals_;
  }

  /// Returns the visible area of the mesh; nothing if all of the mesh counts as visible.
  virtual std::optional<VisibleArea> visible_area(const MeshEntry&) const { return std::nullopt; }
  /// Returns what the shapes with these ids cover, as the person sees them (view()). Throws
  /// InputError if one is none, and if the format holds no shapes beside meshes.
  virtual std::vector<FilledOutline> covered(const std::vector<std::string>& ids) const;
  /// Returns true if the mesh is one mesh gradient on its object, and may stay one.
  virtual bool is_one_gradient(const MeshEntry&) const { return false; }
  /// Returns the rules by which the mesh of an entry is written. If `stays_one` is true and the
  /// mesh is one mesh gradient, the rules are those of one mesh gradient.
  virtual std::shared_ptr<const WritingRules> rules(const MeshEntry& entry,
                                                    bool stays_one) const = 0;
  /// Throws InputError if the document cannot hold the colour model.
  void check_color_model(ColorModel model) const;
  /// Throws InputError if the format cannot write meshes with these options.
  virtual void check_writing(const WriteOptions&) const {}
  /// Writes meshes in the place of those of their entries, and lists the entries afresh.
  void write(const std::vector<ChangedMesh>& meshes, MetricKind metric,
             const WriteOptions& writing);
  /// Writes an edited mesh in the place of the entry's mesh. If it is `meant_to_differ`, it forgets
  /// its original, so that it counts as the original itself. `entry` is no longer valid afterwards.
  Rewritten rewrite(const MeshEntry& entry, const Mesh& edited, MetricKind metric, int resolution,
                    bool meant_to_differ = false);

  /// Returns true if the mesh of the entry has patches that one ordinary mesh would not have: if it
  /// is simplified, in a format that holds more than one mesh gradient.
  virtual bool can_be_one(const MeshEntry& entry) const = 0;
  /// Throws InputError if the format cannot hold a mesh without T-junctions as one ordinary mesh.
  virtual void check_one(const Mesh& mesh) const = 0;
  /// Returns the rules by which an ordinary mesh is written.
  virtual std::shared_ptr<const WritingRules> rules_of_one(const MeshEntry& entry) const = 0;
  /// Replaces meshes by ordinary ones, which pass check_one(). All entries are listed anew.
  virtual void write_as_one(const std::vector<std::pair<MeshEntry, Mesh>>& meshes,
                            int resolution) = 0;
  /// Makes the selected meshes that are simplified fit together again if a person has edited their
  /// blocks (form/reconcile.h), and fits the paths of the blocks to the new outlines. The labels of
  /// the meshes get the error against the originals that the meshes remember. From then on the
  /// meshes remember themselves as edited. Throws if no selected mesh is simplified, and if the
  /// format holds no blocks. The document is unchanged after an exception.
  std::vector<UpdateReport> update(const std::vector<std::string>& ids);
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

  /// Returns the content of the document, never compressed: exactly the bytes that were read if
  /// nothing was changed.
  std::string bytes() const { return changed_ ? changed_bytes() : content_; }
  /// Returns the content for a canvas that shows the document `shown` and takes over what differs
  /// (formats/svg/gradient/user_units.h). Throws InputError if `shown` cannot be read.
  virtual std::string bytes_over(std::string_view /*shown*/) const { return bytes(); }
  /// Returns what was found of a document of pages; null if this was none.
  virtual const FoundPages* pages() const { return nullptr; }
  /// Throws InputError if a mesh of this document cannot be converted to a document of `to`.
  virtual void check_conversion(const Format& /*to*/) const {}
  /// Throws InputError if the path's extension is that of another format.
  void check_target(const std::filesystem::path& path) const;
  /// Writes bytes() into a file, compressed by gzip if the path's extension says so. In another
  /// folder than that from which the document was read, links to files are such that they lead to
  /// the same files (formats/svg/tree/move_links.h). Throws as check_target does, and if the file
  /// cannot be written.
  void write_file(const std::filesystem::path& path) const;

 protected:
  Document(std::string name, std::string_view bytes) : name_(std::move(name)), content_(bytes) {}

  /// Returns the mesh before it was first simplified; null if the document does not hold it.
  virtual std::shared_ptr<const Mesh> remembered_original(const MeshEntry&) const {
    return nullptr;
  }
  /// Returns the mesh of an entry, which is not simplified, if it is one rectangle. Throws
  /// InputError otherwise.
  ChosenPatches whole(const MeshEntry& entry) const;
  /// Returns true if the mesh is to remember its original once it was edited.
  virtual bool is_to_remember(const MeshEntry&) const { return true; }
  /// Does the work of write().
  virtual void replace(const std::vector<ChangedMesh>& meshes, MetricKind metric,
                       const WriteOptions& writing) = 0;
  /// Returns the sentence that refuses a colour model which the format does not hold.
  virtual Message why_not(ColorModel model) const;
  /// Does the work of update() for these meshes. Throws InputError by default.
  virtual std::vector<UpdateReport> update_edited(const std::vector<MeshEntry>& entries);
  virtual std::string changed_bytes() const = 0;
  /// Returns bytes() for another folder.
  virtual std::string bytes_in(const FolderMove&) const { return bytes(); }

  void mark_changed() { changed_ = true; }
  bool has_given_originals() const { return originals_ != nullptr; }

  std::vector<MeshEntry> entries_;

 private:
  /// Returns what write_file() writes, before it is compressed.
  std::string bytes_for(const std::filesystem::path& path) const;

  std::string name_, content_;
  /// The bytes that were read if those were compressed; empty otherwise.
  std::string compressed_;
  std::vector<std::filesystem::path> folders_;
  /// The absolute path of the file that was read; empty if it is not known.
  std::filesystem::path file_;
  Translation translation_ = [](const std::string& text) { return text; };
  bool changed_ = false;
  const Document* originals_ = nullptr;
};

}  // namespace gradmesh
