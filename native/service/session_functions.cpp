#include <cmath>

#include "app/export/results_json.h"
#include "app/runs/curves.h"
#include "draw/heat_scale.h"
#include "service/functions.h"
#include "service/options.h"
#include "service/results.h"
#include "service/sessions.h"
#include "session/picture.h"

namespace gradmesh {
namespace {

/// Returns the patch whose number is the argument `patch`; an invalid one if there is no argument.
Face one_face(const Call& call) {
  const auto number = call.get<std::optional<int>>("patch");
  return number ? session(call).shown().faces_numbered({*number}).front() : Face{};
}

/// Returns the places of a closed line, whose argument is x, y, x, y, ... in pixels.
std::vector<glm::dvec2> lasso(const Call& call) {
  const std::vector<double> numbers = call.get<std::vector<double>>("lasso", {});
  std::vector<glm::dvec2> places;
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2)
    places.emplace_back(numbers[i], numbers[i + 1]);
  return places;
}

Json curves_json(const Editing& editing) {
  const Session& session = editing.session;
  Json all = Json::object();
  for (const MeshKind kind : session.shown().kinds()) {
    const auto found = session.curves().found(kind);
    Json& json = all[name(kind)] = found ? Json(curve_json(kind, found->curve)) : Json::object();
    if (found && !found->curve.states.empty())
      json["states"].front()["objects"] = editing.objects_before;
    json["wanted"] = found.has_value();
    json["complete"] = found && found->is_complete;
    json["failure"] = found && found->failure ? message_json(*found->failure) : Json();
  }
  return all;
}

/// Returns colours of a scale with the errors that they mean, from the lowest on.
Json scale_json(const HeatScale& scale) {
  constexpr int steps = 3;
  Json json = Json::array();
  for (int i = 0; i <= steps; ++i) {
    const double position = double(i) / steps;
    json.push_back({{"error", scale.error_at(position)}, {"color", HeatScale::color_at(position)}});
  }
  return json;
}

Json region_json(const RegionPrice& region) {
  // Rows and columns have a meaning only where no T-junction is inside.
  const bool is_grid = region.size() == region.region.size();
  return {{"patches", numbers(region.patches)},
          {"rows", is_grid ? Json(region.region.rows) : Json()},
          {"columns", is_grid ? Json(region.region.columns) : Json()},
          {"error", region.error}};
}

Json prices_json(const Analysis& analysis, const Editing& editing) {
  const Mesh& mesh = editing.session.mesh();
  bool has_scale = false;
  Json prices = Json::array();
  for (const auto& [curve, error] : analysis.prices) {
    const glm::dvec2 middle = editing.view.point(mesh.curve_of(curve).at(0.5).position);
    const bool is_known = std::isfinite(error);
    has_scale = has_scale || is_known;
    prices.push_back(
        {{"x", middle.x}, {"y", middle.y}, {"error", is_known ? Json(error) : Json()}});
  }
  return {{"scale", has_scale ? scale_json(scale_of(analysis.prices)) : Json::array()},
          {"prices", std::move(prices)}};
}

Json parts_json(const Analysis& analysis) {
  return {{"parts", analysis.parts.parts.size()}, {"limit", analysis.limit}};
}

Json regions_json(const Analysis& analysis, const Call& call, Face patch) {
  Json json{{"regions", 0}, {"region", nullptr}};
  if (!patch.valid()) return json;
  const std::vector<RegionPrice> regions = largest_regions(analysis, patch);
  const int number = call.get("region", 0);
  json["regions"] = regions.size();
  if (number >= 0 && std::size_t(number) < regions.size())
    json["region"] = region_json(regions[std::size_t(number)]);
  return json;
}

}  // namespace

Json open_session(const Call& call) {
  const Document& document = call.document();
  const MeshEntry entry = one_mesh(document, call);
  auto opened = edit_by_eye(document, entry, run_options(call));
  const Box box = opened->box();
  Json json = status_json(*opened);
  json["id"] = entry.id;
  json["box"] = Json::array({box.low().x, box.low().y, box.high().x, box.high().y});
  call.sessions()[entry.id] = std::move(opened);
  return json;
}

Json close_session(const Call& call) {
  call.sessions().erase(call.get<std::string>("id"));
  return nullptr;
}

