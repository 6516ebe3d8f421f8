#include "formats/svg/xml/node.h"

#include <algorithm>

#include "base/error.h"
#include "formats/text/excerpt.h"

namespace gradmesh {
namespace {

// Enough for the style snippets that drawing programs put into entities; a document that repeats
// a larger one in every attribute is an attack.
constexpr std::size_t longest_entity = 10000;

const xmlChar* chars(const char* text) { return reinterpret_cast<const xmlChar*>(text); }
const xmlChar* chars(const std::string& text) { return chars(text.c_str()); }

/// Returns what the entity of this name stands for. Throws InputError about `owner` unless it is
/// short and plain.
std::string_view entity_text(const xmlChar* name, const xmlNode* owner) {
  const xmlEntity* entity = xmlGetDocEntity(owner->doc, name);
  const bool internal = entity && (entity->etype == XML_INTERNAL_GENERAL_ENTITY ||
                                   entity->etype == XML_INTERNAL_PREDEFINED_ENTITY);
  const std::string_view content = internal ? view(entity->content) : std::string_view();
  const bool predefined = internal && entity->etype == XML_INTERNAL_PREDEFINED_ENTITY;
  const bool plain =
      content.size() <= longest_entity && content.find_first_of("&<") == content.npos;
  if (!internal || !(predefined || plain))
    fail(owner, Message("the entity {0} is not a short plain text", excerpt(view(name))));
  return content;
}

/// Returns the text with its references to entities, such as `&svg;`, replaced by their texts.
std::string expanded(std::string_view text, const xmlNode* owner) {
  std::string result;
  while (!text.empty()) {
    const std::size_t end = text.starts_with('&') ? text.find(';') : text.npos;
    if (end == text.npos) {
      result += text.front();
      text.remove_prefix(1);
    } else {
      result += entity_text(chars(std::string(text.substr(1, end - 1))), owner);
      text.remove_prefix(end + 1);
    }
  }
  return result;
}

/// Returns true if an element or attribute has the prefix although no namespace was declared for
/// it: a declaration further up would change its meaning.
bool has_undeclared(const xmlNode* root, const std::string& prefix) {
  const auto has_prefix = [&](const auto* named) {
    return !named->ns && view(named->name).starts_with(prefix + ":");
  };
  return std::ranges::any_of(elements_from(root), [&](const xmlNode* node) {
    return has_prefix(node) || std::ranges::any_of(attributes(node), has_prefix);
  });
}

xmlNs* declare_namespace(xmlNode* node, std::string_view space, const std::string& prefix) {
  const std::string uri(space);
  // A prefix with a colon is none, although libxml2 lets it pass.
  if (xmlNs* known = xmlSearchNsByHref(node->doc, node, chars(uri));
      known && known->prefix && !xmlStrchr(known->prefix, ':'))
    return known;
  xmlNode* root = xmlDocGetRootElement(node->doc);
  for (int n = 0;; ++n) {
    const std::string name = n == 0 ? prefix : prefix + std::to_string(n);
    xmlNs* const found = xmlSearchNs(node->doc, node, chars(name));
    if (found && xmlStrEqual(found->href, chars(uri))) return found;
    if (!found && !has_undeclared(root, name)) return xmlNewNs(root, chars(uri), chars(name));
  }
}

}  // namespace

std::string_view svg_name(const xmlNode* node) {
  if (node->type != XML_ELEMENT_NODE) return {};
  if (node->ns && view(node->ns->href) != svg_namespace) return {};
  return view(node->name);
}

xmlNode* parent_element(const xmlNode* node) {
  return node->parent && node->parent->type == XML_ELEMENT_NODE ? node->parent : nullptr;
}

std::vector<xmlNode*> child_elements(const xmlNode* node, std::string_view name) {
  std::vector<xmlNode*> elements;
  for (xmlNode* child = node->children; child; child = child->next)
    if (child->type == XML_ELEMENT_NODE && (name.empty() || svg_name(child) == name))
      elements.push_back(child);
  return elements;
}

std::vector<xmlNode*> elements_from(const xmlNode* node) {
  std::vector<xmlNode*> elements;
  const auto add = [&](const auto& self, xmlNode* element) -> void {
    elements.push_back(element);
    for (xmlNode* child : child_elements(element)) self(self, child);
  };
  add(add, const_cast<xmlNode*>(node));
  return elements;
}

std::vector<xmlAttr*> attributes(const xmlNode* node) {
  std::vector<xmlAttr*> list;
  for (xmlAttr* a = node->properties; a; a = a->next) list.push_back(a);
  return list;
}

void expand_namespaces(xmlNode* root) {
  for (xmlNode* node : elements_from(root))
    for (xmlNs* space = node->nsDef; space; space = space->next) {
      if (view(space->href).find('&') == std::string_view::npos) continue;
      const std::string uri = expanded(view(space->href), node);
      xmlFree(const_cast<xmlChar*>(space->href));
      space->href = xmlStrdup(chars(uri));
    }
}

std::string_view view(const xmlChar* text) {
  return text ? std::string_view(reinterpret_cast<const char*>(text)) : std::string_view();
}

std::string text_of(const xmlNode* children, const xmlNode* owner) {
  std::string text;
  for (const xmlNode* child = children; child; child = child->next) {
    if (child->type == XML_TEXT_NODE || child->type == XML_CDATA_SECTION_NODE)
      text += view(child->content);
    else if (child->type == XML_ENTITY_REF_NODE)
      text += entity_text(child->name, owner);
  }
  return text;
}

std::optional<std::string> attribute(const xmlNode* node, const char* name,
                                     std::string_view space) {
  const std::string uri(space);
  const xmlAttr* found = xmlHasNsProp(node, chars(name), space.empty() ? nullptr : chars(uri));
  // A default from the document's own DTD is returned as a declaration, which has no value here.
  if (!found || found->type != XML_ATTRIBUTE_NODE) return std::nullopt;
  return text_of(found->children, node);
}

std::string href(const xmlNode* node) {
  return attribute(node, "href", xlink_namespace).value_or("");
}

namespace {

/// Returns what a person calls an element of this name.
Message kind_of(std::string_view name) {
  if (name == "g") return Message("group");
  if (name == "rect") return Message("rectangle");
  if (name == "use") return Message("clone");
  return Message("{0}", std::string(name));
}

}  // namespace

Message describe(const xmlNode* node) {
  const Message name = kind_of(view(node->name));
  for (const xmlAttr* a : attributes(node))
    if (!a->ns && view(a->name) == "id" && a->children && a->children->type == XML_TEXT_NODE)
      return Message("{0} {1}", name, excerpt(view(a->children->content)));
  return Message("{0} in line {1}", name, xmlGetLineNo(const_cast<xmlNode*>(node)));
}

void fail(const xmlNode* node, const Message& reason) {
  const std::string_view file = node->doc ? view(node->doc->URL) : std::string_view();
  throw InputError("{0}: {1}: {2}.", std::string(file), describe(node), reason);
}

xmlNode* add_child(xmlNode* parent, const char* name) {
  return xmlNewChild(parent, parent->ns, chars(name), nullptr);
}

xmlNode* add_copy(xmlNode* parent, const xmlNode* node) {
  xmlNode* copy = xmlDocCopyNode(const_cast<xmlNode*>(node), parent->doc, 1);
  xmlAddChild(parent, copy);
  // It was made apart from the document, so that it declares every namespace itself; those that
  // the document knows anyway are removed (XML_DOM_RECONNS_REMOVEREDUND, which no header names).
  xmlDOMWrapReconcileNamespaces(nullptr, copy, 1);
  return copy;
}

void set_attribute(xmlNode* node, const char* name, const std::string& value) {
  xmlSetNsProp(node, nullptr, chars(name), chars(value));
}

void set_attribute(xmlNode* node, const char* name, const std::string& value,
                   std::string_view space, const char* prefix) {
  xmlSetNsProp(node, declare_namespace(node, space, prefix), chars(name), chars(value));
}

void set_name(xmlNode* node, const char* name) { xmlNodeSetName(node, chars(name)); }

void remove_attribute(xmlNode* node, const char* name) {
  xmlUnsetNsProp(node, nullptr, chars(name));
}

void remove_attribute(xmlNode* node, const char* name, std::string_view space) {
  if (xmlNs* known = xmlSearchNsByHref(node->doc, node, chars(std::string(space))))
    xmlUnsetNsProp(node, known, chars(name));
}

void remove_node(xmlNode* node) {
  xmlUnlinkNode(node);
  xmlFreeNode(node);
}

void remove_elements(xmlNode* root, const std::function<bool(const xmlNode*)>& is_unwanted) {
  // From the inside out, as an element takes those inside it along.
  std::vector<xmlNode*> elements = elements_from(root);
  std::ranges::reverse(elements);
  for (xmlNode* node : elements)
    if (node != root && is_unwanted(node)) remove_node(node);
}

}  // namespace gradmesh
