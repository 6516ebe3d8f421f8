#include "app/edits.h"
#include "service/functions.h"
#include "service/options.h"
#include "service/results.h"

namespace gradmesh {

Json update_document(const Call& call) {
  Json list = Json::array();
  for (const UpdateReport& report :
       call.document().update(call.get<std::vector<std::string>>("ids", {})))
    list.push_back(update_json(report));
  return list;
}

Json merge_patches(const Call& call) {
  return edit_json(merge_blocks(call.document(), call.get<std::vector<std::string>>("ids"),
                                measure_options(call)));
}

Json refine_patches(const Call& call) {
  RefineOptions options;
  options.rows = call.get("rows", options.rows);
  options.columns = call.get("columns", options.columns);
  options.place = call.get("place", options.place);
  options.row = call.get<std::optional<int>>("row");
  options.column = call.get<std::optional<int>>("column");
  options.whole = call.get("whole", options.whole);
  return edit_json(
      refine(call.document(), call.get<std::string>("id"), options, measure_options(call)));
}

Json to_one_mesh_document(const Call& call) {
  Json list = Json::array();
  for (const EditReport& report : to_one_mesh(
           call.document(), call.get<std::vector<std::string>>("ids", {}), measure_options(call)))
    list.push_back(edit_json(report));
  return list;
}

Json publish_document(const Call& call) {
  Json list = Json::array();
  for (const PublishedMesh& mesh :
       publish(call.document(), {call.get("scale", PublishOptions().scale)}))
    list.push_back(published_json(mesh));
  return list;
}

}  // namespace gradmesh
