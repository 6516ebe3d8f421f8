#include "io/xml_edit.h"

namespace gradmesh {
namespace {

const xmlChar* chars(const std::string& text) {
  return reinterpret_cast<const xmlChar*>(text.c_str());
}

xmlNs* declare_namespace(xmlNode* node, std::string_view space, const std::string& prefix) {
  const std::string uri(space);
  if (xmlNs* known = xmlSearchNsByHref(node->doc, node, chars(uri)); known && known->prefix)
    return known;
  xmlNode* root = xmlDocGetRootElement(node->doc);
  for (int n = 0;; ++n) {
    const std::string name = n == 0 ? prefix : prefix + std::to_string(n);
    if (!xmlSearchNs(node->doc, node, chars(name))) return xmlNewNs(root, chars(uri), chars(name));
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
