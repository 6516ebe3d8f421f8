#include <string>

#include "form/reconcile.h"
#include "formats/svg/group/mesh_group.h"
#include "formats/svg/tree/own.h"
#include "formats/svg/values/curves.h"
#include "formats/svg/xml/node.h"
#include "mesh/build.h"
#include "target.h"

namespace gradmesh::fuzz {
namespace {

/// A group of one block of two patches above two of one each, which a few T-junctions can join.
SvgTree blocks() {
  const std::string square =
      "<stop path='l 20,0' stop-color='red'/><stop path='l 0,10'/><stop path='l -20,0'/>";
  const auto gradient = [&](const std::string& id, const std::string& place,
                            const std::string& more) {
    return "<meshgradient id='" + id + "' gradientUnits='userSpaceOnUse' " + place +
           "><meshrow><meshpatch>" + square + "<stop path='l 0,-10'/></meshpatch>" + more +
           "</meshrow></meshgradient>";
  };
  const std::string beside = "<meshpatch>" + square + "</meshpatch>";
  return SvgTree::parse(
      "<svg xmlns='http://www.w3.org/2000/svg' xmlns:gradmesh='urn:gradmesh'><defs>" +
          gradient("a", "x='0' y='0'", beside) + gradient("b", "x='0' y='10'", "") +
          gradient("c", "x='20' y='10'", "") +
          "</defs><g id='g' gradmesh:version='1'>"
          "<path gradmesh:face='0' fill='url(#a)'/><path gradmesh:face='2' fill='url(#b)'/>"
          "<path gradmesh:face='3' fill='url(#c)'/></g></svg>",
      input_name);
}

}  // namespace

/// The text as the group's `curves`.
void check(std::string_view bytes) {
  const std::string text(bytes);
  static const SvgTree document = blocks();
  xmlNode* const group = child_elements(document.root(), "g").front();
  set_own_attribute(group, "curves", text);
  accepts([&] {
    const MeshParts parts = read_mesh_group(document, group);
    const Mesh mesh = build_mesh(parts);
    require_sound(mesh);
    must_accept(
        [&] {
          const BlockForm form = block_form(mesh, 0);
          const Mesh written = build_mesh(block_parts(mesh, form));
          require_sound(written);
          require(written.face_count() == mesh.face_count(), "no patch is lost");
          format_curves(mesh, form.blocks);
        },
        "a mesh that was read can be written");
    require_sound(build_mesh(reconcile(parts).parts));
    require(!reconcile(parts, parts).edited, "a mesh is what it was written as");
  });
}

}  // namespace gradmesh::fuzz
