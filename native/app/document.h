#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/analysis_file.h"
#include "app/formats.h"
#include "base/error.h"
#include "base/image.h"
#include "formats/svg/read/objects.h"
#include "mesh/mesh.h"
#include "raster/rasterizer.h"
#include "simplify/simplify.h"

namespace gradmesh {

/// A mesh as its document lists it.
struct MeshEntry {
  /// Its place in Document::meshes().
  int index = 0;
  /// Of the object that it paints; "mesh" in a .hemesh file, which has one mesh and no names. An
  /// object whose fill and stroke are meshes is listed twice.
  std::string id;
  /// What of the object it paints; nothing in a .hemesh file.
  std::optional<PaintRole> role;
  /// Whether it is a group of blocks that gradmesh wrote.
  bool simplified = false;
  /// Whether it is the hidden original of another one, chosen only by its own id.
  bool kept = false;
  /// Why its mesh cannot be read, a sentence; nothing where it can.
  std::optional<Message> refused = std::nullopt;
};

/// A mesh gradient that paints nothing.
struct UnusedMesh {
  std::string id;
  int patches = 0;
};

struct MeshReport {
  std::string id;
  SimplifyResult result;
  /// MeshEntry::refused; then there is no result.
  std::optional<Message> refused = std::nullopt;
};

/// What an update has found.
struct UpdateReport {
  std::string id;
  int patches = 0;
  /// Whether a person had edited it.
  bool changed = false;
};

/// How a simplified mesh is put into its document.
struct WriteOptions {
  /// SVG only: it remembers the mesh before it was first simplified
  /// (formats/svg/read/read_group.h), which makes the file larger, and which later runs measure
  /// against.
  bool remember_original = true;
  /// SVG only: a copy of the object as it was stays directly below it, hidden
  /// (formats/svg/write/keep_original.h).
  bool keep_original = false;
};

/// A document of one of the formats, and the meshes in it: what the command line and the Python
/// package work with. Everything throws InputError with one sentence that names the file and,
/// where there are several, the element.
class Document {
 public:
  /// Which format it has follows from the content.
  static std::unique_ptr<Document> read_file(const std::filesystem::path& path);
  static std::unique_ptr<Document> parse(std::string_view bytes, const std::string& name);
  virtual ~Document() = default;

  const std::string& name() const { return name_; }
  virtual const Format& format() const = 0;
  /// Returns the colour model of its meshes.
  ColorModel color_model() const { return format().color_models.front(); }

  /// How labels and drawings name things; in English unless said otherwise. Errors carry their
  /// messages.
  const Translation& translation() const { return translation_; }
  void set_translation(Translation translation) { translation_ = std::move(translation); }

  /// All meshes; there may be none.
  const std::vector<MeshEntry>& meshes() const { return entries_; }
  /// The meshes of the objects with these ids, or inside elements with these ids; all where there
  /// are no ids. Hidden originals are left out unless they are named themselves, and so are those
  /// that cannot be read, where an id names another one as well. Never empty.
  virtual std::vector<MeshEntry> selected(const std::vector<std::string>& ids) const = 0;
  /// Those that selected() leaves out because they cannot be read. Throws as that does.
  virtual std::vector<MeshEntry> refused(const std::vector<std::string>&) const { return {}; }
  /// Mesh gradients that paint none of the meshes.
  virtual std::vector<UnusedMesh> unused() const { return {}; }

  /// The mesh of an entry, which is read once; until the document is next changed.
  virtual const Mesh& mesh(const MeshEntry& entry) const = 0;
  /// Returns what reports call a mesh.
  virtual std::string title(const MeshEntry& entry) const { return entry.id; }
  /// From mesh units to what the person sees (y down), up to scale.
  virtual Affine view(const MeshEntry& entry) const = 0;
  virtual FramePadding padding() const = 0;
  /// The frame in which a mesh of this document is painted and measured.
  Frame frame(const MeshEntry& entry, const Mesh& mesh, int resolution) const;
  /// The same where only what is seen counts, as by default.
  Frame seen_frame(const MeshEntry& entry, const Mesh& mesh, int resolution) const;
  /// Paints a mesh in its own frame or, where there is another document, in that of its counterpart
  /// there (common_frames.h), so that the two pictures can be laid on each other.
  Image render(const MeshEntry& entry, int resolution, const Rasterizer& rasterizer,
               const Document* framed_as = nullptr) const;
  /// The picture that Inkscape paints of it, in the same frame. Throws where the colours are
  /// bicubic, which Inkscape cannot paint.
  Image render_like_inkscape(const MeshEntry& entry, int resolution,
                             const Document* framed_as = nullptr) const;

