#include <optional>
#include <string>

#include "formats/hemesh/hemesh.h"
#include "mesh/build.h"
#include "target.h"

namespace gradmesh::fuzz {

void check(std::string_view text) {
  std::optional<Mesh> mesh;
  if (!accepts([&] { mesh = build_mesh(read_hemesh(text, input_name)); })) return;
  require_sound(*mesh);
  const std::string written = write_hemesh(*mesh);
  must_accept(
      [&] {
        const Mesh again = build_mesh(read_hemesh(written, input_name));
        require_sound(again);
        require(again.face_count() == mesh->face_count(), "no patch is lost");
        require(write_hemesh(again) == written, "what was written is written as it is");
      },
      "what was written can be read");
}

}  // namespace gradmesh::fuzz
