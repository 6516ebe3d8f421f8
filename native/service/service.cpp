#include "service/service.h"

#include <new>
#include <stdexcept>
#include <unordered_map>

#include "base/error.h"
#include "service/functions.h"
#include "service/results.h"
#include "service/translation.h"

namespace gradmesh {
namespace {

Json hello(const Call&) { return {{"protocol", Service::version}, {"version", GRADMESH_VERSION}}; }

using Function = Json (*)(const Call&);

const std::unordered_map<std::string, Function>& functions() {
  static const std::unordered_map<std::string, Function> all = {
      {"hello", hello},
      {"read", read_document},
      {"parse", parse_document},
      {"convert", convert_document},
      {"insert_pages", insert_pages_into},
      {"trace", trace_picture},
      {"trace_in", trace_document},
      {"write", write_document},
      {"bytes", document_bytes},
      {"kind", document_kind},
      {"left_out", left_out_of_document},
      {"ids", mesh_ids},
      {"meshes", meshes},
      {"info", info},
      {"options", run_option_list},
      {"simplify", simplify_document},
      {"analyze", analyze_document},
      {"update", update_document},
      {"merge", merge_patches},
      {"refine", refine_patches},
      {"recolor", recolor_point},
      {"join_colors", join_colors_of_point},
      {"to_one_mesh", to_one_mesh_document},
      {"publish", publish_document},
      {"publish_code", publish_code_of_document},
      {"open_session", open_session},
      {"close_session", close_session},
      {"session_status", session_status},
      {"show_state", show_state},
      {"set_session_form", set_session_form},
      {"point_at", point_at},
      {"make_edit", make_edit},
      {"propose_merge", propose_merge},
      {"merge_marked", merge_marked},
      {"protect_marked", protect_marked},
      {"weigh_marked", weigh_marked},
      {"fit_session", fit_session},
      {"undo_edit", undo_edit},
      {"redo_edit", redo_edit},
      {"find_patches", find_patches},
      {"find_out", find_out},
      {"worst_places", worst_places},
      {"paint_session", paint_session},
      {"write_session", write_session},
      {"render", render_mesh},
      {"compare", compare_pictures},
      {"differences", differences_of_pictures},
      {"draw", draw_mesh},
      {"report", write_report},
  };
  return all;
}

Json failure(const char* kind, const std::string& text) {
  return {{"error", kind}, {"text", text}};
}

Json result(Documents& documents, const Json& request, const Ask& ask) {
  const Arguments parts(request);
  if (const auto gone = request.find("release"); gone != request.end())
    for (const std::uint64_t number : parts.get<std::vector<std::uint64_t>>("release"))
      documents.remove(number);
  const std::string name = parts.get<std::string>("call");
  const auto function = functions().find(name);
  if (function == functions().end())
    throw std::invalid_argument("there is no function '" + name + "'.");
  const auto arguments = request.find("arguments");
  if (arguments == request.end()) throw WrongType("a call has arguments.");
  const Caller caller(ask);
  return {{"result", function->second(Call(documents, *arguments, ask))}};
}

}  // namespace

Json Service::call(const Json& request, const Ask& ask) {
  try {
    return result(documents_, request, ask);
  } catch (const GivenUp&) {
    return failure("given up", "the caller has given up.");
  } catch (const InputError& error) {
    return {{"error", "input"}, {"message", message_json(error.message())}};
  } catch (const WrongType& error) {
    return failure("type", error.what());
  } catch (const std::invalid_argument& error) {
    return failure("value", error.what());
  } catch (const std::bad_alloc&) {
    return failure("memory", "there is not enough memory for this.");
  } catch (const std::exception& error) {
    return failure("fault", error.what());
  }
}

}  // namespace gradmesh
