#pragma once

#include <functional>
#include <variant>

#include "app/document/document.h"
#include "formats/svg/gradient/mesh_gradient.h"
#include "formats/svg/group/pages_in_svg.h"
#include "formats/svg/group/written_label.h"
#include "formats/svg/picture/document_image.h"
#include "formats/svg/picture/picture.h"
#include "formats/svg/picture/remembered_picture.h"
#include "formats/svg/picture/shape_on_picture.h"
#include "formats/svg/tree/effects.h"
#include "formats/svg/tree/flat_tiles.h"

namespace gradmesh {

/// What an update has found of one mesh.
struct UpdateReport {
  std::string id;
  MeshCounts counts;
  /// The number of objects that paint the mesh, its blocks.
  int objects = 0;
  /// True if a person had edited the mesh.
  bool changed = false;
};

/// An SVG document: its meshes are the objects that a mesh gradient paints, and groups of blocks.
class SvgDocument : public Document {
 public:
  SvgDocument(std::string_view bytes, const std::string& name);

  /// Returns true for all XML.
  static bool recognises(std::string_view bytes);
  static std::string write_new(const NewDocument& document);

  const Format& format() const override { return format_named("svg"); }
  std::vector<MeshEntry> selected(const std::vector<std::string>& ids) const override;
  std::vector<MeshEntry> refused(const std::vector<std::string>& ids) const override;
  std::vector<UnusedMesh> unused() const override;
  const Mesh& mesh(const MeshEntry& entry) const override { return read(entry).mesh; }
  Message describe(const MeshEntry& entry) const override;
  std::shared_ptr<const Mesh> remembered_original(const MeshEntry& entry) const override;
  std::optional<VisibleArea> visible_area(const MeshEntry& entry) const override;
  std::vector<FilledOutline> covered(const std::vector<std::string>& ids) const override;
  Affine view(const MeshEntry& entry) const override;
  FramePadding padding() const override { return {}; }
  int objects(const MeshEntry& entry) const override;
  /// Returns the block whose path has this id. Throws InputError if the id names something else.
  ChosenPatches block(const std::string& id) const;
  ChosenPatches rectangle(const std::string& id) const override;
  std::shared_ptr<const WritingRules> rules(const MeshEntry& entry, bool stays_one) const override;
  bool remembers_when_edited(const MeshEntry& entry) const override;
  bool is_one_gradient(const MeshEntry& entry) const override { return !object(entry).is_group(); }
  bool can_be_one(const MeshEntry& entry) const override { return entry.simplified; }
  void check_one(const Mesh& mesh) const override;
  std::shared_ptr<const WritingRules> rules_of_one(const MeshEntry& entry) const override;
  /// Replaces groups of blocks by the objects that they were made of, each painted by one mesh
  /// gradient.
  void write_as_one(const std::vector<std::pair<MeshEntry, Mesh>>& meshes, int resolution) override;
  void check_conversion(const Format& to) const override;
  std::shared_ptr<const Original> traced_original(const MeshEntry& entry,
                                                  int resolution) const override;
  std::string bytes_over(std::string_view shown) const override;
  std::string bytes_in(const FolderMove& move) const override;

  /// Makes the selected meshes that are simplified fit together again if a person has edited their
  /// blocks (form/reconcile.h), and fits the paths of the blocks to the new outlines. The labels of
  /// the meshes get the error against the originals that the meshes remember. From then on the
  /// meshes remember themselves as edited. Throws if no selected mesh is simplified. The document
  /// is unchanged after an exception.
  std::vector<UpdateReport> update(const std::vector<std::string>& ids);

  /// Returns where the shape with this id, or what is seen of the image with this id, and lines to
  /// follow lie on the picture of an image, whose file is `pixels` large (formats/svg/picture/
  /// shape_on_picture.h).
  ShapeOnPicture shape_on_picture(const std::string& id, const std::string& image,
                                  const std::vector<std::string>& guides, glm::dvec2 pixels) const;
  /// Returns the file of that picture (formats/svg/picture/document_image.h).
  ImageFile image_file(const std::string& id, const std::string& image) const {
    return gradmesh::image_file(svg_, id, image);
  }
  /// Returns what a sentence calls the element with this id (formats/svg/group/written_label.h).
  Message called(const std::string& id) const { return gradmesh::called(svg_.find(id)); }
  /// Returns true if there is an <image> with this id.
  bool is_image(const std::string& id) const { return gradmesh::is_image(svg_, id); }
  /// Puts a rectangle above the image with this id and returns its id (formats/svg/picture/
  /// image_cover.h).
  std::string cover_image(const std::string& id, glm::dvec2 pixels);
  /// Returns the id of the image that a shape is on (image_under), which it is given if it has
  /// none.
  std::string named_image(const std::string& id, const std::string& image);
  /// Returns the picture that a mesh was traced from, if the document shows it where it was then:
  /// its image and the hash of its bytes. Nothing if a person has edited the mesh since, or moved
  /// it on the picture, whose file is `pixels` large.
  std::optional<RememberedPicture> traced_from(const MeshEntry& entry) const;
  /// Returns whether the mesh lies on a picture of that size as it did when it was traced from it.
  bool lies_as_traced(const MeshEntry& entry, const RememberedPicture& picture,
                      glm::dvec2 pixels) const;
  /// Lets a mesh that was just painted remember the picture, whose file is `pixels` large. Returns
  /// its entry. All entries are listed anew.
  MeshEntry remember_picture(const MeshEntry& entry, RememberedPicture picture, glm::dvec2 pixels);
  /// Fills the shape with this id by a mesh in its user space (formats/svg/gradient/paint_shape.h),
  /// and returns its entry. All entries are listed anew.
  MeshEntry paint_shape(const std::string& id, const Mesh& mesh);

