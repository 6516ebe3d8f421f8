#pragma once

#include <set>
#include <string>
#include <string_view>

namespace gradmesh {

/// Gives meshes names that Swift and Kotlin take as names of types and functions.
class CodeNames {
 public:
  /// Returns a name for the object with this id, which may be any text: `page-1-mesh-2` becomes
  /// `Page1Mesh2`. No two names are equal or differ in capitals only, as they name files too, none
  /// is one of the toolkits' own, and none is another one with `data_suffix`. Equal ids in the same
  /// order get the same names.
  std::string take(std::string_view id);

  /// What ends the name of the object in which Kotlin holds the numbers of a mesh.
  static constexpr std::string_view data_suffix = "Data";

 private:
  /// In small letters.
  std::set<std::string> taken_;
};

}  // namespace gradmesh
