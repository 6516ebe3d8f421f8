#include "formats/svg/xml/node.h"

#include "base/error.h"
#include "formats/text/excerpt.h"

namespace gradmesh {
namespace {

// Enough for the style snippets that drawing programs put into entities; a document that repeats
// a larger one in every attribute is an attack.
constexpr std::size_t longest_entity = 10000;

std::string_view view(const xmlChar* text) {
  return text ? std::string_view(reinterpret_cast<const char*>(text)) : std::string_view();
}

const xmlChar* chars(const char* text) { return reinterpret_cast<const xmlChar*>(text); }

std::string_view entity_text(const xmlNode* reference, const xmlNode* owner) {
  const xmlEntity* entity = xmlGetDocEntity(reference->doc, reference->name);
  const bool internal = entity && (entity->etype == XML_INTERNAL_GENERAL_ENTITY ||
                                   entity->etype == XML_INTERNAL_PREDEFINED_ENTITY);
  const std::string_view content = internal ? view(entity->content) : std::string_view();
  const bool predefined = internal && entity->etype == XML_INTERNAL_PREDEFINED_ENTITY;
  const bool plain =
      content.size() <= longest_entity && content.find_first_of("&<") == content.npos;
  if (!internal || !(predefined || plain))
    fail(owner,
         Message("the entity {0} is not a short plain text", excerpt(view(reference->name))));
  return content;
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

std::string text_of(const xmlNode* children, const xmlNode* owner) {
  std::string text;
  for (const xmlNode* child = children; child; child = child->next) {
    if (child->type == XML_TEXT_NODE || child->type == XML_CDATA_SECTION_NODE)
      text += view(child->content);
    else if (child->type == XML_ENTITY_REF_NODE)
      text += entity_text(child, owner);
  }
  return text;
}

std::optional<std::string> attribute(const xmlNode* node, const char* name,
                                     std::string_view space) {
  const std::string uri(space);
  const xmlAttr* found = space.empty() ? xmlHasNsProp(node, chars(name), nullptr)
                                       : xmlHasNsProp(node, chars(name), chars(uri.c_str()));
  // A default from the document's own DTD is returned as a declaration, which has no value here.
  if (!found || found->type != XML_ATTRIBUTE_NODE) return std::nullopt;
  return text_of(found->children, node);
}

Message describe(const xmlNode* node) {
  std::string name(view(node->name));
  for (const xmlAttr* a = node->properties; a; a = a->next)
    if (!a->ns && view(a->name) == "id" && a->children && a->children->type == XML_TEXT_NODE)
      return Message("{0} {1}", name, excerpt(view(a->children->content)));
  return Message("{0} in line {1}", name, xmlGetLineNo(const_cast<xmlNode*>(node)));
}

void fail(const xmlNode* node, const Message& reason) {
  const std::string_view file = node->doc ? view(node->doc->URL) : std::string_view();
  throw InputError("{0}: {1}: {2}.", std::string(file), describe(node), reason);
}

}  // namespace gradmesh
