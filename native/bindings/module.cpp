#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstring>

#include "app/convert.h"
#include "app/convert_for_run.h"
#include "app/devices.h"
#include "app/document.h"
#include "app/draw_document.h"
#include "app/edits.h"
#include "app/info.h"
#include "app/one_mesh.h"
#include "app/report_on_mesh.h"
#include "base/error.h"
#include "files/atomic_file.h"
#include "form/handles.h"
#include "mesh/mesh.h"
#include "report/report.h"

namespace py = pybind11;

namespace gradmesh {
namespace {

py::object input_error(const Message& message);

py::dict mesh_dict(const Document& document, const MeshEntry& entry) {
  py::object role = py::none();
  if (entry.role) role = py::str(*entry.role == PaintRole::fill ? "fill" : "stroke");
  py::dict dict(py::arg("id") = entry.id, py::arg("role") = role,
                py::arg("simplified") = entry.simplified, py::arg("smooth") = false,
                py::arg("handles") = 0, py::arg("patches") = 0, py::arg("objects") = 0,
                py::arg("refused") = py::none());
  if (entry.refused) {
    dict["refused"] = input_error(*entry.refused);
  } else {
    const Mesh mesh = document.mesh(entry);
    dict["smooth"] = mesh.is_smooth();
    dict["handles"] = count_handles(mesh);
    dict["patches"] = mesh.face_count();
    dict["objects"] = document.objects(entry);
  }
  return dict;
}

py::list meshes(const Document& document) {
  py::list list;
  for (const MeshEntry& entry : document.meshes())
    if (!entry.kept) list.append(mesh_dict(document, entry));
  // Says that there is none.
  if (list.empty()) document.selected({});
  return list;
}

std::vector<std::string> ids(const Document& document) {
  std::vector<std::string> found;
  for (const MeshEntry& entry : document.meshes())
    if (!entry.kept) found.push_back(entry.id);
  return found;
}

py::dict report_dict(const MeshReport& report) {
  const SimplifyResult& r = report.result;
  return py::dict(
      py::arg("id") = report.id, py::arg("method") = r.method,
      py::arg("handles_before") = r.handles_before, py::arg("handles_after") = r.handles_after,
      py::arg("patches_before") = r.patches_before, py::arg("patches_after") = r.patches_after,
      py::arg("objects") = r.objects, py::arg("changed") = r.changed, py::arg("error") = r.error,
      py::arg("local_error") = r.local_error, py::arg("evaluations") = r.evaluations,
      py::arg("renderer") = r.renderer,
      py::arg("stopped") = report.refused ? "refused" : name(r.stopped),
      py::arg("seconds") = r.seconds.total,
      py::arg("refused") = report.refused ? input_error(*report.refused) : py::none());
}

/// Called and copied without the GIL; the last copy is dropped with it. Ctrl+C in Python and an
/// exception in the callback end the run.
ProgressCallback progress_callback(const py::object& callback) {
  return [shared = std::make_shared<py::object>(callback)](const Progress& p) {
    const py::gil_scoped_acquire gil;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (shared->is_none()) return true;
    const py::object answer = (*shared)(p.done, p.total, p.patches, p.error, p.handles);
    return answer.is_none() || answer.cast<bool>();
  };
}

/// Says what happened to a device, from whichever thread without the GIL.
std::function<void(const std::string&)> device_callback(const py::object& callback) {
  return [shared = std::make_shared<py::object>(callback)](const std::string& reason) {
    const py::gil_scoped_acquire gil;
    (*shared)(reason);
  };
}

/// As of --renderer; `lost` is called with the reason where the cores have to do without.
void take_renderer(RunOptions& options, const std::string& name, const py::object& lost) {
  const auto tell = device_callback(lost);
  const py::gil_scoped_release release;
  use_renderer(options, renderer_named(name), tell);
}

py::list report_list(const std::vector<MeshReport>& reports) {
  py::list list;
  for (const MeshReport& report : reports) list.append(report_dict(report));
  return list;
}

/// Lets a document be measured against another one while it lives.
class MeasuredAgainst {
 public:
  MeasuredAgainst(Document& document, const Document* original) : document_(document) {
    document_.measure_against(original);
  }
  MeasuredAgainst(const MeasuredAgainst&) = delete;
  MeasuredAgainst& operator=(const MeasuredAgainst&) = delete;
  ~MeasuredAgainst() { document_.measure_against(nullptr); }

