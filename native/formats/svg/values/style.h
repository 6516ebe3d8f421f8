#pragma once

#include <libxml/tree.h>

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "formats/svg/values/rules.h"
#include "formats/svg/values/selector.h"

namespace gradmesh {

/// Property names and their values, as of a `style` attribute; the last of equal names counts, of
/// those with `!important` if there are any, whose values end in `important_mark`. Declarations
/// without a name are left out, open quotes are closed.
using Declarations = std::map<std::string, std::string, std::less<>>;
inline constexpr std::string_view important_mark = " !important";
Declarations parse_declarations(std::string_view text);

/// Returns a value without `!important`.
std::string without_important(std::string_view value);

/// The rules of a document's <style> elements, whatever their type, as Inkscape 1.2 reads them.
class StyleSheet {
 public:
  StyleSheet() = default;
  /// Reads all <style> elements below `root`.
  explicit StyleSheet(const xmlNode* root);

  /// Returns true if there are no rules.
  bool is_empty() const { return rules_.empty(); }

  /// Returns the property's value on this element alone: from the `style` attribute, else from a
  /// rule, else from the presentation attribute; first of all from what is `!important`. `inherit`
  /// is returned as such. As in Inkscape a
  /// value that `accepts` refuses is ignored: in the `style` attribute the value before it counts,
  /// but of rules only the last is tried.
  using Accepts = bool (*)(std::string_view value);
  std::optional<std::string> declared(const xmlNode* node, std::string_view property,
                                      Accepts accepts = nullptr) const;

  /// Returns true if a rule has a declaration that is `!important`.
  bool has_important() const { return has_important_; }
  /// Returns the properties to which some rule gives a value that `is_wanted` accepts.
  std::vector<std::string> properties(const std::function<bool(std::string_view)>& is_wanted) const;
  /// Returns true if a rule for this element has the property.
  bool rules_say(const xmlNode* node, std::string_view property) const {
    return from_rules(node, property) != nullptr;
  }
  /// Returns true if the property has to be `!important` in the `style` attribute, as it is in a
  /// rule.
  bool outranks_style(const xmlNode* node, std::string_view property) const;

  /// Returns the property's value on this element or, if that is absent or `inherit`, on the
  /// nearest ancestor with a value: for properties that CSS inherits, such as `fill` and `color`.
  std::optional<std::string> inherited(const xmlNode* node, std::string_view property) const;

 private:
  /// As Inkscape reads on, a declaration takes the place of the one before unless that is more
  /// specific, or the only one of both that is important.
  struct Declaration {
    std::string value;
    bool is_important;
    Selector::Specificity specificity;
    int order;
    std::size_t selector;
  };

  void read_below(const xmlNode* node);
  void add(const StyleRule& rule);
  const Declaration* from_rules(const xmlNode* node, std::string_view property) const;

  std::vector<Selector> selectors_;
  /// By the key of the selector, then by property.
  std::map<std::string, std::map<std::string, std::vector<Declaration>, std::less<>>, std::less<>>
      rules_;
  bool has_important_ = false;
  int count_ = 0;
};

}  // namespace gradmesh
