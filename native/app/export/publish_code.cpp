#include "app/export/publish_code.h"

#include <stdexcept>
#include <utility>

#include "app/document/svg_document.h"
#include "app/export/code_of_mesh.h"
#include "formats/code/code_names.h"
#include "formats/code/compose_code.h"
#include "formats/code/swift_code.h"

namespace gradmesh {
namespace {

constexpr std::string_view made_by = "Made by gradmesh ";

std::string code_text(const std::vector<MeshCode>& meshes, CodeLanguage language,
                      const std::string& document) {
  // The name alone: folders are nobody else's business.
  const std::string file = document.substr(document.find_last_of("/\\") + 1);
  const std::string origin = std::string(made_by) + GRADMESH_VERSION + " from " + file;
  return language == CodeLanguage::swift ? swift_code(meshes, origin)
                                         : compose_code(meshes, origin);
}

}  // namespace

CodeLanguage code_language_named(const std::string& name) {
  if (name == "swift") return CodeLanguage::swift;
  if (name == "compose") return CodeLanguage::compose;
  throw std::invalid_argument("the language must be swift or compose.");
}

const char* code_extension(CodeLanguage language) {
  return language == CodeLanguage::swift ? ".swift" : ".kt";
}

bool is_published_code(std::string_view text) {
  return text.starts_with("// " + std::string(made_by));
}

PublishedSources publish_code(Document& document, CodeLanguage language) {
  const SvgDocument& meshes = as_svg(
      document,
      Message("{0}: only SVG documents are published; gradmesh convert makes one of this file.",
              document.name()));
  PublishedSources published;
  std::vector<MeshCode> codes;
  CodeNames names;
  for (const MeshEntry& entry : meshes.selected({}))
    document.naming(entry, [&] {
      PublishedCode mesh{entry.id, names.take(entry.id), "", {}};
      CodeOfMesh made = code_of_mesh(meshes, entry);
      made.code.name = mesh.name;
      mesh.source = code_text({made.code}, language, document.name());
      for (const Message& sentence : made.lost)
        mesh.lost.push_back(Message("{0}: {1}", document.describe(entry), sentence));
      codes.push_back(std::move(made.code));
      published.meshes.push_back(std::move(mesh));
    });
  published.source = code_text(codes, language, document.name());
  for (const MeshEntry& entry : meshes.refused({}))
    published.meshes.push_back({entry.id, "", "", {}, entry.refused});
  return published;
}

}  // namespace gradmesh
