#pragma once

#include <map>
#include <memory>
#include <vector>

#include "formats/svg/group/new_object.h"

namespace gradmesh {

/// The groups of a new document whose objects are mixed at once with what lies below.
class MixedGroups {
 public:
  /// Returns the innermost of the groups, the outermost first, in `layer`, above all else there:
  /// one that was made, as long as nothing else lies above it, or a new one.
  xmlNode* within(SvgTree& tree, xmlNode* layer,
                  const std::vector<std::shared_ptr<const SvgGroup>>& groups);

 private:
  std::map<std::shared_ptr<const SvgGroup>, xmlNode*> made_;
};

}  // namespace gradmesh
