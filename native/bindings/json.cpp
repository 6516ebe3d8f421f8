#include "bindings/json.h"

namespace gradmesh {
namespace {

namespace py = pybind11;

Json whole_number(py::handle object) {
  const auto number = py::reinterpret_steal<py::object>(PyNumber_Index(object.ptr()));
  if (!number) throw py::error_already_set();
  int overflow = 0;
  const long long value = PyLong_AsLongLongAndOverflow(number.ptr(), &overflow);
  if (overflow == 0 && value < 0) return std::int64_t(value);
  const unsigned long long positive = PyLong_AsUnsignedLongLong(number.ptr());
  if (PyErr_Occurred()) throw py::error_already_set();
  return std::uint64_t(positive);
}

Json real_number(py::handle object) {
  const double number = PyFloat_AsDouble(object.ptr());
  if (number == -1 && PyErr_Occurred()) throw py::error_already_set();
  return number;
}

std::string text(py::handle object) {
  Py_ssize_t size = 0;
  const char* const text = PyUnicode_AsUTF8AndSize(object.ptr(), &size);
  if (!text) throw py::error_already_set();
  return {text, std::size_t(size)};
}

}  // namespace

Json json_from(py::handle object) {
  if (object.is_none()) return nullptr;
  if (py::isinstance<py::bool_>(object)) return object.cast<bool>();
  if (py::isinstance<py::str>(object)) return text(object);
  if (py::isinstance<py::bytes>(object)) {
    const std::string_view bytes = object.cast<std::string_view>();
    return Json::binary({bytes.begin(), bytes.end()});
  }
  if (py::isinstance<py::dict>(object)) {
    Json json = Json::object();
    for (const auto& [name, value] : py::reinterpret_borrow<py::dict>(object))
      json[text(name)] = json_from(value);
    return json;
  }
  if (py::isinstance<py::list>(object) || py::isinstance<py::tuple>(object)) {
    Json json = Json::array();
    for (const py::handle member : object) json.push_back(json_from(member));
    return json;
  }
  return PyIndex_Check(object.ptr()) ? whole_number(object) : real_number(object);
}

py::object python_from(const Json& json) {
  switch (json.type()) {
    case Json::value_t::boolean:
      return py::bool_(json.get<bool>());
    case Json::value_t::number_integer:
      return py::int_(json.get<std::int64_t>());
    case Json::value_t::number_unsigned:
      return py::int_(json.get<std::uint64_t>());
    case Json::value_t::number_float:
      return py::float_(json.get<double>());
    case Json::value_t::string: {
      const std::string& text = json.get_ref<const std::string&>();
      return py::reinterpret_steal<py::object>(
          PyUnicode_DecodeUTF8(text.data(), Py_ssize_t(text.size()), "replace"));
    }
    case Json::value_t::binary: {
      const auto& bytes = json.get_binary();
      return py::bytes(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    }
    case Json::value_t::array: {
      py::list list;
      for (const Json& member : json) list.append(python_from(member));
      return list;
    }
    case Json::value_t::object: {
      py::dict dict;
      for (const auto& [name, value] : json.items()) dict[py::str(name)] = python_from(value);
      return dict;
    }
    default:
      return py::none();
  }
}

}  // namespace gradmesh
