#include <cmath>

#include "service/functions.h"
#include "service/options.h"
#include "service/results.h"

namespace gradmesh {
namespace {

std::vector<std::string> ids(const Call& call) {
  return call.get<std::vector<std::string>>("ids", {});
}

Json default_of(const NamedValue& value) {
  const std::string name = value.get({});
  return name.empty() ? Json() : Json(name);
}
template <class T>
Json default_of(T SimplifyOptions::*member) {
  return SimplifyOptions().*member;
}
template <class T>
Json default_of(std::optional<T> SimplifyOptions::*) {
  return nullptr;
}

Json option_json(const OptionEntry& option) {
  Json json = {{"default", std::visit([](auto value) { return default_of(value); }, option.value)},
               {"help", option.help},
               {"methods", methods_with(option.name)}};
  if (const auto* const value = std::get_if<NamedValue>(&option.value))
    json["names"] = value->names();
  if (option.range) json["least"] = option.range->least;
  if (option.range && std::isfinite(option.range->most)) json["most"] = option.range->most;
  return json;
}

}  // namespace

Json run_option_list(const Call&) {
  Json json = Json::object();
  for (const OptionEntry& option : all_options()) json[option.name] = option_json(option);
  return json;
}

Json simplify_document(const Call& call) {
  Document& document = call.document();
  const MeasuredAgainst measured(document, call);
  RunOptions options = run_options(call);
  take_renderer(options, call);
  const PricePaths analyses = analysis_paths(call);
  WriteOptions writing;
  writing.remember_original = call.get("remember_original", writing.remember_original);
  writing.keep_original = call.get("keep_original", writing.keep_original);
  const std::vector<MeshReport> reports =
      call.get("preview", false) ? preview(document, ids(call), options, analyses)
                                 : simplify(document, ids(call), options, analyses, writing);
  const Document* const original = call.optional_document("original");
  return results_json(document, reports, options, original ? original->name() : "");
}

Json analyze_document(const Call& call) {
  Document& document = call.document();
  RunOptions options = run_options(call);
  take_renderer(options, call);
  const MeasuredAgainst measured(document, call);
  return analyze(document, ids(call), options, analysis_paths(call));
}

}  // namespace gradmesh
