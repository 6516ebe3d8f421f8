#include "formats/svg/gradient/user_units.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "formats/svg/gradient/mesh_gradient.h"
#include "formats/svg/tree/objects.h"
#include "formats/svg/tree/paint.h"
#include "formats/svg/tree/unused.h"
#include "formats/svg/values/transform.h"
#include "formats/svg/xml/node.h"

namespace gradmesh {
namespace {

/// Returns true if Inkscape makes the outline of the shape itself, from other numbers.
bool is_outlined_late(const xmlNode* shape) {
  const std::string_view name = svg_name(shape);
  if (name == "path")
    return attribute(shape, "type", "http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd") ||
           attribute(shape, "path-effect", inkscape_namespace);
  return name == "rect" || name == "circle" || name == "ellipse" || name == "line";
}

/// Returns true if two elements have the same name and attributes.
bool are_alike(const xmlNode* a, const xmlNode* b) {
  const auto said = [](const xmlNode* node) {
    std::map<std::pair<std::string_view, std::string_view>, std::string> values;
    for (const xmlAttr* at : attributes(node))
      values[{at->ns ? view(at->ns->href) : "", view(at->name)}] = text_of(at->children, node);
    return values;
  };
  return svg_name(a) == svg_name(b) && said(a) == said(b);
}

bool are_alike_throughout(const xmlNode* a, const xmlNode* b) {
  return are_alike(a, b) && std::ranges::equal(child_elements(a), child_elements(b),
                                               [](const xmlNode* child, const xmlNode* other) {
                                                 return are_alike_throughout(child, other);
                                               });
}

const xmlNode* counterpart(const xmlNode* node, const SvgTree& shown) {
  return shown.find(attribute(node, "id").value_or(""));
}

/// Returns true if the shape stays where it is on the canvas, with all that it is inside of and the
/// gradient that paints it.
bool stays(const SvgTree& tree, const MeshObject& object, const SvgTree& shown) {
  for (const xmlNode* gradient : gradient_chain(tree, object.gradient)) {
    const xmlNode* const before = counterpart(gradient, shown);
    if (!before || !are_alike_throughout(gradient, before)) return false;
  }
  const xmlNode* before = counterpart(object.node, shown);
  const xmlNode* node = object.node;
  // The root is given its new attributes.
  for (; before && parent_element(node); before = parent_element(before)) {
    if (!are_alike(node, before)) return false;
    node = parent_element(node);
  }
  return before && !parent_element(before);
}

/// Returns the map from the gradient to user space, as text; empty if the mesh is to be left as it
/// is, as where it cannot be read.
std::string place_in_user(const SvgTree& tree, const MeshObject& object, const SvgTree& shown) {
  if (object.is_group() || !is_outlined_late(object.node)) return "";
  try {
    if (!uses_bounding_box(tree, object.gradient) || stays(tree, object, shown)) return "";
    return transform_text(gradient_to_user(tree, object));
  } catch (const InputError&) {
    return "";
  }
}

/// Adds a copy of a gradient behind it. Ids of what is inside are the gradient's own, and so is
/// what rules say by these ids, which is written out.
xmlNode* add_copy_behind(SvgTree& tree, xmlNode* gradient, const std::string& prefix) {
  xmlNode* const copy = add_copy(parent_element(gradient), gradient);
  xmlAddNextSibling(gradient, copy);
  tree.give_id(copy, prefix);
  const std::vector<xmlNode*> from = elements_from(gradient), to = elements_from(copy);
  for (std::size_t i = 1; i < to.size(); ++i) {
    const Declarations said = said_by_rules(tree.styles(), from[i]);
    remove_attribute(to[i], "id");
    keep_said(tree.styles(), said, to[i]);
  }
  return copy;
}

void set_place(xmlNode* gradient, const std::string& place) {
  set_attribute(gradient, "gradientUnits", "userSpaceOnUse");
  set_attribute(gradient, "gradientTransform", place);
}

/// The objects that a gradient paints, by its places.
using Painted = std::map<std::string, std::vector<MeshObject>>;

/// Returns true if a gradient is used by more than these objects, and those around them from which
/// they alone have it.
bool is_used_beside(SvgTree& tree, const xmlNode* gradient,
                    const std::vector<MeshObject>& objects) {
  std::set<const xmlNode*> users;
  for (const MeshObject& object : objects)
    for (const xmlNode* node = object.node; node; node = parent_element(node)) users.insert(node);
  return is_used(tree, attribute(gradient, "id").value_or(""), users) ||
         std::ranges::any_of(mesh_objects(tree), [&](const MeshObject& object) {
           return object.gradient == gradient &&
                  std::ranges::find(objects, object) == objects.end();
         });
}

/// Puts a gradient in user space where it is for one of its places, and copies for the others: for
/// all of them if the gradient is used as it is, too.
void use_user_units(SvgTree& tree, xmlNode* gradient, const Painted& painted) {
  const auto paint_by_copy = [&](const auto& at_place) {
    const auto& [place, objects] = at_place;
    xmlNode* const copy = add_copy_behind(tree, gradient, objects.front().id + "-mesh");
    set_place(copy, place);
    for (const MeshObject& object : objects) paint_by_gradient(tree, object, copy);
  };
  std::for_each(std::next(painted.begin()), painted.end(), paint_by_copy);
  const auto& [place, objects] = *painted.begin();
  if (is_used_beside(tree, gradient, objects))
    paint_by_copy(*painted.begin());
  else
    set_place(gradient, place);
}

}  // namespace

bool use_user_units(SvgTree& tree, const SvgTree& shown) {
  std::vector<std::pair<xmlNode*, Painted>> all;
  for (const MeshObject& object : mesh_objects(tree)) {
    const std::string place = place_in_user(tree, object, shown);
    if (place.empty()) continue;
    auto known = std::ranges::find(all, object.gradient, &std::pair<xmlNode*, Painted>::first);
    if (known == all.end()) known = all.insert(all.end(), {object.gradient, {}});
    known->second[place].push_back(object);
  }
  for (const auto& [gradient, painted] : all) use_user_units(tree, gradient, painted);
  return !all.empty();
}

}  // namespace gradmesh
