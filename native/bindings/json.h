#pragma once

#include <pybind11/pybind11.h>

#include "service/arguments.h"

namespace gradmesh {

/// Returns a Python object as JSON: None, bool, numbers also of other types than int and float,
/// str, bytes, list, tuple and dict. Raises TypeError for others, OverflowError for whole numbers
/// beyond 64 bits, and UnicodeEncodeError for a str that is no Unicode.
Json json_from(pybind11::handle object);

/// Returns JSON as Python objects. What is no UTF-8 is replaced.
pybind11::object python_from(const Json& json);

}  // namespace gradmesh
