#include <stdexcept>

#include "app/export/results_json.h"
#include "app/pictures/trace.h"
#include "service/functions.h"
#include "service/options.h"

namespace gradmesh {
namespace {

TraceOptions trace_options(const Call& call) {
  TraceOptions options;
  if (call.has("amount") && call.has("epsilon"))
    throw std::invalid_argument("an amount has an epsilon of its own, beside which there is none.");
  if (call.has("amount"))
    options.epsilon = amount_named(call.get<std::string>("amount")).traced_epsilon;
  options.handles = call.get("handles", options.handles);
  options.epsilon = call.get("epsilon", options.epsilon);
  options.detail = call.get("detail", options.detail);
  options.guides = call.get("guides", options.guides);
  options.weights = call.get("weights", options.weights);
  options.threads = call.get("threads", options.threads);
  options.time_budget = call.get("time_budget", options.time_budget);
  options.progress = call.progress();
  options.show = call.show();
  return options;
}

Json traced_json(const Document& document, const Tracing& tracing) {
  Json result = tracing_json(tracing);
  result["id"] = tracing.id;
  result["image"] = tracing.image.empty() ? Json() : Json(tracing.image);
  const std::optional<Message> advice = what_would_help(tracing);
  result["advice"] = advice ? Json(advice->in(document.translation())) : Json();
  return result;
}

}  // namespace

Json trace_picture(const Call& call) {
  const TraceOptions options = trace_options(call);
  const std::filesystem::path path =
      call.has("path") || !call.has("outline") ? path_argument(call, "path") : "";
  const int resolution = measure_options(call).resolution;
  TracedDocument traced =
      call.has("outline") ? trace_file_in_shape(path, resolution, path_argument(call, "outline"),
                                                call.get<std::string>("id"), options)
                          : trace_file(path, resolution, call.get<std::string>("path"), options);
  Json result = traced_json(*traced.document, traced.tracing);
  result["document"] = call.add(std::move(traced.document));
  return result;
}

Json trace_document(const Call& call) {
  ToTrace what{call.get<std::vector<std::string>>("ids"), call.get<std::string>("image", "")};
  Document& document = call.document();
  Json result = Json::array();
  for (const Tracing& tracing :
       trace_in(document, what, measure_options(call).resolution, trace_options(call)))
    result.push_back(traced_json(document, tracing));
  return result;
}

}  // namespace gradmesh
