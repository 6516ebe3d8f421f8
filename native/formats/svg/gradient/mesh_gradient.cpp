#include "formats/svg/gradient/mesh_gradient.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <optional>
#include <set>

#include "base/limits.h"
#include "formats/svg/gradient/rows.h"
#include "formats/svg/gradient/written_gradient.h"
#include "formats/svg/tree/own.h"
#include "formats/svg/tree/paint.h"
#include "formats/svg/tree/unused.h"
#include "formats/svg/values/length.h"
#include "formats/svg/values/mesh_names.h"
#include "formats/svg/values/reference.h"
#include "formats/svg/values/shape.h"
#include "formats/svg/values/transform.h"
#include "formats/svg/xml/node.h"
#include "formats/text/excerpt.h"
#include "formats/text/scanner.h"
#include "mesh/boundary.h"

namespace gradmesh {
namespace {

/// A gradient and the gradients that its href leads to, in this order.
struct HrefChain {
  std::vector<const xmlNode*> gradients;
  /// Why the last href leads to no gradient; nothing if there is no such href. Inkscape ignores the
  /// href.
  std::optional<Message> broken;
  /// True if one of them has an href to a gradient that only some versions of Inkscape follow.
  bool has_plain = false;
};

/// Returns true if the element leads to a gradient by an `href` that is no `xlink:href` as well:
/// Inkscape 1.2 does not follow it, later versions do.
bool leads_by_plain_href(const SvgTree& tree, const xmlNode* node) {
  const std::string plain = attribute(node, "href").value_or("");
  const xmlNode* const linked = tree.find(linked_id(plain, tree.name()).value_or(""));
  return linked && is_gradient(linked) && plain != href(node);
}

HrefChain href_chain(const SvgTree& tree, const xmlNode* gradient) {
  HrefChain chain;
  std::set<const xmlNode*> seen;
  for (const xmlNode* node = gradient; node;) {
    if (!seen.insert(node).second) {
      chain.broken = Message("its href leads back to itself");
      break;
    }
    chain.gradients.push_back(node);
    chain.has_plain = chain.has_plain || leads_by_plain_href(tree, node);
    const std::string target = href(node);
    if (target.empty()) break;
    node = tree.find(linked_id(target, tree.name()).value_or(""));
    if (!node)
      chain.broken = Message("its href {0} leads nowhere in this document", excerpt(target));
    else if (!is_gradient(node))
      chain.broken = Message("its href {0} does not lead to a gradient", excerpt(target));
    if (chain.broken) break;
  }
  return chain;
}

/// Returns the first of them that has rows; null if none has.
const xmlNode* rows_holder(const HrefChain& chain) {
  const auto holder = std::ranges::find_if(chain.gradients, [](const xmlNode* node) {
    return is_mesh_gradient(node) && !mesh_rows(node).empty();
  });
  return holder != chain.gradients.end() ? *holder : nullptr;
}

bool uses_bounding_box(const HrefChain& chain) {
  for (const xmlNode* node : chain.gradients)
    if (const auto units = attribute(node, "gradientUnits")) return *units != "userSpaceOnUse";
  return true;
}

}  // namespace

std::vector<const xmlNode*> gradient_chain(const SvgTree& tree, const xmlNode* gradient) {
  return href_chain(tree, gradient).gradients;
}

bool uses_bounding_box(const SvgTree& tree, const xmlNode* gradient) {
  return uses_bounding_box(href_chain(tree, gradient));
}

Affine gradient_to_user(const SvgTree& tree, const MeshObject& object) {
  Affine to_user;
  if (const auto text = attribute(object.gradient, "gradientTransform")) {
    const auto transform = parse_transform(*text);
    if (!transform)
      fail(object.gradient, Message("its gradientTransform {0} is malformed", excerpt(*text)));
    to_user = *transform;
  }
  if (uses_bounding_box(tree, object.gradient)) {
    const auto box = shape_box(object.node);
    if (!box)
      fail(object.node, Message("its mesh is placed by its bounding box (objectBoundingBox), "
                                "which is known for shapes only"));
    if (box->empty() || box->size().x == 0 || box->size().y == 0)
      fail(object.node, Message("its mesh is placed by its bounding box (objectBoundingBox), "
                                "which has no width or no height"));
    to_user = Affine::translation(box->low()) * Affine::scaling(box->size()) * to_user;
  }
  // A determinant this small against the entries is zero but for rounding.
  const glm::dmat2& m = to_user.linear;
  if (std::abs(to_user.determinant()) <= 1e-14 * (glm::dot(m[0], m[0]) + glm::dot(m[1], m[1])))
    fail(object.gradient, Message("its gradientTransform flattens the mesh to a line"));
  return to_user;
}

namespace {

/// Adds a gradient beside the old one, equal to it but for its rows, which the old one may have by
/// href.
xmlNode* add_gradient(SvgTree& tree, const MeshObject& object) {
  xmlNode* old = object.gradient;
  xmlNode* gradient = add_copy(parent_element(old), old);
  while (gradient->children) remove_node(gradient->children);
  set_name(gradient, mesh_gradient_name);
  xmlAddNextSibling(old, gradient);
  tree.give_id(gradient, object.id + "-mesh");
  remove_attribute(gradient, "href");
  remove_attribute(gradient, "href", xlink_namespace);
  set_attribute(gradient, "gradientUnits",
                uses_bounding_box(tree, old) ? "objectBoundingBox" : "userSpaceOnUse");
  return gradient;
}

/// Returns true if two elements are the same but for ids.
bool are_same(const xmlNode* a, const xmlNode* b) {
  const auto said = [](const xmlNode* node) {
    std::map<std::string_view, std::string> values;
    for (const xmlAttr* at : attributes(node))
      if (at->ns || view(at->name) != "id") values[view(at->name)] = text_of(at->children, node);
    return values;
  };
  return view(a->name) == view(b->name) && said(a) == said(b) &&
         std::ranges::equal(child_elements(a), child_elements(b), are_same);
}

/// Returns the gradient itself or, removing it, one among `others` that is the same.
xmlNode* shared(xmlNode* gradient, std::vector<xmlNode*>& others) {
  for (xmlNode* other : others)
    if (are_same(other, gradient)) {
      remove_node(gradient);
      return other;
    }
  others.push_back(gradient);
  return gradient;
}

/// Refuses a gradient that rules, such as one for all elements, paint by a mesh: it may lead back
/// to itself, of which Inkscape makes nothing, or does not end.
void check_unpainted(const SvgTree& tree, const xmlNode* gradient) {
  for (const char* property : {"fill", "stroke"})
    if (referenced_mesh(tree, tree.styles().declared(gradient, property)))
      fail(gradient, Message("a rule, such as one for all elements, paints the gradient itself"));
}

}  // namespace

bool is_smooth(const xmlNode* gradient) { return attribute(gradient, "type") == "bicubic"; }

const xmlNode* rows_holder(const SvgTree& tree, const xmlNode* gradient) {
  return rows_holder(href_chain(tree, gradient));
}

PatchGrid gradient_patches(const SvgTree& tree, const xmlNode* gradient) {
  const HrefChain chain = href_chain(tree, gradient);
  const std::size_t most = limits().links, count = chain.gradients.size();
  if (count > most)
    fail(gradient, Message("{0} gradients refer to one another, {1}", count,
                           beyond_limit("links", most, count)));
  if (chain.has_plain)
    fail(gradient, Message("its href without xlink: is followed by some versions of Inkscape and "
                           "not by others"));
  const xmlNode* const holder = rows_holder(chain);
  if (!holder) {
    if (chain.broken) fail(gradient, *chain.broken);
    fail(gradient, Message("it has no meshrow"));
  }
  // Inkscape takes a percentage for a fraction of one unit, whatever the units are.
  const glm::dvec2 start(read_box_length(gradient, "x"), read_box_length(gradient, "y"));
  return read_rows(tree.styles(), holder, start);
}

PatchGrid read_mesh_gradient(const SvgTree& tree, const xmlNode* gradient) {
  if (is_smooth(gradient))
    fail(gradient, Message("its type \"bicubic\" is not supported here, where a mesh has several "
                           "gradients"));
  return gradient_patches(tree, gradient);
}

PatchGrid read_mesh_patches(const SvgTree& tree, const MeshObject& object) {
  check_can_change(object);
  check_unpainted(tree, object.gradient);
  PatchGrid grid = gradient_patches(tree, object.gradient), in_user = grid;
  const Affine to_user = gradient_to_user(tree, object);
  for (Patch& patch : in_user.patches) transform(patch, to_user);
  check_limits(in_user, object.gradient);
  return is_smooth(object.gradient) ? grid : in_user;
}

MeshParts read_mesh(const SvgTree& tree, const MeshObject& object) {
  MeshParts parts = parts_of({read_mesh_patches(tree, object)});
  parts.smooth = is_smooth(object.gradient);
  return parts;
}

Affine mesh_to_user(const SvgTree& tree, const MeshObject& object) {
  return !object.is_group() && is_smooth(object.gradient) ? gradient_to_user(tree, object)
                                                          : Affine();
}

Affine mesh_to_gradient(const SvgTree& tree, const MeshObject& object) {
  return is_smooth(object.gradient) ? Affine() : gradient_to_user(tree, object).inverse();
}

std::vector<const xmlNode*> unused_mesh_gradients(const SvgTree& tree,
                                                  const std::vector<MeshObject>& objects) {
  std::vector<const xmlNode*> gradients;
  std::set<const xmlNode*> used;
  const auto use = [&](const xmlNode* gradient) {
    if (!gradient) return;
    for (const xmlNode* node : href_chain(tree, gradient).gradients) used.insert(node);
  };
  for (const MeshObject& object : objects) use(object.gradient);
  for (const xmlNode* node : elements_from(tree.root())) {
    if (is_mesh_gradient(node) && !mesh_rows(node).empty()) gradients.push_back(node);
    // Shapes and texts that are painted are among the objects, but blocks and parts of texts are
    // not.
    const bool is_object = can_paint(node, PaintRole::stroke) && !is_block(node);
    if (!is_object && !hands_paint_on(node))
      for (const char* property : {"fill", "stroke"})
        use(referenced_mesh(tree, tree.styles().declared(node, property)));
  }
  std::erase_if(gradients, [&](const xmlNode* node) { return used.contains(node); });
  return gradients;
}

std::vector<UnusedGradient> unused_gradients(const SvgTree& tree,
                                             const std::vector<MeshObject>& objects) {
  std::vector<UnusedGradient> list;
  for (const xmlNode* gradient : unused_mesh_gradients(tree, objects)) {
    UnusedGradient& unused = list.emplace_back();
    unused.id = attribute(gradient, "id").value_or("");
    for (const xmlNode* row : mesh_rows(gradient)) unused.patches += int(mesh_patches(row).size());
  }
  return list;
}

void write_grid(const SvgTree& tree, xmlNode* gradient, const Mesh& mesh, double coons_tolerance,
                const Affine& to_gradient, const ColorTexts& texts) {
  const BlockForm form = gradient_form(mesh, coons_tolerance, to_gradient);
  write_rows(gradient, mesh, form.blocks.front(),
             {.precision = form.precision,
              .in_style = !tree.styles().is_empty(),
              .is_important = tree.styles().has_important(),
              .rounding = form.precision.last_bits > 0
                              ? no_rounding
                              : rounding_within(bounding_box(mesh, form.precision.to_written)),
              .is_relative = form.precision.step > 0 && form.precision.last_bits == 0,
              .texts = &texts});
}

MeshObject write_mesh_gradient(SvgTree& tree, const MeshObject& object, const Mesh& mesh,
                               double coons_tolerance, GradientsByOrigin* by_origin) {
  return write_mesh_gradient(tree, object, mesh, coons_tolerance, color_texts(tree, object),
                             by_origin);
}

MeshObject write_mesh_gradient(SvgTree& tree, const MeshObject& object, const Mesh& mesh,
                               double coons_tolerance, const ColorTexts& texts,
                               GradientsByOrigin* by_origin) {
  xmlNode* gradient = add_gradient(tree, object);
  write_grid(tree, gradient, mesh, coons_tolerance, mesh_to_gradient(tree, object), texts);
  forget_original(object);
  const std::string old = attribute(object.gradient, "id").value_or("");
  if (by_origin) gradient = shared(gradient, (*by_origin)[old]);
  paint_by_gradient(tree, object, gradient);
  remove_if_unused(tree, old);
  return {object.node, object.id, object.role, gradient, object.kept, object.left_alone};
}

void paint_by_gradient(const SvgTree& tree, const MeshObject& object, const xmlNode* gradient) {
  const char* property = paint_name(object.role);
  const std::string fallback =
      fallback_color(tree.styles().inherited(object.node, property).value_or(""));
  const std::string paint = paint_by(attribute(gradient, "id").value_or(""), fallback);
  const bool is_inherited =
      tree.styles().declared(object.node, property).value_or("inherit") == "inherit";
  set_paint(tree.styles(), object.node, property, paint);
  if (is_inherited) hand_back_paint(tree.styles(), object.node, property, paint);
}

}  // namespace gradmesh
