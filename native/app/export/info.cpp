#include "app/export/info.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/document/found_pages.h"
#include "app/export/results_json.h"
#include "formats/json/elements.h"

namespace gradmesh {
namespace {

using nlohmann::ordered_json;

/// Appends a value as text: objects and arrays down to `depth` with a line for each member, deeper
/// ones in one line.
void append_text(const ordered_json& value, int depth, const std::string& indent,
                 std::string& out) {
  if (depth == 0 || !value.is_structured() || value.empty()) {
    out += value.dump();
    return;
  }
  const std::string inner = indent + "  ";
  out += value.is_object() ? "{" : "[";
  bool first = true;
  for (const auto& [key, member] : value.items()) {
    out += (first ? "\n" : ",\n") + inner;
    if (value.is_object()) out += ordered_json(key).dump() + ": ";
    append_text(member, depth - 1, inner, out);
    first = false;
  }
  out += "\n" + indent + (value.is_object() ? "}" : "]");
}

/// Returns what was found of an entry's mesh on a page; null if it was read from none.
const FoundMesh* found_of(const MeshSource& document, const MeshEntry& entry) {
  if (!document.pages()) return nullptr;
  const auto& meshes = document.pages()->meshes;
  const auto found = std::ranges::find(meshes, entry.id, &FoundMesh::id);
  return found != meshes.end() ? &*found : nullptr;
}

}  // namespace

ordered_json info_json(const MeshSource& document) {
  ordered_json meshes = ordered_json::array(), unused = ordered_json::array();
  for (const MeshEntry& entry : document.meshes()) {
    if (entry.kept) continue;
    ordered_json& mesh = meshes.emplace_back(mesh_json(document, entry));
    if (entry.refused)
      mesh["refused"] = entry.refused->english();
    else
      mesh["elements"] = elements_json(document.mesh(entry));
    if (const FoundMesh* const found = found_of(document, entry))
      mesh["found"] = found_json(*found);
  }
  for (const UnusedMesh& mesh : document.unused())
    unused.push_back({{"id", mesh.id}, {"patches", mesh.patches}});
  // Says that there is none.
  if (meshes.empty() && unused.empty()) document.selected({});
  ordered_json json = {{"file", document.name()},
                       {"kind", document.pages() ? document.pages()->kind : document.format().name},
                       {"meshes", meshes},
                       {"unused", unused}};
  if (document.pages()) {
    ordered_json left_out = ordered_json::array();
    for (const Message& sentence : document.pages()->left_out)
      left_out.push_back(sentence.english());
    json["left_out"] = left_out;
  }
  return json;
}

std::string info_text(const MeshSource& document) {
  // file, meshes / mesh / elements / points / point
  constexpr int depth_of_elements = 5;
  std::string text;
  append_text(info_json(document), depth_of_elements, "", text);
  return text + "\n";
}

}  // namespace gradmesh
