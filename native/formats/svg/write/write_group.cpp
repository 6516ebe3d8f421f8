#include "formats/svg/write/write_group.h"

#include "formats/svg/read/curves.h"
#include "formats/svg/read/paint.h"
#include "formats/svg/read/read_group.h"
#include "formats/svg/write/memory.h"
#include "formats/svg/write/remove_blocks.h"
#include "formats/svg/write/replace_shape.h"
#include "formats/svg/write/write_blocks.h"
#include "formats/svg/write/write_gradient.h"
#include "formats/svg/xml/edit.h"
#include "formats/svg/xml/node.h"

namespace gradmesh {
namespace {

class MeshWriter {
 public:
  MeshWriter(SvgDocument& document, const MeshObject& object, const WrittenMesh& written)
      : document_(document),
        object_(object),
        written_(written),
        defs_(document.defs()),
        id_(object_id(object.node)) {}

  void run() {
    if (is_mesh_group(object_.node)) {
      renew_group();
      return;
    }
    if (const auto paint =
            document_.styles().inherited(object_.node, is_stroke() ? "stroke" : "fill"))
      fallback_ = fallback_color(*paint);
    replace_shape(document_, object_, is_translucent(written_.mesh), [&](xmlNode* group) {
      const Box box = write_blocks(group, nullptr);
      describe_group(group);
      return box;
    });
  }

 private:
  bool is_stroke() const { return object_.role == PaintRole::stroke; }

  void renew_group() {
    xmlNode* group = object_.node;
    const BlockIds ids = written_.keeps_faces ? block_ids(group) : BlockIds();
    // The blocks go first, so that their ids are free.
    fallback_ = remove_blocks(document_, group);
    write_blocks(group, group->children, ids);
    describe_group(group);
  }

  /// Returns the ids of the blocks that hold all faces of the mesh; nothing if others do as well.
  BlockIds block_ids(const xmlNode* group) const {
    BlockIds ids;
    int all = 0;
    for (const auto& [path, faces] : block_faces(document_, group)) {
      const auto fill = document_.styles().declared(path, "fill");
      const int count = faces.rows * faces.columns;
      ids[{faces.first, count}] = {attribute(path, "id").value_or(""),
                                   referenced_id(fill.value_or("")).value_or("")};
      all += count;
    }
    return all == written_.mesh.face_count() ? ids : BlockIds();
  }

  void describe_group(xmlNode* group) {
    const auto own = [&](const char* name, const std::string& value) {
      if (value.empty())
        remove_attribute(group, name, gradmesh_namespace);
      else
        set_attribute(group, name, value, gradmesh_namespace, "gradmesh");
    };
    own("version", "1");
    own("role", is_stroke() ? "stroke" : "fill");
    own("handles-before", written_.before.handles ? std::to_string(written_.before.handles) : "");
    own("patches-before", std::to_string(written_.before.patches));
    own("curves", format_curves(written_.mesh, written_.form.blocks));
    own("original", written_.original);
    own("written", remember_blocks(written_.mesh, written_.form));
    own("label", written_.label);
    set_attribute(group, "label", written_.label, inkscape_namespace, "inkscape");
    // The group around it, where there is one, is what the person sees first.
    for (xmlNode* outer = parent_element(group);
         outer && attribute(outer, "outer", gradmesh_namespace); outer = parent_element(outer))
      set_attribute(outer, "label", written_.label, inkscape_namespace, "inkscape");
  }

  /// Writes the blocks and, if they do not hold the opacities, the mask that does. Returns the box
  /// around the blocks' paths.
  Box write_blocks(xmlNode* group, xmlNode* before, const BlockIds& ids = {}) {
    const BlocksWriter writer(document_, defs_, written_, id_, fallback_);
    const Box box = writer.write(
        group, before, written_.form.masks_opacity ? MeshChannel::color : MeshChannel::both, ids);
    if (written_.form.masks_opacity) {
      xmlNode* mask = add_child(defs_, "mask");
      const std::string id = document_.give_id(mask, id_ + "-opacity-mask");
      set_attribute(mask, "opacity", "1", gradmesh_namespace, "gradmesh");
      set_mask_region(mask, box);
      writer.write(mask, nullptr, MeshChannel::opacity);
      set_attribute(group, "mask", "url(#" + id + ")");
    }
    return box;
  }

  SvgDocument& document_;
  const MeshObject& object_;
  const WrittenMesh& written_;
  xmlNode* defs_;
  const std::string id_;
  /// The colour that programs that know no meshes paint instead.
  std::string fallback_;
};

}  // namespace

void write_mesh(SvgDocument& document, const MeshObject& object, const WrittenMesh& written) {
  MeshWriter(document, object, written).run();
}

}  // namespace gradmesh