  /// Makes meshes of another document, which must outlive the runs, those against which runs
  /// measure, whatever is remembered; null: no longer. With one mesh in each it is that one,
  /// otherwise the one with the same id.
  void measure_against(const Document* originals) { originals_ = originals; }
  /// That mesh in the units of its counterpart here; null where measure_against named no document.
  /// Throws InputError where there is none.
  std::shared_ptr<const Mesh> given_original(const MeshEntry& entry) const;

  /// What a run over a mesh begins with: the mesh, in the colour model that is asked for, and the
  /// options with what this document sets: the view, the padding, how it is written, the original
  /// where that is another mesh, the method, and the analysis, which is one of `files`. The method
  /// of a smooth mesh is `lines`, unless the person names edges; `simplest` becomes `plain` where
  /// the mesh can stay one mesh gradient and no target is asked for, and else `best`.
  struct Start {
    Mesh mesh;
    RunOptions options;
    /// True if whatever is simplest is asked for, which may be a group of blocks too.
    bool may_be_blocks = false;
  };
  Start start(const MeshEntry& entry, const RunOptions& options, AnalysisFiles& files) const;

  /// Simplifies the selected meshes in place, each against `options.original`, its given_original,
  /// the original that it remembers, unless a person has edited it since, or itself as it was.
  /// Those that cannot be read are only reported. Where nothing is merged, or what is left needs a
  /// mask for opacities, the method `lines` is tried as well, and its one mesh
  /// gradient taken where it leaves no more patches. Where `simplest` finds no plain mesh gradient
  /// with fewer handles, blocks are tried, and taken where these leave less to handle. A mesh that
  /// does not come out simpler stays as it is. In another colour model than its own it is converted
  /// first, which counts towards the error. Where an analysis is loaded, there must be one for each
  /// of the meshes. Where this throws, the document is as it was. Throws std::invalid_argument as
  /// gradmesh::simplify does, where edges are named for another method than `manual` or none for
  /// that, and where there are no prices to save.
  std::vector<MeshReport> simplify(const std::vector<std::string>& ids, const RunOptions& options,
                                   const AnalysisPaths& analyses = {},
                                   const WriteOptions& writing = {});
  /// What simplify() would do; nothing is changed. For `manual` it tells the error of the edges
  /// also where that is too large.
  std::vector<MeshReport> preview(const std::vector<std::string>& ids, RunOptions options,
                                  const AnalysisPaths& analyses = {}) const;
  /// Makes those of the selected meshes that are simplified fit together again where a person has
  /// edited their blocks (form/reconcile.h), and lets the blocks' paths grow with them. Their
  /// labels say how far they are from the originals that they remember, and the meshes as edited
  /// are what they remember then. Where this throws, the document is as it
  /// was: where nothing selected is simplified, and where the format holds no blocks.
  std::vector<UpdateReport> update(const std::vector<std::string>& ids);
  /// Prices the selected meshes up to epsilon and saves that; the number of prices.
  std::size_t analyze(const std::vector<std::string>& ids, const RunOptions& options,
                      const AnalysisPaths& analyses) const;

  /// Runs `work`; what the core says of a mesh, without knowing whose it is, gets the names of the
  /// file and the element.
  template <class Work>
  auto naming(const MeshEntry& entry, const Work& work) const {
    try {
      return work();
    } catch (const InputError& error) {
      throw InputError("{0}: {1}", describe(entry), error.message());
    }
  }

