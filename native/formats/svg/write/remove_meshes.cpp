#include "formats/svg/write/remove_meshes.h"

#include <algorithm>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "formats/svg/read/objects.h"
#include "formats/svg/read/paint.h"
#include "formats/svg/read/read_group.h"
#include "formats/svg/read/read_mesh.h"
#include "formats/svg/values/mesh_names.h"
#include "formats/svg/xml/edit.h"
#include "formats/svg/xml/node.h"

namespace gradmesh {
namespace {

/// Calls `visit` for the element and all below it, from the outside in.
void for_each_element(xmlNode* node, const std::function<void(xmlNode*)>& visit) {
  visit(node);
  for (xmlNode* child : child_elements(node)) for_each_element(child, visit);
}

/// Returns the elements for which `is_wanted` returns true.
std::vector<xmlNode*> elements(const SvgDocument& document,
                               const std::function<bool(const xmlNode*)>& is_wanted) {
  std::vector<xmlNode*> found;
  for_each_element(document.root(), [&](xmlNode* node) {
    if (is_wanted(node)) found.push_back(node);
  });
  return found;
}

/// Gives what names one of these gradients the colour that stands in for it.
void replace_paints(SvgDocument& document, const std::vector<const xmlNode*>& gradients) {
  for_each_element(document.root(), [&](xmlNode* node) {
    for (const char* property : {"fill", "stroke"}) {
      const auto paint = document.styles().declared(node, property);
      const xmlNode* gradient = paint ? referenced_mesh(document, *paint) : nullptr;
      if (!gradient || std::ranges::find(gradients, gradient) == gradients.end()) continue;
      const std::string fallback = fallback_color(*paint);
      set_style(node, property, fallback.empty() ? "none" : fallback);
    }
  });
}

/// Returns rules with the paints that name this id replaced likewise.
std::string without_paint(std::string css, const std::string& id) {
  for (std::size_t at = 0; (at = css.find("url(", at)) != css.npos;) {
    const std::size_t end = std::min(css.find_first_of(";}", at), css.size());
    const std::string_view paint = std::string_view(css).substr(at, end - at);
    if (referenced_id(paint) != id) {
      ++at;
      continue;
    }
    const std::string fallback = fallback_color(paint);
    css.replace(at, end - at,
                fallback.empty() || fallback.front() == '!' ? "none" + fallback : fallback);
  }
  return css;
}

void replace_paints_in_rules(SvgDocument& document, const std::vector<const xmlNode*>& gradients) {
  for_each_element(document.root(), [&](xmlNode* node) {
    if (svg_name(node) != "style") return;
    for (xmlNode* text = node->children; text; text = text->next) {
      if (text->type != XML_TEXT_NODE && text->type != XML_CDATA_SECTION_NODE) continue;
      const std::string css = reinterpret_cast<const char*>(text->content);
      std::string changed = css;
      for (const xmlNode* gradient : gradients)
        changed = without_paint(changed, attribute(gradient, "id").value_or(""));
      if (changed != css)
        xmlNodeSetContent(text, reinterpret_cast<const xmlChar*>(changed.c_str()));
    }
  });
}

void remove_unused_gradients(SvgDocument& document) {
  const auto unused = unused_mesh_gradients(document, mesh_objects(document));
  replace_paints(document, unused);
  replace_paints_in_rules(document, unused);
  // Those that give others their rows become unused after these.
  for (bool goes_on = true; goes_on;) {
    goes_on = false;
    for (xmlNode* gradient : elements(document, is_mesh_gradient)) {
      if (is_used(document, attribute(gradient, "id").value_or(""))) continue;
      remove_node(gradient);
      goes_on = true;
      break;
    }
  }
}

bool is_polyfill(const xmlNode* node) {
  return svg_name(node) == "script" &&
         attribute(node, "id").value_or("").starts_with("mesh_polyfill");
}

bool is_ours(const xmlNs* space) {
  return space && space->href && reinterpret_cast<const char*>(space->href) == gradmesh_namespace;
}

/// Takes our attributes away, and the declarations of our namespace.
void remove_own_namespace(SvgDocument& document) {
  for_each_element(document.root(), [](xmlNode* node) {
    for (xmlAttr* a = node->properties; a;) {
      xmlAttr* next = a->next;
      if (is_ours(a->ns)) xmlRemoveProp(a);
      a = next;
    }
  });
  const auto is_element_of_ours = [](const xmlNode* node) { return is_ours(node->ns); };
  if (!elements(document, is_element_of_ours).empty()) return;
  for_each_element(document.root(), [](xmlNode* node) {
    for (xmlNs** at = &node->nsDef; *at;) {
      if (!is_ours(*at)) {
        at = &(*at)->next;
        continue;
      }
      xmlNs* gone = *at;
      *at = gone->next;
      xmlFreeNs(gone);
    }
  });
}

}  // namespace

void remove_hidden_originals(SvgDocument& document) {
  for (xmlNode* node : elements(document, [](const xmlNode* element) {
         return attribute(element, "kept-for", gradmesh_namespace).has_value();
       }))
    remove_node(node);
}

void remove_meshes(SvgDocument& document) {
  for (xmlNode* script : elements(document, is_polyfill)) remove_node(script);
  remove_unused_gradients(document);
  remove_own_namespace(document);
}

}  // namespace gradmesh