 private:
  Document& document_;
};

py::list simplify_document(Document& document, const std::vector<std::string>& ids,
                           RunOptions options, const AnalysisPaths& analyses,
                           bool remember_original, bool keep_original, bool preview,
                           const py::object& progress, const Document* original) {
  const MeasuredAgainst measured(document, original);
  options.progress = progress_callback(progress);
  std::vector<MeshReport> reports;
  {
    const py::gil_scoped_release release;
    reports = preview
                  ? document.preview(ids, options, analyses)
                  : document.simplify(ids, options, analyses, {remember_original, keep_original});
  }
  return report_list(reports);
}

py::tuple convert_for_run_of(Document& document, const std::string& kind,
                             const std::vector<std::string>& ids, const RunOptions& options,
                             const Document* original) {
  const MeasuredAgainst measured(document, original);
  const Format& to = format_named(kind);
  ConvertedRun run;
  {
    const py::gil_scoped_release release;
    run = convert_for_run(document, one_mesh(document, ids, "its id"), to, options);
  }
  return py::make_tuple(std::move(run.document), std::move(run.options));
}

py::list update_document(Document& document, const std::vector<std::string>& ids) {
  py::list list;
  for (const UpdateReport& report : document.update(ids))
    list.append(py::dict(py::arg("id") = report.id, py::arg("handles") = report.counts.handles,
                         py::arg("patches") = report.counts.patches,
                         py::arg("objects") = report.objects, py::arg("changed") = report.changed));
  return list;
}

std::size_t analyze_document(Document& document, const std::vector<std::string>& ids,
                             RunOptions options, const AnalysisPaths& analyses,
                             const py::object& progress, const Document* original) {
  const MeasuredAgainst measured(document, original);
  options.progress = progress_callback(progress);
  const py::gil_scoped_release release;
  return document.analyze(ids, options, analyses);
}

py::dict edit_dict(const EditReport& report) {
  return py::dict(py::arg("id") = report.id, py::arg("handles_before") = report.before.handles,
                  py::arg("handles_after") = report.after.handles,
                  py::arg("patches_before") = report.before.patches,
                  py::arg("patches_after") = report.after.patches,
                  py::arg("objects") = report.objects, py::arg("error") = report.error);
}

py::dict merge_document(Document& document, const std::vector<std::string>& ids,
                        const std::string& metric, int resolution) {
  return edit_dict(merge_blocks(document, ids, {metric_named(metric), resolution}));
}

py::dict refine_document(Document& document, const std::string& id, bool rows, bool columns,
                         double place, std::optional<int> row, std::optional<int> column,
                         bool whole, const std::string& metric, int resolution) {
  return edit_dict(refine(document, id, {rows, columns, place, row, column, whole},
                          {metric_named(metric), resolution}));
}

py::list to_one_mesh_document(Document& document, const std::vector<std::string>& ids,
                              const std::string& metric, int resolution) {
  py::list list;
  for (const EditReport& report : to_one_mesh(document, ids, {metric_named(metric), resolution}))
    list.append(edit_dict(report));
  return list;
}

/// Returns the mesh of the object with this id, its fill if fill and stroke are meshes. If there is
/// no id, or if it is that of an element around meshes, returns the only one there. Throws
/// InputError if there are several.
MeshEntry one_mesh(const Document& document, const std::optional<std::string>& id) {
  const std::vector<std::string> ids = id ? std::vector{*id} : std::vector<std::string>{};
  for (const MeshEntry& entry : document.selected(ids))
    if (entry.id == id) return entry;
  return one_mesh(document, ids, "its id");
}

py::dict convert_document(const Document& document, const std::string& kind,
                          const std::optional<std::string>& id, std::optional<int> subdivide,
                          std::optional<double> epsilon, const std::string& metric,
                          int resolution) {
  ConvertOptions options;
  options.epsilon = epsilon.value_or(options.epsilon);
  options.must_keep_epsilon = epsilon.has_value();
  options.subdivide = subdivide;
  options.metric = metric_named(metric);
  options.resolution = resolution;
  const Format& to = format_named(kind);
  Conversion conversion;
  {
    const py::gil_scoped_release release;
    conversion = convert(document, one_mesh(document, id), to, options);
  }
  const Document& made = *conversion.document;
  const int patches = made.mesh(made.meshes().front()).face_count();
  return py::dict(py::arg("document") = std::move(conversion.document),
                  py::arg("patches") = patches, py::arg("error") = conversion.error,
                  py::arg("lost_opacity") = conversion.lost_opacity);
}

std::string draw_document(const Document& document, const std::optional<std::string>& id,
                          const std::string& show, bool picture, const RunOptions& simplify,
                          const AnalysisPaths& analyses, const py::object& progress) {
  DrawOptions options;
  options.show = show_named(show);
  options.picture = picture;
  options.simplify = simplify;
  options.simplify.progress = progress_callback(progress);
  const py::gil_scoped_release release;
  return draw(document, one_mesh(document, id), options, analyses);
}

void write_report(Document& before, const Document& after, const std::string& path,
                  const std::optional<std::string>& id, ReportOptions options,
                  const py::object& progress, const Document* original) {
  options.pricing.progress = progress_callback(progress);
  const MeasuredAgainst measured(before, original);
  const py::gil_scoped_release release;
  write_bytes(path, report_html(report_on_mesh(before, one_mesh(before, id), after,
                                               one_mesh(after, id), options)));
}

py::tuple message_tuple(const Message& message);

py::object argument(const Message::Argument& argument) {
  if (const auto* message = std::get_if<Message>(&argument)) return message_tuple(*message);
  return py::str(std::get<std::string>(argument));
}

/// (template, arguments), where arguments are texts or such pairs.
py::tuple message_tuple(const Message& message) {
  py::list arguments;
  for (const Message::Argument& a : message.arguments()) arguments.append(argument(a));
  return py::make_tuple(message.text(), py::tuple(arguments));
}

/// InputError of the Python module.
py::handle& input_error_type() {
  static py::handle type;
  return type;
}

/// An InputError, which also says its message so that it can be translated.
py::object input_error(const Message& message) {
  py::object error = input_error_type()(message.english());
  error.attr("message") = message_tuple(message);
  return error;
}

void bind_errors(py::module_& m) {
  input_error_type() = py::exception<InputError>(m, "InputError", PyExc_ValueError).release();
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      std::rethrow_exception(std::move(thrown));
    } catch (const InputError& error) {
      PyErr_SetObject(input_error_type().ptr(), input_error(error.message()).ptr());
    }
  });
}