  /// Adds pages to the document (formats/svg/group/pages_in_svg.h): `fill` is given what their
  /// objects go into, and the groups of flat tiles that are there. All entries are listed anew.
  using FillPages = std::function<void(PagesInSvg&, const std::vector<FlatTiles>&)>;
  void add_pages(const std::vector<SvgPage>& pages, const std::string& into, const FillPages& fill);

  /// Where a mesh is shown.
  struct Place {
    /// The map from the mesh's coordinates to the object's user space.
    Affine to_user;
    /// The map from there to pixels of the document in its own size.
    Affine to_page;
    /// In the mesh's coordinates, as of visible_area().
    std::optional<VisibleArea> seen;
    /// In the object's user space, as of stroke_reach().
    std::optional<Box> reach;
    /// True if the object's own shape, painted by one mesh gradient, limits what is seen.
    bool fills_shape = false;
  };
  Place place(const MeshEntry& entry) const;
  /// Returns what happens to the mesh of an object (formats/svg/tree/effects.h).
  ObjectEffects effects(const MeshEntry& entry) const {
    return object_effects(svg_, object(entry));
  }
  /// What is to be shown instead of a mesh: a picture, or colours in the object's user space.
  using Look = std::variant<PlacedPng, LinearColors>;
  /// Replaces meshes, each by what is to be shown instead, and removes what no other mesh of the
  /// document needs (formats/svg/picture/remove_meshes.h). All entries are listed anew.
  void replace_by(const std::vector<std::pair<MeshEntry, Look>>& looks);

 protected:
  void replace(const std::vector<ChangedMesh>& meshes, MetricKind metric,
               const WriteOptions& writing) override;
  Message why_not(ColorModel model) const override;
  std::string changed_bytes() const override { return text(); }

 private:
  /// Returns the map from pixels of a picture to the mesh of an object on it.
  Affine picture_to_mesh(const MeshEntry& entry, const std::string& image, glm::dvec2 pixels) const;

  /// An entry's mesh once it has been read.
  struct ReadMesh {
    Mesh mesh;
    /// True if a person has changed the mesh of a group since it was written, or if that is not
    /// known of a mesh gradient.
    bool edited = false;
    /// The result of recalled(), once that has been called.
    std::optional<std::shared_ptr<const Mesh>> recalled = std::nullopt;
  };

  const MeshObject& object(const MeshEntry& entry) const { return objects_[entry.index]; }
  /// Returns the document to be changed.
  SvgTree& changing();
  /// Returns the text of the document, which is made at the first call after a change.
  const std::string& text() const;
  /// Returns the mesh, which is read at the first call.
  const ReadMesh& read(const MeshEntry& entry) const;
  /// Returns the mesh of a group as a person has left it, reconciled, with holes where blocks were
  /// removed.
  ReadMesh group_mesh(const MeshEntry& group) const;
  /// Returns recalled_mesh() of the entry's object, in the document of which the mesh is read; null
  /// if there is none.
  std::shared_ptr<const Mesh> recalled(const MeshEntry& entry) const;
  /// Returns why none of these entries can be changed: a sentence for each of the first.
  Message all_refusals(const std::vector<std::size_t>& places) const;
  /// Does the work of update() for these meshes.
  std::vector<UpdateReport> update_edited(const std::vector<MeshEntry>& entries);
  /// Returns what a simplified mesh remembers from now on, as the value of the attribute.
  std::string new_memory(const ChangedMesh& mesh) const;
  /// Writes a mesh as one mesh gradient. It remembers its original if it did so before, or if the
  /// document becomes no larger by that.
  void replace_gradient(const ChangedMesh& mesh, const std::string& original,
                        GradientsByOrigin& by_origin);
  /// Takes the label that tells of its mesh from an object. Returns whether there was one.
  bool take_label(const MeshObject& object);
  /// Returns the label of a group that was edited: how far the mesh, as it will be written, is from
  /// the one that the group remembers.
  Message updated_label(const MeshEntry& group, const WrittenForm& form) const;
  /// Lists the meshes and reads those that are not known. What was read of an object that is there
  /// still is known, unless an entry of `written`, as it was before, has the object's id.
  void list_meshes(const std::vector<MeshEntry>& written = {});
  /// Returns MeshEntry::refused, found by reading the mesh and placing it.
  std::optional<Message> refusal(const MeshEntry& entry) const;
  /// Returns the meshes that ids name, readable or not. Throws if an id names none that can be
  /// read.
  std::vector<MeshEntry> named(const std::vector<std::string>& ids) const;

  SvgTree svg_;
  mutable std::optional<std::string> text_;
  std::vector<MeshObject> objects_;
  mutable std::vector<std::optional<ReadMesh>> read_;
};

/// Returns a document as one of SVG, for what can be done in no other. Throws InputError with the
/// message `otherwise` if it is one of another format.
SvgDocument& as_svg(Document& document, const Message& otherwise);

}  // namespace gradmesh
