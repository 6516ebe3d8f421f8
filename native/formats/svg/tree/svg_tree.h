#pragma once

#include <libxml/tree.h>

#include <memory>
#include <string>
#include <string_view>

#include "formats/svg/values/style.h"

namespace gradmesh {

/// An SVG document as a tree of libxml2, with all of its contents: comments, CDATA, foreign
/// namespaces, doctype. Nothing outside the document is ever loaded and entities stay references.
/// Messages about the document begin with its name.
class SvgTree {
 public:
  /// Parses bytes in any encoding that XML declares. `name` is the file's name in messages. Throws
  /// InputError if they are no SVG document.
  static SvgTree parse(std::string_view bytes, const std::string& name);

  /// Returns another tree of the same content.
  SvgTree copy() const;

  /// Returns the document's name in messages.
  std::string name() const;
  xmlNode* root() const;
  const StyleSheet& styles() const { return styles_; }

  /// Returns the first <defs> of the outermost <svg>, which is added if there is none.
  xmlNode* defs();
  /// Returns the <defs> of the <svg> around the element, to whose viewport shares such as `30%`
  /// refer; adds one if there is none.
  xmlNode* defs_around(const xmlNode* node);

  /// Returns the first element with this id; null if there is none.
  xmlNode* find(std::string_view id) const;
  /// Gives the element this id, which no other element may have.
  void set_id(xmlNode* node, const std::string& id);
  /// Gives the element an id that no other element has, and returns it: `prefix` and a number, with
  /// characters replaced that cannot stand in `url(#id)`, such as a bracket in another object's id.
  std::string give_id(xmlNode* node, const std::string& prefix);

  /// Returns the document's text in its own encoding; in UTF-8 if it declares none, or one that
  /// could not be read again.
  std::string serialize() const;

 private:
  struct FreeDocument {
    void operator()(xmlDoc* document) const { xmlFreeDoc(document); }
  };

  explicit SvgTree(xmlDoc* document);

  std::unique_ptr<xmlDoc, FreeDocument> document_;
  StyleSheet styles_;
  int next_id_ = 1;
};

}  // namespace gradmesh
