// Whatever a document is, what is published of it can be read, and shows no mesh that could be.
// Code of its meshes ends in lines of ours.
#include <cstdlib>

#include "app/document/svg_document.h"
#include "app/export/publish.h"
#include "app/export/publish_code.h"
#include "target.h"

namespace gradmesh::fuzz {
namespace {

/// Small pictures, however large a document says that it is. Windows has no setenv.
char limits[] = "GRADMESH_LIMITS=resolution=64";
[[maybe_unused]] const int limited = putenv(limits);

}  // namespace

void check(std::string_view bytes) {
  accepts([&] {
    SvgDocument document(bytes, input_name);
    const std::string before = document.bytes();
    accepts([&] {
      for (const CodeLanguage language : {CodeLanguage::swift, CodeLanguage::compose}) {
        const PublishedSources made = publish_code(document, language);
        require(is_published_code(made.source) && made.source.ends_with("}\n"),
                "code is of this program");
      }
    });
    require(document.bytes() == before, "code changes nothing");
    std::size_t refused = 0;
    const bool published = accepts([&] {
      for (const PublishedMesh& mesh : publish(document)) {
        refused += mesh.as == PublishedAs::nothing;
        require(mesh.width <= 64 && mesh.height <= 64, "pictures keep to the limit");
      }
    });
    if (!published) {
      require(document.bytes() == before, "what is refused stays as it is");
      return;
    }
    must_accept(
        [&] {
          const SvgDocument again(document.bytes(), input_name);
          std::size_t left = 0;
          for (const MeshEntry& entry : again.meshes()) left += entry.refused.has_value();
          require(left == again.meshes().size() && left <= refused,
                  "only meshes that cannot be read are left");
        },
        "what was published can be read");
  });
}

}  // namespace gradmesh::fuzz
