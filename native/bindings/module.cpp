#include <pybind11/pybind11.h>

#include <optional>

#include "bindings/json.h"
#include "service/service.h"

namespace py = pybind11;

namespace gradmesh {
namespace {

/// Asks a Python function without the GIL. What it raises gives the call up, and is kept.
class Asking {
 public:
  explicit Asking(const py::function& function) : function_(function) {}

  Json operator()(const Json& question) {
    const py::gil_scoped_acquire gil;
    try {
      // Ctrl+C.
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      return json_from(function_(python_from(question)));
    } catch (const py::error_already_set& error) {
      raised_ = error;
      throw GivenUp();
    }
  }

  /// Raises what the function has raised, if it has raised anything. Needs the GIL.
  void raise() const {
    if (raised_) throw *raised_;
  }

 private:
  const py::function& function_;
  std::optional<py::error_already_set> raised_;
};

py::object call(Service& service, const py::dict& request, const py::function& ask) {
  const Json json = json_from(request);
  Asking asking(ask);
  Json outcome;
  {
    const py::gil_scoped_release release;
    outcome = service.call(json, std::ref(asking));
  }
  asking.raise();
  return python_from(outcome);
}

}  // namespace
}  // namespace gradmesh

PYBIND11_MODULE(_core, m) {
  using namespace gradmesh;
  m.doc() = "The compiled core of gradmesh; use the package gradmesh.";
  m.attr("protocol") = Service::version;
  py::class_<Service>(m, "Service")
      .def(py::init<>())
      .def("call", &call, py::arg("request"), py::arg("ask"));
}
