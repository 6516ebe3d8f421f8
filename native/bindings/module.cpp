#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstring>

#include "base/error.h"
#include "document/document.h"
#include "mesh/mesh.h"

namespace py = pybind11;

namespace gradmesh {
namespace {

py::dict mesh_dict(const Document& document, const MeshEntry& entry) {
  py::object role = py::none();
  if (entry.role) role = py::str(*entry.role == PaintRole::fill ? "fill" : "stroke");
  return py::dict(py::arg("id") = entry.id, py::arg("role") = role,
                  py::arg("simplified") = entry.simplified,
                  py::arg("patches") = document.mesh(entry).face_count());
}

py::list meshes(const Document& document, const std::vector<std::string>& ids) {
  py::list list;
  for (const MeshEntry& entry : document.selected(ids)) list.append(mesh_dict(document, entry));
  return list;
}

std::vector<std::string> ids(const Document& document) {
  std::vector<std::string> found;
  for (const MeshEntry& entry : document.meshes()) found.push_back(entry.id);
  return found;
}

py::dict report_dict(const MeshReport& report) {
  const SimplifyResult& r = report.result;
  return py::dict(py::arg("id") = report.id, py::arg("patches_before") = r.patches_before,
                  py::arg("patches_after") = r.patches_after, py::arg("error") = r.error,
                  py::arg("evaluations") = r.evaluations, py::arg("stopped") = name(r.stopped),
                  py::arg("seconds") = r.seconds.total);
}

/// Called without the GIL. Ctrl+C in Python and an exception in the callback end the run.
ProgressCallback progress_callback(const py::object& callback) {
  return [callback](const Progress& p) {
    const py::gil_scoped_acquire gil;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (callback.is_none()) return true;
    const py::object answer = callback(p.done, p.total, p.patches, p.error);
    return answer.is_none() || answer.cast<bool>();
  };
}

py::list simplify_document(Document& document, const std::vector<std::string>& ids,
                           const std::string& method, const std::string& metric, double epsilon,
                           int resolution, std::uint64_t seed, double time_budget, int threads,
                           const py::object& progress) {
  SimplifyOptions options;
  options.method = method_named(method);
  options.metric = metric_named(metric);
  options.epsilon = epsilon;
  options.resolution = resolution;
  options.seed = seed;
  options.time_budget = time_budget;
  options.threads = threads;
  options.progress = progress_callback(progress);
  std::vector<MeshReport> reports;
  {
    const py::gil_scoped_release release;
    reports = document.simplify(ids, options);
  }
  py::list list;
  for (const MeshReport& report : reports) list.append(report_dict(report));
  return list;
}

py::array_t<std::uint8_t> render(const Document& document, const std::string& id, int resolution) {
  const MeshEntry entry = document.selected({id}).front();
  const Image image = document.render(entry, resolution, *make_software_rasterizer());
  py::array_t<std::uint8_t> array({image.height, image.width, 3});
  std::memcpy(array.mutable_data(), image.samples.data(), image.samples.size());
  return array;
}

}  // namespace
}  // namespace gradmesh

PYBIND11_MODULE(_core, m) {
  using namespace gradmesh;
  m.doc() = "The compiled core of gradmesh; use the package gradmesh.";
  m.attr("version") = GRADMESH_VERSION;
  py::register_exception<InputError>(m, "InputError", PyExc_ValueError);

  py::class_<Document>(m, "Document")
      .def_static("read_file", [](const std::string& path) { return Document::read_file(path); })
      .def_static("parse",
                  [](const py::bytes& bytes, const std::string& name) {
                    return Document::parse(std::string(bytes), name);
                  })
      .def_property_readonly("name", &Document::name)
      .def("ids", &ids)
      .def("meshes", &meshes, py::arg("ids"))
      .def("simplify", &simplify_document, py::kw_only(), py::arg("ids"), py::arg("method"),
           py::arg("metric"), py::arg("epsilon"), py::arg("resolution"), py::arg("seed"),
           py::arg("time_budget"), py::arg("threads"), py::arg("progress"))
      .def("render", &render, py::arg("id"), py::arg("resolution"))
      .def("bytes", [](const Document& d) { return py::bytes(d.bytes()); })
      .def("write_file", [](const Document& d, const std::string& path) { d.write_file(path); });
}
