#include <stdexcept>

#include "app/document/write_file.h"
#include "app/export/info.h"
#include "app/export/results_json.h"
#include "app/pages/insert_pages.h"
#include "app/pages/page_documents.h"
#include "app/pages/read_document.h"
#include "app/runs/convert.h"
#include "base/utf8_path.h"
#include "service/functions.h"
#include "service/options.h"
#include "service/results.h"
#include "service/translation.h"

namespace gradmesh {

namespace {

PageChoice page_choice(const Call& call) {
  return {call.get<std::optional<int>>("page"), call.get("password", std::string()),
          call.get("all_layers", false)};
}

Json sentences(const std::vector<Message>& left_out) {
  Json all = Json::array();
  for (const Message& sentence : left_out) all.push_back(message_json(sentence));
  return all;
}

}  // namespace

Json read_document(const Call& call) {
  return call.add(read_document(path_argument(call, "path"), page_choice(call)));
}

Json parse_document(const Call& call) {
  auto document = parse_document(call.get<Bytes>("bytes").bytes, call.get<std::string>("name"),
                                 page_choice(call));
  std::vector<std::filesystem::path> folders;
  for (const std::string& folder : call.get("folders", std::vector<std::string>{}))
    folders.push_back(utf8_path(folder));
  document->file().look_in(std::move(folders));
  if (call.get("translated", false)) document->set_translation(callers_translation());
  return call.add(std::move(document));
}

Json convert_document(const Call& call) {
  const Document& document = call.document();
  const MeasureOptions measure = measure_options(call);
  ConvertOptions options;
  options.epsilon = call.get("epsilon", options.epsilon);
  options.must_keep_epsilon = call.has("epsilon");
  options.subdivide = call.get<std::optional<int>>("subdivide");
  options.metric = measure.metric;
  options.resolution = measure.resolution;
  const Format& to = format_named(call.get<std::string>("kind"));
  Conversion conversion = convert(document, one_mesh(document, call), to, options);
  const Document& made = *conversion.document;
  const int patches = made.mesh(made.meshes().front()).face_count();
  return {{"document", call.add(std::move(conversion.document))},
          {"patches", patches},
          {"error", conversion.error},
          {"lost_opacity", conversion.lost_opacity}};
}

Json insert_pages_into(const Call& call) {
  InsertOptions options{page_choice(call), call.get("into", std::string())};
  options.pages.progress = call.progress();
  options.replace_tiles = call.get("replace_tiles", options.replace_tiles);
  const InsertedPages inserted =
      insert_pages(call.document(), path_argument(call, "path"), options);
  Json meshes = Json::array();
  for (const FoundMesh& mesh : inserted.found.meshes) {
    Json& told = meshes.emplace_back(found_json(mesh));
    told["id"] = mesh.id;
  }
  return {{"meshes", meshes},
          {"left_out", sentences(inserted.found.left_out)},
          {"replaced", inserted.replaced},
          {"stopped", inserted.found.is_stopped}};
}

Json write_document(const Call& call) {
  write_file(call.document(), path_argument(call, "path"));
  return nullptr;
}

Json document_bytes(const Call& call) {
  const auto shown = call.get<std::optional<Bytes>>("over");
  const std::string bytes =
      shown ? call.document().bytes_over(shown->bytes) : call.document().bytes();
  return Json::binary({bytes.begin(), bytes.end()});
}

Json document_kind(const Call& call) { return call.document().format().name; }

Json left_out_of_document(const Call& call) {
  const FoundPages* const pages = call.document().pages();
  return pages ? sentences(pages->left_out) : Json::array();
}

Json mesh_ids(const Call& call) {
  Json ids = Json::array();
  for (const MeshEntry& entry : call.document().meshes())
    if (!entry.kept) ids.push_back(entry.id);
  return ids;
}

Json meshes(const Call& call) { return meshes_json(call.document()); }

Json info(const Call& call) { return info_text(call.document()); }

}  // namespace gradmesh
