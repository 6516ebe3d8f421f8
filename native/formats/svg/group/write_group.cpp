#include "formats/svg/group/write_group.h"

#include <algorithm>
#include <map>
#include <utility>

#include "form/block_outline.h"
#include "form/rounding.h"
#include "formats/svg/group/memory.h"
#include "formats/svg/group/mesh_group.h"
#include "formats/svg/group/shape.h"
#include "formats/svg/group/written_label.h"
#include "formats/svg/tree/own.h"
#include "formats/svg/tree/paint.h"
#include "formats/svg/tree/unused.h"
#include "formats/svg/values/curves.h"
#include "formats/svg/values/mesh_names.h"
#include "formats/svg/values/reference.h"
#include "formats/svg/xml/node.h"
#include "formats/text/number.h"
#include "mesh/boundary.h"
#include "mesh/rectangle.h"

namespace gradmesh {
namespace {

/// The ids of a block's path and gradient, by the block's first face and the number of its faces.
using BlockIds = std::map<std::pair<int, int>, std::pair<std::string, std::string>>;

/// Returns the polygon with coordinates in the step; one of 0 stands for digits that suffice.
std::string path_data(const std::vector<glm::dvec2>& polygon, double step, int digits) {
  const auto number = [&](double x) {
    return step > 0 ? format_multiple(x, step) : format_number(x, digits);
  };
  std::string d;
  for (const glm::dvec2 p : polygon)
    d.append(d.empty() ? "M" : " ").append(number(p.x)).append(",").append(number(p.y));
  return d + "Z";
}

/// Removes the blocks in a group or mask, and then their gradients. Returns what remove_blocks()
/// does.
std::string remove_paths(SvgTree& tree, xmlNode* parent) {
  std::string fallback;
  std::vector<std::string> gradients;
  for (xmlNode* path : child_elements(parent)) {
    if (!is_block(path)) continue;
    if (const auto fill = tree.styles().declared(path, "fill")) {
      if (const auto id = referenced_id(*fill, tree.name())) gradients.push_back(*id);
      fallback = fallback_color(*fill);
    }
    remove_node(path);
  }
  for (const std::string& id : gradients) remove_if_unused(tree, id);
  return fallback;
}

class GroupWriter {
 public:
  GroupWriter(SvgTree& tree, const MeshObject& object, const WrittenMesh& written)
      : tree_(tree),
        object_(object),
        written_(written),
        mesh_(written.mesh),
        defs_(tree.defs()),
        id_(object_id(object.node)),
        texts_(color_texts(tree, object)) {}

  void run() {
    if (object_.is_group()) {
      const BlockIds ids = written_.keeps_faces ? block_ids() : BlockIds();
      // The blocks go first, so that their ids are free.
      fallback_ = remove_blocks(tree_, object_.node);
      write(object_.node, object_.node->children, ids);
      return;
    }
    if (const auto paint = tree_.styles().inherited(object_.node, paint_name(object_.role)))
      fallback_ = fallback_color(*paint);
    replace_shape(tree_, object_, is_translucent(mesh_),
                  [&](xmlNode* group) { return write(group, nullptr, {}); });
  }

 private:
  /// Returns the ids of the blocks that hold all faces of the mesh; nothing if others do as well.
  BlockIds block_ids() const {
    BlockIds ids;
    int all = 0;
    for (const auto& [path, faces] : block_faces(tree_, object_.node)) {
      const auto fill = tree_.styles().declared(path, "fill");
      const int count = faces.rows * faces.columns;
      ids[{faces.first, count}] = {attribute(path, "id").value_or(""),
                                   referenced_id(fill.value_or(""), tree_.name()).value_or("")};
      all += count;
    }
    return all == mesh_.face_count() ? ids : BlockIds();
  }

  /// Writes the blocks and, if they do not hold the opacities, the mask that does, and all that the
  /// group says of them. Returns the box around the blocks' paths.
  Box write(xmlNode* group, xmlNode* before, const BlockIds& ids) {
    const bool is_masked = written_.form.masks_opacity;
    const Box box =
        write_blocks(group, before, is_masked ? MeshChannel::color : MeshChannel::both, ids);
    if (is_masked) {
      xmlNode* mask = add_child(defs_, "mask");
      const std::string id = tree_.give_id(mask, id_ + "-opacity-mask");
      set_own_attribute(mask, "opacity", "1");
      set_mask_region(mask, box);
      write_blocks(mask, nullptr, MeshChannel::opacity, {});
      set_attribute(group, "mask", paint_by(id));
    }
    describe(group);
    return box;
  }

  void describe(xmlNode* group) const {
    const MeshCounts& before = written_.before;
    set_own_attribute(group, "version", "1");
    set_own_attribute(group, "role", paint_name(object_.role));
    set_own_attribute(group, "handles-before",
                      before.handles ? std::to_string(before.handles) : "");
    set_own_attribute(group, "patches-before", std::to_string(before.patches));
    set_own_attribute(group, "curves", format_curves(mesh_, written_.form.blocks));
    set_own_attribute(group, "original", written_.original);
    set_own_attribute(group, "colors", written_.original.empty() ? "" : texts_.list());
    set_own_attribute(group, "written", remember_blocks(mesh_, written_.form));
    give_written_label(group, written_.label);
  }

