#pragma once

#include <libxml/tree.h>

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace gradmesh {

/// Property names (lower case) and their values, as of a `style` attribute; the last of equal names
/// counts. `!important` and declarations without a name are left out, open quotes are closed.
using Declarations = std::map<std::string, std::string, std::less<>>;
Declarations parse_declarations(std::string_view text);

/// The rules of a document's <style> elements whose selectors are `element`, `.class`, `#id` or a
/// comma list of these. All other rules, such as those in @media, are ignored.
class StyleSheet {
 public:
  StyleSheet() = default;
  /// Reads all <style> elements below `root`.
  explicit StyleSheet(const xmlNode* root);

  /// Returns true if there are no rules.
  bool is_empty() const { return rules_.empty(); }

  /// Returns the property's value on this element alone: from the `style` attribute, else from a
  /// rule, else from the presentation attribute. `inherit` is returned as such. As in Inkscape a
  /// value that `accepts` refuses is ignored: in the `style` attribute the value before it counts,
  /// but of rules only the last is tried.
  using Accepts = bool (*)(std::string_view value);
  std::optional<std::string> declared(const xmlNode* node, std::string_view property,
                                      Accepts accepts = nullptr) const;

  /// Returns the property's value on this element or, if that is absent or `inherit`, on the
  /// nearest ancestor with a value: for properties that CSS inherits, such as `fill` and `color`.
  std::optional<std::string> inherited(const xmlNode* node, std::string_view property) const;

 private:
  struct Declaration {
    std::string value;
    int order = 0;
  };

  void read_below(const xmlNode* node);
  void add_rules(std::string_view css);
  void add_rule(std::string_view selectors, std::string_view body);
  const Declaration* find(const std::string& selector, std::string_view property) const;
  std::optional<std::string> from_rules(const xmlNode* node, std::string_view property) const;

  /// By selector (`path`, `.class`, `#id`), then by property.
  std::map<std::string, std::map<std::string, Declaration, std::less<>>, std::less<>> rules_;
  int count_ = 0;
};

}  // namespace gradmesh
