#pragma once

#include <vector>

#include "session/shown_mesh.h"

namespace gradmesh {

/// What stays as it is of the mesh that a session shows, and where errors count more or less.
class Protection {
 public:
  explicit Protection(ShownMesh& shown) : shown_(shown) {}

  /// Sets whether patches of the mesh that is shown are protected: neither edits nor states change
  /// anything of them. States then are those of a curve that leaves what lies there as it was at
  /// first.
  void protect(const std::vector<Face>& faces, bool is_protected);
  /// Protects all patches but these, which are released.
  void protect_others(const std::vector<Face>& faces);
  /// Lets errors in what these patches cover count so many times, whatever patches lie there later.
  /// Curves are then looked for anew. Throws InputError if the factor is not least_weight to
  /// most_weight, or there are no patches.
  void weigh(const std::vector<Face>& faces, double factor);
  /// Lets errors count alike everywhere again.
  void weigh_alike();

 private:
  void set_protected(const std::vector<Face>& fixed, const std::vector<Face>& released,
                     const Message& name);
  void set_weights(std::vector<WeightedArea> areas, const Message& name);

  ShownMesh& shown_;
};

}  // namespace gradmesh