  /// The document; the very bytes that were read where nothing was changed, unpacked.
  std::string bytes() const { return changed_ ? changed_bytes() : original_; }
  /// Throws InputError if a mesh of this document cannot be converted to a document of `to`.
  virtual void check_conversion(const Format& /*to*/) const {}
  /// Throws InputError where the path's extension is that of another format.
  void check_target(const std::filesystem::path& path) const;
  /// Compressed by gzip where the path's extension says so, otherwise as bytes() has it. Throws as
  /// check_target does, and where the file cannot be written.
  void write_file(const std::filesystem::path& path) const;

 protected:
  struct SimplifiedMesh {
    MeshEntry entry;
    Mesh mesh;
    SimplifyResult result;
    /// What it was measured against.
    std::shared_ptr<const Mesh> original;
  };

  Document(std::string name, std::string_view bytes) : name_(std::move(name)), original_(bytes) {}

  /// How messages name a mesh: the file and, where it has several, the element.
  virtual Message describe(const MeshEntry& entry) const = 0;
  /// The mesh before it was first simplified, where the document tells; null otherwise.
  virtual std::shared_ptr<const Mesh> remembered_original(const MeshEntry&) const {
    return nullptr;
  }
  /// What is seen of the mesh, where that is known; nothing: all.
  virtual std::optional<VisibleArea> visible_area(const MeshEntry&) const { return std::nullopt; }
  /// Whether the mesh is one mesh gradient on its object, and may stay that.
  virtual bool is_one_gradient(const MeshEntry&) const { return false; }
  /// How the mesh of an entry is written: where it is one gradient and is to stay that, as one.
  virtual std::shared_ptr<const WritingRules> rules(const MeshEntry& entry,
                                                    bool stays_one) const = 0;
  /// Puts simplified meshes in the places of those that they were, and lists the entries afresh.
  virtual void replace(const std::vector<SimplifiedMesh>& meshes, MetricKind metric,
                       const WriteOptions& writing) = 0;
  /// Returns why a document cannot hold a colour model that its format does not hold.
  virtual Message why_not(ColorModel model) const;
  /// Throws InputError if meshes cannot be written in this way.
  virtual void check_writing(const WriteOptions&) const {}
  /// Does what update() does, for these meshes.
  virtual std::vector<UpdateReport> update_edited(const std::vector<MeshEntry>& entries);
  virtual std::string changed_bytes() const = 0;

  void mark_changed() { changed_ = true; }
  bool has_given_originals() const { return originals_ != nullptr; }

  std::vector<MeshEntry> entries_;

 private:
  /// Returns the method that is used where a person asks for one.
  std::string method_for(const std::string& asked, const MeshEntry& entry, const Mesh& mesh,
                         const SimplifyOptions& options) const;
  std::vector<SimplifiedMesh> simplified(const std::vector<std::string>& ids,
                                         const RunOptions& options,
                                         const AnalysisPaths& analyses) const;
  /// Simplifies the mesh of `start`, also by another method where simplify() says so.
  SimplifyResult simplified(const MeshEntry& entry, const Start& start, Mesh& mesh) const;
  /// Simplifies the mesh of `start` by that method, after a run that found `before`: its time
  /// counts towards the budget. Returns nothing if no time is left.
  std::optional<SimplifyResult> simplified_anew(const MeshEntry& entry, const Start& start,
                                                const std::string& method,
                                                const SimplifyResult& before, Mesh& mesh) const;
  /// Throws where the document cannot hold the colour model that is asked for.
  void check_color_model(const RunOptions& options) const;
  /// Throws where a mesh was above epsilon from the start, in another colour model or document.
  void check_start(const SimplifiedMesh& mesh, const RunOptions& options) const;
  static std::vector<MeshReport> reports_of(const std::vector<SimplifiedMesh>& meshes,
                                            const std::vector<MeshEntry>& refused);

  std::string name_, original_;
  /// What was read, where that was compressed.
  std::string compressed_;
  Translation translation_ = [](const std::string& text) { return text; };
  bool changed_ = false;
  const Document* originals_ = nullptr;
};

/// "Gradient mesh: 42 patches".
Message mesh_label(int patches);
/// "Gradient mesh: 42 of 144 patches".
Message mesh_label(int patches, int patches_before);
/// "Gradient mesh: 42 of 144 patches, FLIP 0.0098".
Message mesh_label(int patches, int patches_before, MetricKind metric, double error);

}  // namespace gradmesh
