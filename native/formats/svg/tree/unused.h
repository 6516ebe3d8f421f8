#pragma once

#include <libxml/tree.h>

#include <set>
#include <string>
#include <vector>

#include "formats/svg/tree/svg_tree.h"

namespace gradmesh {

/// Returns true if an attribute of the document names this id, or a rule that some element follows.
/// The elements of `except` do not count.
bool is_used(const SvgTree& tree, const std::string& id,
             const std::set<const xmlNode*>& except = {});

/// Returns true if a <use> shows the element, or one that it lies in.
bool is_cloned(const SvgTree& tree, const xmlNode* node);

/// Removes an element that no element uses. Rules that name it, which none follows, get the colour
/// that stands in for it: nothing names what is gone.
void remove_named(SvgTree& tree, xmlNode* node);

/// Removes elements with all below them, and the clip paths and masks that nothing else uses then.
void remove_with_clips(SvgTree& tree, const std::vector<xmlNode*>& nodes);

/// Removes the element with this id, and then the mesh gradient that it alone used by href, if it
/// is not used.
void remove_if_unused(SvgTree& tree, const std::string& id);

}  // namespace gradmesh