  /// Adds the blocks to `parent`, the largest below, before the node `before` or at the end.
  /// Blocks of the same faces get these ids, where they are free. Returns the box around the paths.
  Box write_blocks(xmlNode* parent, xmlNode* before, MeshChannel channel,
                   const BlockIds& ids) const {
    const bool color = channel != MeshChannel::opacity;
    const Box mesh_box = bounding_box(mesh_, {});
    const GradientFormat format{
        .precision = written_.form.precision,
        .channel = channel,
        .in_style = !tree_.styles().is_empty(),
        .is_important = tree_.styles().has_important(),
        .rounding = written_.form.precision.last_bits > 0 ? no_rounding : rounding_within(mesh_box),
        .texts = &texts_};
    const double margin = seam_margin();
    // A tenth of what an outline is grown by, which need not be exact.
    const double step = decimal_step(0.1 * margin);
    const int digits = digits_within(mesh_box, outline_digits);
    const auto is_free = [&](const std::string& id) { return !id.empty() && !tree_.find(id); };
    Box box;
    int face = 0;
    for (const Rectangle& block : written_.form.blocks) {
      const auto [path_id, gradient_id] = ids_of(block, ids);
      std::string gradient =
          add_gradient(tree_, mesh_, block, format, id_ + (color ? "-mesh" : "-opacity"));
      if (is_free(gradient_id)) {
        tree_.set_id(tree_.find(gradient), gradient_id);
        gradient = gradient_id;
      }
      xmlNode* path = add_child(parent, "path");
      if (before) xmlAddPrevSibling(before, path);
      if (is_free(path_id))
        tree_.set_id(path, path_id);
      else
        tree_.give_id(path, id_ + (color ? "-block" : "-opacity-block"));
      const std::vector<glm::dvec2> outline = grown_outline(mesh_, block, margin);
      for (const glm::dvec2 p : outline) box.add(p);
      set_attribute(path, "d", path_data(outline, step, digits));
      // What the object's paint and opacity leave to inherit must not act here.
      set_attribute(path, "style",
                    "fill:" + paint_by(gradient, color ? fallback_ : "") +
                        ";fill-rule:nonzero;fill-opacity:1;stroke:none");
      turn_off_effects(tree_.styles(), path);
      set_own_attribute(path, "face", std::to_string(face));
      face += int(block.tops.size());
    }
    return box;
  }

  /// Returns the ids that a block gets, if any.
  std::pair<std::string, std::string> ids_of(const Rectangle& block, const BlockIds& ids) const {
    if (ids.empty()) return {};
    const auto face = [&](Halfedge top) { return mesh_.face(top).value; };
    const auto [first, last] = std::ranges::minmax(block.tops, {}, face);
    const int count = int(block.tops.size());
    const auto found = ids.find({face(first), count});
    return found != ids.end() && face(last) - face(first) + 1 == count ? found->second
                                                                       : BlockIds::mapped_type();
  }

  /// Returns by how much outlines are grown: enough that a path's smoothed edge stays off the mesh
  /// even if the whole mesh is shown as small as 50 pixels.
  double seam_margin() const {
    Box box;
    for (const Point p : mesh_.points()) box.add(mesh_.position(p));
    return 0.02 * std::max(box.size().x, box.size().y);
  }

  SvgTree& tree_;
  const MeshObject& object_;
  const WrittenMesh& written_;
  const Mesh& mesh_;
  xmlNode* defs_;
  const std::string id_;
  const ColorTexts texts_;
  /// The colour that programs that know no meshes paint instead.
  std::string fallback_;
};

}  // namespace

void write_group(SvgTree& tree, const MeshObject& object, const WrittenMesh& written) {
  GroupWriter(tree, object, written).run();
}

std::string remove_blocks(SvgTree& tree, xmlNode* group) {
  if (xmlNode* mask = opacity_mask(tree, group)) {
    remove_attribute(group, "mask");
    // A copy of the group may use it too.
    if (!is_used(tree, attribute(mask, "id").value_or(""))) {
      remove_paths(tree, mask);
      remove_node(mask);
    }
  }
  return remove_paths(tree, group);
}

std::string add_gradient(SvgTree& tree, const Mesh& mesh, const Rectangle& block,
                         const GradientFormat& format, const std::string& prefix) {
  xmlNode* gradient = add_child(tree.defs(), mesh_gradient_name);
  std::string id = tree.give_id(gradient, prefix);
  set_attribute(gradient, "gradientUnits", "userSpaceOnUse");
  write_rows(gradient, mesh, block, format);
  return id;
}

}  // namespace gradmesh
