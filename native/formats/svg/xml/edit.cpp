#include "formats/svg/xml/edit.h"

#include "formats/svg/xml/node.h"

namespace gradmesh {
namespace {

const xmlChar* chars(const std::string& text) {
  return reinterpret_cast<const xmlChar*>(text.c_str());
}

/// Returns true if an element or attribute has the prefix although no namespace was declared for
/// it: a declaration further up would change its meaning.
bool has_undeclared(const xmlNode* node, const std::string& prefix) {
  const auto has_prefix = [&](const xmlChar* name, const xmlNs* ns) {
    return !ns && std::string_view(reinterpret_cast<const char*>(name)).starts_with(prefix + ":");
  };
  if (has_prefix(node->name, node->ns)) return true;
  for (const xmlAttr* a = node->properties; a; a = a->next)
    if (has_prefix(a->name, a->ns)) return true;
  for (const xmlNode* child : child_elements(node))
    if (has_undeclared(child, prefix)) return true;
  return false;
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

}  // namespace gradmesh
