#pragma once

#include <libxml/tree.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gradmesh {

/// The namespace of gradmesh's own attributes. What they say of a group of blocks is listed in
/// formats/svg/group/mesh_group.h, what they say of an object with one mesh gradient in
/// formats/svg/gradient/written_gradient.h. Further ones are
///   opacity   on the mask whose blocks hold the opacities of a group's mesh as luminances
///   kept-for  on a hidden original (formats/svg/tree/kept.h): the id of the object that was
///             simplified
///   picture   on an object whose mesh was traced: from what (formats/svg/picture/
///             remembered_picture.h)
///   outer     on each group around a group of blocks that belongs to the same object
inline constexpr std::string_view gradmesh_namespace = "urn:gradmesh";

/// Returns the value of one of these attributes; nothing if there is none.
std::optional<std::string> own_attribute(const xmlNode* node, const char* name);
/// Sets one of these attributes, or removes the attribute if the value is empty.
void set_own_attribute(xmlNode* node, const char* name, const std::string& value);

/// Returns true if the element is a group of blocks.
bool is_mesh_group(const xmlNode* node);
/// Returns true if the element is the path of a block.
bool is_block(const xmlNode* node);
/// Returns true if the element is the mask that holds the opacities of some group's mesh.
bool is_opacity_mask(const xmlNode* node);

/// Returns the element and the groups around it that belong to the same object, from the inside
/// out.
std::vector<xmlNode*> with_outer(xmlNode* node);

}  // namespace gradmesh
