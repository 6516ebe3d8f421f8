#pragma once

#include <libxml/tree.h>

#include <vector>

namespace gradmesh {

/// The elements of mesh gradients. Those of SVG 2's earlier drafts, which Inkscape 1 paints as
/// well, have other names; gradmesh writes today's.
inline constexpr const char* mesh_gradient_name = "meshgradient";
inline constexpr const char* mesh_row_name = "meshrow";
inline constexpr const char* mesh_patch_name = "meshpatch";

/// Returns true if the element is a <meshgradient>, <meshGradient> or <mesh>.
bool is_mesh_gradient(const xmlNode* node);
/// Returns true if the element is a gradient of any kind.
bool is_gradient(const xmlNode* node);
/// Returns the <meshrow>s and <meshRow>s of a gradient.
std::vector<xmlNode*> mesh_rows(const xmlNode* gradient);
/// Returns the <meshpatch>es and <meshPatch>es of a row.
std::vector<xmlNode*> mesh_patches(const xmlNode* row);

}  // namespace gradmesh