void bind_options(py::module_& m) {
  py::class_<RunOptions>(m, "SimplifyOptions")
      .def(py::init<>())
      .def_property(
          "method", [](const RunOptions& o) { return o.method; },
          [](RunOptions& o, const std::string& value) {
            method_named(value);
            o.method = value;
          })
      .def_property(
          "metric", [](const RunOptions& o) { return name(o.metric); },
          [](RunOptions& o, const std::string& value) { o.metric = metric_named(value); })
      .def_property(
          "color_model",
          [](const RunOptions& o) -> std::optional<std::string> {
            if (!o.color_model) return std::nullopt;
            return name(*o.color_model);
          },
          [](RunOptions& o, const std::optional<std::string>& value) {
            o.color_model.reset();
            if (value) o.color_model = color_model_named(*value);
          })
      .def_readwrite("epsilon", &RunOptions::epsilon)
      .def_readwrite("max_local_error", &RunOptions::max_local_error)
      .def_readwrite("handles", &RunOptions::handles)
      .def_readwrite("patches", &RunOptions::patches)
      .def_readwrite("ratio", &RunOptions::ratio)
      .def_property(
          "count",
          [](const RunOptions& o) -> std::optional<std::string> {
            if (!o.count) return std::nullopt;
            return name(*o.count);
          },
          [](RunOptions& o, const std::optional<std::string>& value) {
            o.count.reset();
            if (value) o.count = count_named(*value);
          })
      .def_readwrite("resolution", &RunOptions::resolution)
      .def_readwrite("visible_only", &RunOptions::visible_only)
      .def_readwrite("seed", &RunOptions::seed)
      .def_readwrite("omega", &RunOptions::omega)
      .def_readwrite("kappa", &RunOptions::kappa)
      .def_readwrite("edges", &RunOptions::edges)
      .def_readwrite("time_budget", &RunOptions::time_budget)
      .def_readwrite("threads", &RunOptions::threads)
      .def("use_renderer", &take_renderer);
  m.def("check_resolution", &check_resolution);
  py::class_<AnalysisPaths>(m, "AnalysisPaths")
      .def(py::init([](const std::string& load, const std::string& save, const std::string& cache) {
             return AnalysisPaths{load, save, cache};
           }),
           py::arg("load"), py::arg("save"), py::arg("cache"));
  py::class_<ReportOptions>(m, "ReportOptions")
      .def(py::init([](const RunOptions& pricing, const AnalysisPaths& analyses,
                       const std::string& run, const std::optional<std::string>& metric,
                       std::optional<double> epsilon, std::optional<int> resolution) {
             ReportOptions options{run, std::nullopt, epsilon, resolution, pricing, analyses};
             if (metric) options.metric = metric_named(*metric);
             return options;
           }),
           py::kw_only(), py::arg("pricing"), py::arg("analyses"), py::arg("run"),
           py::arg("metric"), py::arg("epsilon"), py::arg("resolution"));
}

