#include "formats/svg/tree/svg_tree.h"

#include <libxml/SAX2.h>
#include <libxml/parser.h>
#include <libxml/valid.h>
#include <libxml/xmlerror.h>
#include <libxml/xmlsave.h>

#include <algorithm>
#include <climits>
#include <new>

#include "base/error.h"
#include "base/limits.h"
#include "formats/svg/values/css_text.h"
#include "formats/svg/xml/node.h"
#include "formats/text/scanner.h"

namespace gradmesh {
namespace {

// No network, and none of XML_PARSE_NOENT, DTDLOAD or DTDATTR: entities stay as they are written
// and no other file is opened. Embedded photos are longer than what libxml2 takes without HUGE.
constexpr int parse_options = XML_PARSE_NONET | XML_PARSE_BIG_LINES | XML_PARSE_HUGE;

const xmlChar* chars(const std::string& text) {
  return reinterpret_cast<const xmlChar*>(text.c_str());
}

/// Catches libxml2's reports on this thread as long as it lives, which otherwise go to stderr, and
/// keeps the first error.
class Reports {
 public:
  Reports() : handler_(xmlStructuredError), context_(xmlStructuredErrorContext) {
    xmlSetStructuredErrorFunc(this, &Reports::take);
  }
  ~Reports() { xmlSetStructuredErrorFunc(context_, handler_); }
  Reports(const Reports&) = delete;
  Reports& operator=(const Reports&) = delete;

  /// Returns what is wrong, in libxml2's own words.
  Message reason() const {
    if (message_.empty()) return Message("libxml2 gives no reason");
    return line_ > 0 ? Message("{0} (line {1})", message_, line_) : Message("{0}", message_);
  }

 private:
#if LIBXML_VERSION >= 21200
  using Error = const xmlError*;
#else
  using Error = xmlError*;
#endif

  static void take(void* self, Error error) {
    Reports& reports = *static_cast<Reports*>(self);
    if (!reports.message_.empty() || error->level != XML_ERR_FATAL || !error->message) return;
    const std::string_view message = trimmed(error->message);
    reports.message_ = message.substr(0, message.find('\n'));
    reports.line_ = error->line;
  }

