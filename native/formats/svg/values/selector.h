#pragma once

#include <libxml/tree.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gradmesh {

/// A selector of CSS as Inkscape 1.2 reads and matches it: elements, `*`, classes, ids, attributes
/// (`[a]`, `[a=v]`, `[a~=v]`, `[a|=v]`), the pseudo-classes of an element's place, and all
/// combinators. It differs from CSS in that a blank between an element's name and what narrows it
/// does not count (`g .a` is `g.a`), and in that `[a|=v]` takes every value that begins with v.
class Selector {
 public:
  /// Numbers of ids; of classes, attributes and pseudo-classes; and of elements' names.
  using Specificity = std::array<int, 3>;

  bool matches(const xmlNode* element) const;
  Specificity specificity() const;
  /// Returns what every element that matches has: `#id`, `.class`, an element's name, or `*`.
  std::string key() const;

 private:
  friend class SelectorParser;

  enum class Kind { id, attribute, equals, word, prefix, place, language, nothing };

  /// A place among siblings: the number (from 1) is a * n + b for some n >= 0.
  struct Place {
    int a = 0, b = 1;
    bool of_type = false, from_end = false;

    bool holds(const xmlNode* element) const;
  };

  struct Condition {
    Kind kind;
    std::string name, value;
    std::vector<Place> places;
    bool is_root = false, is_empty = false;

    bool holds(const xmlNode* element) const;
  };

  /// What one element must be, and how the element of the compound before lies to it: ' ', '>', '+'
  /// or '~'.
  struct Compound {
    char combinator = ' ';
    std::string element;
    std::vector<Condition> conditions;

    bool holds(const xmlNode* node) const;
  };

  class Search;

  std::vector<Compound> compounds_;
};

/// Returns the selectors of a rule, which commas separate. Returns none where Inkscape 1.2 leaves
/// the rule out, for one selector that it does not read: `:not(.a)`, `[a^=v]`, `::before`.
std::vector<Selector> parse_selectors(std::string_view text);

}  // namespace gradmesh