Json session_status(const Call& call) {
  Session& s = session(call);
  if (call.get("wait", false)) s.curves().wait();
  Json json = status_json(editing(call));
  json["curves"] = curves_json(editing(call));
  return json;
}

Json show_state(const Call& call) {
  Session& s = session(call);
  const MeshKind kind = kind_named(call.get<std::string>("kind"));
  // Whoever asks for no state wants the curve.
  const int state = call.get("state", -1);
  if (state < 0)
    s.curves().request(kind);
  else
    s.show(kind, state, call.get("moving", false));
  return status_json(editing(call));
}

Json set_session_form(const Call& call) {
  Session& s = session(call);
  s.hands().set_form(kind_named(call.get<std::string>("form")));
  return status_json(editing(call));
}

Json protect_marked(const Call& call) {
  Session& s = session(call);
  const std::vector<Face> patches = faces(call, "patches");
  if (call.get("others", false))
    s.protection().protect_others(patches);
  else
    s.protection().protect(patches, call.get("protect", true));
  return status_json(editing(call));
}

Json weigh_marked(const Call& call) {
  session(call).protection().weigh(faces(call, "patches"), call.get<double>("factor"));
  return status_json(editing(call));
}

Json fit_session(const Call& call) {
  session(call).hands().fit();
  return status_json(editing(call));
}

Json undo_edit(const Call& call) {
  session(call).undo();
  return status_json(editing(call));
}

Json redo_edit(const Call& call) {
  session(call).redo();
  return status_json(editing(call));
}

Json find_patches(const Call& call) {
  const auto patches_in = call.get("touched", false) ? faces_touched : faces_covered;
  return numbers(patches_in(session(call).mesh(), to_pixels(call), lasso(call)));
}

Json find_out(const Call& call) {
  Session& s = session(call);
  s.hands().set_fits(call.get("fits", true));
  const AnalysisKind kind = analysis_named(call.get<std::string>("kind"));
  const Face patch = one_face(call);
  s.analyses().request(kind);
  if (call.get("wait", false)) s.analyses().wait();
  const std::shared_ptr<const Analysis> found = s.shown().analysis(kind);
  Json json{{"complete", found != nullptr},
            {"failure", found && found->failure ? message_json(*found->failure) : Json()}};
  if (!found) return json;
  if (kind == AnalysisKind::prices) json.update(prices_json(*found, editing(call)));
  if (kind == AnalysisKind::parts) json.update(parts_json(*found));
  if (kind == AnalysisKind::regions) json.update(regions_json(*found, call, patch));
  return json;
}

Json worst_places(const Call& call) {
  const Editing& e = editing(call);
  Json list = Json::array();
  for (const WorstPlace& worst : e.session.shown().worst_places(call.get("most", 8))) {
    const glm::dvec2 seen = e.view.point(worst.place);
    list.push_back({{"x", seen.x}, {"y", seen.y}, {"error", worst.error}});
  }
  return list;
}

Json paint_session(const Call& call) {
  Session& s = session(call);
  SessionView view;
  view.width = call.get<int>("width");
  view.height = call.get<int>("height");
  view.density = call.get("density", view.density);
  view.to_pixels = to_pixels(call);
  view.ground = ground_named(call.get<std::string>("ground", "result"));
  view.split = call.get("split", view.split);
  if (const auto known = call.get<std::string>("known", ""); !known.empty())
    view.analysis = analysis_named(known);
  view.patch = one_face(call);
  view.region = call.get("region", view.region);
  view.lines = call.get("lines", view.lines);
  view.handles = call.get("handles", view.handles);
  view.proposal = call.get("proposal", view.proposal);
  view.marked = faces(call, "marked");
  view.lasso = lasso(call);
  const Image image = paint(s, view);
  return {{"width", image.width},
          {"height", image.height},
          {"bytes", Json::binary(interleaved(image))}};
}

Json write_session(const Call& call) {
  WriteOptions writing;
  writing.remember_original = call.get("remember_original", writing.remember_original);
  writing.keep_original = call.get("keep_original", writing.keep_original);
  const MeshReport report = write_shown(call.document(), editing(call), writing);
  RunOptions options;
  options.metric = session(call).shown().problem().metric();
  Json json = results_json(call.document(), {report}, options, "").front();
  // The mesh of the session is no longer the document's.
  call.sessions().erase(call.get<std::string>("id"));
  return json;
}

}  // namespace gradmesh