  xmlStructuredErrorFunc handler_;
  void* context_;
  std::string message_;
  int line_ = 0;
};

using ParserContext = std::unique_ptr<xmlParserCtxt, void (*)(xmlParserCtxt*)>;

/// Sets libxml2's limits once a document declares an entity, as entities could grow without end
/// otherwise.
void limit_from_here(void* context, const xmlChar* name, int type, const xmlChar* public_id,
                     const xmlChar* system_id, xmlChar* content) {
  static_cast<xmlParserCtxt*>(context)->options &= ~XML_PARSE_HUGE;
  xmlSAX2EntityDecl(context, name, type, public_id, system_id, content);
}

/// Refuses documents whose tree is too large: it takes far more memory than the text of many small
/// elements and attributes.
void check_tree_size(std::string_view bytes, const auto& refuse) {
  constexpr std::uint64_t bytes_of_node = 250;
  const auto nodes = std::ranges::count(bytes, '<') + std::ranges::count(bytes, '=');
  const std::uint64_t needed = std::uint64_t(nodes) * bytes_of_node, most = limits().memory;
  if (needed > most)
    refuse(Message("its elements take about {0} bytes, {1}", needed,
                   beyond_limit("memory", most, needed)));
}

/// Parses the bytes. Returns null if they are no XML, which libxml2 reports.
xmlDoc* parse_tree(std::string_view bytes) {
  const ParserContext context(xmlNewParserCtxt(), xmlFreeParserCtxt);
  if (!context) throw std::bad_alloc();
  context->sax->entityDecl = limit_from_here;
  return xmlCtxtReadMemory(context.get(), bytes.data(), int(bytes.size()), nullptr, nullptr,
                           parse_options);
}

/// Returns the largest number of elements inside one another. Works without recursion, as the tree
/// may be as deep as the file is long.
std::size_t nesting(const xmlNode* root) {
  std::size_t depth = 1, deepest = 1;
  for (const xmlNode* node = root;;) {
    if (node->type == XML_ELEMENT_NODE && node->children) {
      node = node->children;
      ++depth;
      if (node->type == XML_ELEMENT_NODE) deepest = std::max(deepest, depth);
      continue;
    }
    while (node != root && !node->next) {
      node = node->parent;
      --depth;
    }
    if (node == root) return deepest;
    node = node->next;
    if (node->type == XML_ELEMENT_NODE) deepest = std::max(deepest, depth);
  }
}

/// Registers the ids of all elements with libxml2, which keeps the register up to date when
/// elements are removed or renamed. Of equal ids the first counts, as in browsers and Inkscape.
void register_ids(const xmlNode* root) {
  for (const xmlNode* node : elements_from(root))
    for (xmlAttr* a : attributes(node)) {
      const bool is_plain = a->children && !a->children->next && a->children->type == XML_TEXT_NODE;
      if (!a->ns && view(a->name) == "id" && is_plain)
        xmlAddID(nullptr, node->doc, a->children->content, a);
    }
}

/// Returns the text with all characters replaced that would mean something else in `url(#id)`, or
/// end Inkscape's reading of it in a style: some signs, and letters from U+0080 to U+00B1.
std::string as_id(std::string_view text) {
  std::string id;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                          (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.' || c == ':' ||
                          static_cast<unsigned char>(c) >= 0x80;
    const bool is_odd = is_odd_letter(text.substr(i));
    id += is_plain && !is_odd ? c : '_';
    if (is_odd) ++i;
  }
  return id;
}

/// Returns the <defs> of an <svg>, in which it is the first element if it was not there.
xmlNode* defs_of(xmlNode* svg) {
  const auto found = child_elements(svg, "defs");
  if (!found.empty()) return found.front();
  xmlNode* defs = add_child(svg, "defs");
  xmlNode* first = svg->children;
  if (first != defs) xmlAddPrevSibling(first, defs);
  return defs;
}

std::string serialized(xmlDoc* document, const char* encoding) {
  const Reports reports;
  const std::unique_ptr<xmlBuffer, void (*)(xmlBuffer*)> buffer(xmlBufferCreate(), xmlBufferFree);
  xmlSaveCtxt* context = xmlSaveToBuffer(buffer.get(), encoding, XML_SAVE_AS_XML);
  const bool saved = context && xmlSaveDoc(context, document) >= 0;
  if (!context || xmlSaveClose(context) < 0 || !saved)
    throw InputError("{0} cannot be written: {1}.", std::string(view(document->URL)),
                     reports.reason());
  return {reinterpret_cast<const char*>(xmlBufferContent(buffer.get())),
          std::size_t(xmlBufferLength(buffer.get()))};
}

}  // namespace

SvgTree::SvgTree(xmlDoc* document) : document_(document) {}

SvgTree SvgTree::parse(std::string_view bytes, const std::string& name) {
  const auto refuse = [&](const Message& reason) {
    throw InputError("{0} is not a readable SVG document: {1}.", name, reason);
  };
  if (bytes.empty()) refuse(Message("it is empty"));
  const std::size_t most = std::min<std::uint64_t>(limits().document, INT_MAX);
  if (bytes.size() > most)
    refuse(Message("it has {0} bytes, {1}", bytes.size(),
                   beyond_limit("document", most, bytes.size())));

  check_tree_size(bytes, refuse);

  const Reports reports;
  SvgTree tree(parse_tree(bytes));
  if (!tree.document_) refuse(reports.reason());
  const std::size_t nested = nesting(tree.root()), deepest = limits().nesting;
  if (nested > deepest)
    refuse(Message("{0} elements lie inside one another, {1}", nested,
                   beyond_limit("nesting", deepest, nested)));
  // The URL of the document is where `fail` finds the file's name.
  xmlDoc* doc = tree.document_.get();
  if (doc->URL) xmlFree(const_cast<xmlChar*>(doc->URL));
  doc->URL = xmlStrdup(chars(name));
  expand_namespaces(tree.root());
  if (svg_name(tree.root()) != "svg") refuse(Message("its outermost element is not <svg>"));
  register_ids(tree.root());
  tree.styles_ = StyleSheet(tree.root());
  return tree;
}

SvgTree SvgTree::copy() const {
  SvgTree tree(xmlCopyDoc(document_.get(), 1));
  if (!tree.document_) throw std::bad_alloc();
  tree.document_->URL = xmlStrdup(document_->URL);
  register_ids(tree.root());
  tree.styles_ = StyleSheet(tree.root());
  return tree;
}

std::string SvgTree::name() const { return std::string(view(document_->URL)); }

xmlNode* SvgTree::root() const { return xmlDocGetRootElement(document_.get()); }

xmlNode* SvgTree::defs() { return defs_of(root()); }

xmlNode* SvgTree::defs_around(const xmlNode* node) {
  xmlNode* svg = parent_element(node);
  while (svg && svg_name(svg) != "svg") svg = parent_element(svg);
  return defs_of(svg ? svg : root());
}

xmlNode* SvgTree::find(std::string_view id) const {
  const xmlAttr* found = xmlGetID(document_.get(), chars(std::string(id)));
  return found ? found->parent : nullptr;
}

void SvgTree::set_id(xmlNode* node, const std::string& id) {
  // libxml2 forgets the old id of the node by itself, and registers only what a DTD declares.
  xmlAddID(nullptr, document_.get(), chars(id), xmlSetProp(node, chars("id"), chars(id)));
}

std::string SvgTree::give_id(xmlNode* node, const std::string& prefix) {
  std::string id;
  do id = as_id(prefix) + std::to_string(next_id_++);
  while (find(id));
  set_id(node, id);
  return id;
}

std::string SvgTree::serialize() const {
  const xmlChar* declared = document_->encoding;
  if (!declared) return serialized(document_.get(), "UTF-8");
  const char* encoding = reinterpret_cast<const char*>(declared);
  const std::string text = serialized(document_.get(), encoding);
  // Where even the brackets are others, as in UTF-7, only what libxml2 itself knows is read again.
  const bool is_known = xmlParseCharEncoding(encoding) != XML_CHAR_ENCODING_ERROR;
  return is_known || text.starts_with('<') ? text : serialized(document_.get(), "UTF-8");
}

}  // namespace gradmesh
