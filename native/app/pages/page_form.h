#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "formats/pdf/grid/mesh_forms.h"
#include "mesh/mesh.h"

namespace gradmesh {

/// The largest FLIP at which a mesh looks as the page does for certain.
inline constexpr double look_of_page = 0.01;

/// A mesh that was chosen to stand for the patches of a page.
struct ChosenForm {
  MeshForm::Kind kind = MeshForm::Kind::page;
  /// In pixels of SVG.
  Mesh mesh;
  /// FLIP against the page's own patches, 700 pixels along the longer side.
  double difference = 0;
  /// The handles of the page's own patches, all joined.
  int page_handles = 0;
};

/// Returns the first of the forms that looks as the patches of the page do, or else the last one;
/// nothing if `goes_on`, which is asked before each, returns false. Throws InputError where the
/// patches have no size.
std::optional<ChosenForm> choose_form(const std::vector<PagePatch>& patches, MeshForms forms,
                                      const std::function<bool()>& goes_on);

}  // namespace gradmesh
