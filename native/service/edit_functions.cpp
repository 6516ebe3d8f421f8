#include <stdexcept>

#include "app/document/svg_document.h"
#include "app/editing/edits.h"
#include "app/editing/to_one_mesh.h"
#include "app/export/results_json.h"
#include "formats/svg/values/color.h"
#include "service/functions.h"
#include "service/options.h"
#include "service/results.h"

namespace gradmesh {
namespace {

std::optional<LineRange> line(const Call& call, const std::string& name) {
  const auto number = call.get<std::optional<int>>(name);
  return number ? std::optional(LineRange{*number, *number}) : std::nullopt;
}

/// Returns the lines from the first to the last, which are an argument of two numbers.
std::optional<LineRange> lines(const Call& call, const std::string& name) {
  if (!call.has(name)) return std::nullopt;
  const auto ends = call.get<std::vector<int>>(name);
  if (ends.size() != 2) throw std::invalid_argument(name + " must be the first and the last.");
  return LineRange{ends[0], ends[1]};
}

PointChoice point_choice(const Call& call) {
  return {call.get<std::string>("id", ""), call.get<std::vector<int>>("points"),
          call.get<std::vector<int>>("patches", {})};
}

}  // namespace

Json update_document(const Call& call) {
  Json list = Json::array();
  for (const UpdateReport& report :
       update(call.document(), call.get<std::vector<std::string>>("ids", {})))
    list.push_back(update_json(report));
  return list;
}

Json merge_patches(const Call& call) {
  PatchChoice choice;
  choice.ids = call.get<std::vector<std::string>>("ids", {});
  choice.patches = call.get<std::vector<int>>("patches", {});
  choice.rows = lines(call, "rows");
  choice.columns = lines(call, "columns");
  return edit_json(merge(call.document(), choice, measure_options(call)));
}

Json refine_patches(const Call& call) {
  PatchChoice choice;
  if (call.has("id")) choice.ids = {call.get<std::string>("id")};
  choice.patches = call.get<std::vector<int>>("patches", {});
  choice.rows = line(call, "row");
  choice.columns = line(call, "column");
  RefineOptions options;
  options.rows = call.get("rows", options.rows);
  options.columns = call.get("columns", options.columns);
  options.place = call.get("place", options.place);
  options.whole = call.get("whole", options.whole);
  return edit_json(refine(call.document(), choice, options, measure_options(call)));
}

Json recolor_point(const Call& call) {
  const std::string text = call.get<std::string>("color");
  const auto color = parse_color(text);
  if (!color) throw std::invalid_argument("'" + text + "' is no colour, as SVG knows them.");
  return edit_json(recolor(call.document(), point_choice(call), *color, measure_options(call)));
}

Json join_colors_of_point(const Call& call) {
  return edit_json(join_colors(call.document(), point_choice(call), measure_options(call)));
}

Json to_one_mesh_document(const Call& call) {
  Json list = Json::array();
  for (const EditReport& report : to_one_mesh(
           call.document(), call.get<std::vector<std::string>>("ids", {}), measure_options(call)))
    list.emplace_back(edit_json(report));
  return list;
}

Json publish_document(const Call& call) {
  Json list = Json::array();
  for (const PublishedMesh& mesh :
       publish(call.document(), {call.get("scale", PublishOptions().scale)}))
    list.push_back(published_json(mesh));
  return list;
}

Json publish_code_of_document(const Call& call) {
  const CodeLanguage language = code_language_named(call.get("language", std::string()));
  const PublishedSources published = publish_code(call.document(), language);
  Json list = Json::array();
  for (const PublishedCode& mesh : published.meshes) list.push_back(published_code_json(mesh));
  return {{"meshes", list}, {"source", published.source}};
}

}  // namespace gradmesh
