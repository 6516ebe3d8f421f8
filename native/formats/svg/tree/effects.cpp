#include "formats/svg/tree/effects.h"

#include <algorithm>

#include "formats/svg/tree/own.h"
#include "formats/svg/xml/node.h"
#include "formats/text/scanner.h"

namespace gradmesh {
namespace {

/// Returns true if the object paints something beside its mesh.
bool paints_more(const SvgTree& tree, const MeshObject& object) {
  if (!object.is_group()) {
    const bool fills = object.role == PaintRole::fill;
    const std::string otherwise = fills ? "none" : "black";
    return tree.styles().inherited(object.node, fills ? "stroke" : "fill").value_or(otherwise) !=
           "none";
  }
  // The other paint of an object that has become a group of blocks stands beside that group.
  const std::vector<xmlNode*> groups = with_outer(object.node);
  for (std::size_t i = 1; i < groups.size(); ++i)
    for (const xmlNode* child : child_elements(groups[i]))
      if (child != groups[i - 1] && can_paint(child, PaintRole::fill)) return true;
  return false;
}

class EffectFinder {
 public:
  EffectFinder(const SvgTree& tree, const MeshObject& object) : tree_(tree), object_(object) {}

  ObjectEffects run() {
    if (!object_.is_group()) {
      const bool fills = object_.role == PaintRole::fill;
      multiply(tree_.styles().inherited(object_.node, fills ? "fill-opacity" : "stroke-opacity"));
    }
    for (const xmlNode* node = object_.node; node; node = parent_element(node)) add(node);
    // The stroke in white.
    if (object_.is_group() && object_.role == PaintRole::stroke && found_.masks > 0) --found_.masks;
    found_.has_other_paint = paints_more(tree_, object_);
    return found_;
  }

 private:
  void multiply(const std::optional<std::string>& opacity) {
    if (opacity) found_.opacity *= std::clamp(parse_opacity(*opacity).value_or(1.0), 0.0, 1.0);
  }

  void add(const xmlNode* node) {
    const StyleSheet& styles = tree_.styles();
    const auto differs = [&](const char* property, const char* usual) {
      return styles.declared(node, property).value_or(usual) != usual;
    };
    multiply(styles.declared(node, "opacity"));
    found_.has_filter = found_.has_filter || differs("filter", "none");
    found_.has_blend_mode = found_.has_blend_mode || differs("mix-blend-mode", "normal");
    if (referenced(tree_, styles.declared(node, "clip-path"))) ++found_.clips;
    const xmlNode* const mask = referenced(tree_, styles.declared(node, "mask"));
    if (mask && !is_opacity_mask(mask)) ++found_.masks;
  }

  const SvgTree& tree_;
  const MeshObject& object_;
  ObjectEffects found_;
};

}  // namespace

ObjectEffects object_effects(const SvgTree& tree, const MeshObject& object) {
  return EffectFinder(tree, object).run();
}

}  // namespace gradmesh