py::array_t<std::uint8_t> render(const Document& document, const std::optional<std::string>& id,
                                 int resolution, bool like_inkscape, const Document* framed_as) {
  const MeshEntry entry = one_mesh(document, id);
  const Image image =
      like_inkscape ? document.render_like_inkscape(entry, resolution, framed_as)
                    : document.render(entry, resolution, *make_software_rasterizer(), framed_as);
  py::array_t<std::uint8_t> array({image.height, image.width, 3});
  std::ranges::copy(interleaved(image), array.mutable_data());
  return array;
}

/// An array of height x width x 3.
using Pixels = py::array_t<std::uint8_t>;

Image image_of(const Pixels& array) {
  if (array.ndim() != 3 || array.shape(2) != 3 || array.size() == 0)
    throw std::invalid_argument("a picture is an array of height x width x 3 bytes.");
  Image image(int(array.shape(1)), int(array.shape(0)));
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (int c = 0; c < 3; ++c) *image.at(x, y, c) = array.at(y, x, c);
  return image;
}

double compare(const Pixels& reference, const Pixels& test, const std::string& metric) {
  const Image a = image_of(reference), b = image_of(test);
  if (a.width != b.width || a.height != b.height)
    throw std::invalid_argument("the pictures are not of one size.");
  const MetricKind kind = metric_named(metric);
  const py::gil_scoped_release release;
  return mean(make_metric(kind, a)->map(b));
}

}  // namespace
}  // namespace gradmesh

PYBIND11_MODULE(_core, m) {
  using namespace gradmesh;
  m.doc() = "The compiled core of gradmesh; use the package gradmesh.";
  m.attr("version") = GRADMESH_VERSION;
  bind_errors(m);
  bind_options(m);
  m.def("compare", &compare, py::arg("reference").noconvert(), py::arg("test").noconvert(),
        py::arg("metric"));
  py::class_<Document>(m, "Document")
      .def_static("read_file", [](const std::string& path) { return Document::read_file(path); })
      .def_static("parse",
                  [](const py::bytes& bytes, const std::string& name) {
                    return Document::parse(std::string(bytes), name);
                  })
      .def_property_readonly("name", &Document::name)
      .def_property_readonly("kind", [](const Document& d) { return d.format().name; })
      .def("set_translation", &Document::set_translation)
      .def("ids", &ids)
      .def("meshes", &meshes)
      .def("simplify", &simplify_document, py::kw_only(), py::arg("ids"), py::arg("options"),
           py::arg("analyses"), py::arg("remember_original"), py::arg("keep_original"),
           py::arg("preview"), py::arg("progress"), py::arg("original"))
      .def("convert_for_run", &convert_for_run_of, py::kw_only(), py::arg("kind"), py::arg("ids"),
           py::arg("options"), py::arg("original"))
      .def("update", &update_document, py::arg("ids"))
      .def("analyze", &analyze_document, py::kw_only(), py::arg("ids"), py::arg("options"),
           py::arg("analyses"), py::arg("progress"), py::arg("original"))
      .def("report", &write_report, py::kw_only(), py::arg("after"), py::arg("path"), py::arg("id"),
           py::arg("options"), py::arg("progress"), py::arg("original"))
      .def("merge", &merge_document, py::kw_only(), py::arg("ids"), py::arg("metric"),
           py::arg("resolution"))
      .def("refine", &refine_document, py::kw_only(), py::arg("id"), py::arg("rows"),
           py::arg("columns"), py::arg("place"), py::arg("row"), py::arg("column"),
           py::arg("whole"), py::arg("metric"), py::arg("resolution"))
      .def("to_one_mesh", &to_one_mesh_document, py::kw_only(), py::arg("ids"), py::arg("metric"),
           py::arg("resolution"))
      .def("draw", &draw_document, py::kw_only(), py::arg("id"), py::arg("show"),
           py::arg("picture"), py::arg("options"), py::arg("analyses"), py::arg("progress"))
      .def("render", &render, py::arg("id"), py::arg("resolution"), py::arg("like_inkscape"),
           py::arg("framed_as"))
      .def("info", &info_text)
      .def("convert", &convert_document, py::kw_only(), py::arg("kind"), py::arg("id"),
           py::arg("subdivide"), py::arg("epsilon"), py::arg("metric"), py::arg("resolution"))
      .def("bytes", [](const Document& d) { return py::bytes(d.bytes()); })
      .def("write_file", [](const Document& d, const std::string& path) { d.write_file(path); });
}
