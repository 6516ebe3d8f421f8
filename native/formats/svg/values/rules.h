#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "formats/svg/values/selector.h"

namespace gradmesh {

/// A declaration of CSS: the property as it is written, the value without `!important`.
struct StyleDeclaration {
  std::string property, value;
  bool is_important = false;
};

struct StyleRule {
  std::vector<Selector> selectors;
  std::vector<StyleDeclaration> declarations;
};

/// Takes `!important` off the end of a value; returns true if it was there.
bool take_important(std::string_view& value);

/// Returns the rules of a style element that Inkscape 1.2 heeds. What stands in `@media` counts,
/// for whatever medium, unless the medium has conditions; other rules with `@` do not count. A rule
/// does not count where one of its selectors or values cannot be read. Nothing of the element
/// counts where its text is broken: something is left open at the end, or there is a declaration
/// without a value or with a name that CSS 2 does not allow, such as `--a` or `*fill`.
std::vector<StyleRule> parse_style_rules(std::string_view css);

}  // namespace gradmesh
