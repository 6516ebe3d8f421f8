#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/document/mesh_source.h"
#include "problem/problem.h"

namespace gradmesh {

struct FolderMove;

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

/// A document of one of the formats: what is read of it, and how its meshes are written. The
/// command line and the Python package work with documents. All members throw InputError, whose
/// sentence names the file and, if there are several meshes, the element.
class Document : public MeshSource {
 public:
  using MeshSource::file;
  DocumentFile& file() { return file_; }
  void set_translation(Translation translation) { translation_ = std::move(translation); }
  /// Makes runs measure against the meshes of another document, whatever this document remembers.
  /// The other document must outlive the runs. Null ends that. If each document has one mesh, runs
  /// measure against that mesh, otherwise against the mesh with the same id.
  void measure_against(const MeshSource* originals) { originals_ = originals; }

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
  /// Returns true if the mesh is to remember its original once it was edited.
  virtual bool remembers_when_edited(const MeshEntry&) const { return true; }

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

  /// Returns the content of the document, never compressed: exactly the bytes that were read if
  /// nothing was changed.
  std::string bytes() const { return changed_ ? changed_bytes() : file().content(); }
  /// Returns bytes() for another folder, with links that lead to the same files
  /// (formats/svg/tree/move_links.h).
  virtual std::string bytes_in(const FolderMove&) const { return bytes(); }
  /// Returns the content for a canvas that shows the document `shown` and takes over what differs
  /// (formats/svg/gradient/user_units.h). Throws InputError if `shown` cannot be read.
  virtual std::string bytes_over(std::string_view /*shown*/) const { return bytes(); }
  /// Throws InputError if a mesh of this document cannot be converted to a document of `to`.
  virtual void check_conversion(const Format& /*to*/) const {}

 protected:
  using MeshSource::MeshSource;

  /// Does the work of write().
  virtual void replace(const std::vector<ChangedMesh>& meshes, MetricKind metric,
                       const WriteOptions& writing) = 0;
  /// Returns the sentence that refuses a colour model which the format does not hold.
  virtual Message why_not(ColorModel model) const;
  virtual std::string changed_bytes() const = 0;

  void mark_changed() { changed_ = true; }

 private:
  bool changed_ = false;
};

}  // namespace gradmesh
