#include "app/convert_for_run.h"
#include "service/functions.h"
#include "service/one_mesh.h"
#include "service/options.h"
#include "service/results.h"

namespace gradmesh {
namespace {

Json simplified(Document& document, const std::vector<std::string>& ids, const RunOptions& options,
                const Call& call) {
  const AnalysisPaths analyses = analysis_paths(call);
  if (call.get<bool>("preview")) return reports_json(preview(document, ids, options, analyses));
  const WriteOptions writing{call.get<bool>("remember_original"), call.get<bool>("keep_original")};
  return reports_json(simplify(document, ids, options, analyses, writing));
}

}  // namespace

Json simplify_document(const Call& call) {
  Document& document = call.document();
  const auto ids = call.get<std::vector<std::string>>("ids");
  const auto kind = call.get<std::optional<std::string>>("kind");
  const MeasuredAgainst measured(document, call);
  const RunOptions options = run_options(call);
  if (!kind || *kind == document.format().name)
    return {{"document", nullptr}, {"meshes", simplified(document, ids, options, call)}};
  // The options of the run name what to measure against.
  ConvertedRun run =
      convert_for_run(document, one_mesh(document, ids, "its id"), format_named(*kind), options);
  Json results = simplified(*run.document, {}, run.options, call);
  return {{"document", call.add(std::move(run.document))}, {"meshes", std::move(results)}};
}

Json analyze_document(const Call& call) {
  Document& document = call.document();
  RunOptions options = pricing_options(call);
  take_renderer(options, call);
  options.progress = call.progress();
  const MeasuredAgainst measured(document, call);
  return analyze(document, call.get<std::vector<std::string>>("ids"), options, analysis_paths(call));
}

}  // namespace gradmesh
