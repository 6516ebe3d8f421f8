#include "io/svg_document.h"

#include <libxml/parser.h>
#include <libxml/valid.h>
#include <libxml/xmlerror.h>
#include <libxml/xmlsave.h>

#include <limits>

#include "base/error.h"
#include "io/atomic_file.h"
#include "io/svg_scanner.h"
#include "io/xml_node.h"

namespace gradmesh {
namespace {

// No network, and none of XML_PARSE_NOENT, DTDLOAD, DTDATTR or HUGE: entities stay as they are
// written, no other file is opened, and libxml2's limits on depth and growth hold.
constexpr int parse_options = XML_PARSE_NONET | XML_PARSE_BIG_LINES;

const xmlChar* chars(const std::string& text) {
  return reinterpret_cast<const xmlChar*>(text.c_str());
}

/// While it lives, takes libxml2's reports on this thread, which otherwise go to stderr, and keeps
/// the first one that is an error.
class Reports {
 public:
  Reports() : handler_(xmlStructuredError), context_(xmlStructuredErrorContext) {
    xmlSetStructuredErrorFunc(this, &Reports::take);
  }
  ~Reports() { xmlSetStructuredErrorFunc(context_, handler_); }
  Reports(const Reports&) = delete;
  Reports& operator=(const Reports&) = delete;

  /// What is wrong, in libxml2's own words.
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

/// Registers the ids of all elements with libxml2, which keeps the register true when elements are
/// removed or renamed. Of equal ids the first counts, as in browsers and Inkscape.
void register_ids(xmlNode* node) {
  for (xmlAttr* a = node->properties; a; a = a->next) {
    const bool is_plain = a->children && !a->children->next && a->children->type == XML_TEXT_NODE;
    if (!a->ns && xmlStrEqual(a->name, chars("id")) && is_plain)
      xmlAddID(nullptr, node->doc, a->children->content, a);
  }
  for (xmlNode* child : child_elements(node)) register_ids(child);
}

}  // namespace

SvgDocument::SvgDocument(xmlDoc* document) : document_(document) {}

SvgDocument SvgDocument::read_file(const std::filesystem::path& path) {
  return parse(read_bytes(path), path.string());
}

SvgDocument SvgDocument::parse(std::string_view bytes, const std::string& name) {
  const auto refuse = [&](const Message& reason) {
    throw InputError("{0} is not a readable SVG document: {1}.", name, reason);
  };
  if (bytes.starts_with("\x1f\x8b")) refuse(Message("it is compressed, save it as plain SVG"));
  if (bytes.empty()) refuse(Message("it is empty"));
  if (bytes.size() > std::size_t(std::numeric_limits<int>::max()))
    refuse(Message("it is larger than 2 GB"));

  const Reports reports;
  SvgDocument document(
      xmlReadMemory(bytes.data(), int(bytes.size()), nullptr, nullptr, parse_options));
  if (!document.document_) refuse(reports.reason());
  if (svg_name(document.root()) != "svg") refuse(Message("its outermost element is not <svg>"));

  // The URL of the document is where `fail` finds the file's name.
  xmlDoc* doc = document.document_.get();
  if (doc->URL) xmlFree(const_cast<xmlChar*>(doc->URL));
  doc->URL = xmlStrdup(chars(name));
  register_ids(document.root());
  document.styles_ = StyleSheet(document.root());
  return document;
}

xmlNode* SvgDocument::root() const { return xmlDocGetRootElement(document_.get()); }

xmlNode* SvgDocument::find(std::string_view id) const {
  const xmlAttr* found = xmlGetID(document_.get(), chars(std::string(id)));
  return found ? found->parent : nullptr;
}

void SvgDocument::set_id(xmlNode* node, const std::string& id) {
  // libxml2 forgets the old id of the node by itself, and registers only what a DTD declares.
  xmlAddID(nullptr, document_.get(), chars(id), xmlSetProp(node, chars("id"), chars(id)));
}

std::string SvgDocument::give_id(xmlNode* node, const std::string& prefix) {
  std::string id;
  do id = prefix + std::to_string(next_id_++);
  while (find(id));
  set_id(node, id);
  return id;
}

std::string SvgDocument::serialize() const {
  const Reports reports;
  const xmlChar* declared = document_->encoding;
  const char* encoding = declared ? reinterpret_cast<const char*>(declared) : "UTF-8";
  const std::unique_ptr<xmlBuffer, void (*)(xmlBuffer*)> buffer(xmlBufferCreate(), xmlBufferFree);
  xmlSaveCtxt* context = xmlSaveToBuffer(buffer.get(), encoding, XML_SAVE_AS_XML);
  const bool saved = context && xmlSaveDoc(context, document_.get()) >= 0;
  if (!context || xmlSaveClose(context) < 0 || !saved)
    throw InputError("{0} cannot be written: {1}.", reinterpret_cast<const char*>(document_->URL),
                     reports.reason());
  return {reinterpret_cast<const char*>(xmlBufferContent(buffer.get())),
          std::size_t(xmlBufferLength(buffer.get()))};
}

void SvgDocument::write_file(const std::filesystem::path& path) const {
  write_bytes(path, serialize());
}

}  // namespace gradmesh
