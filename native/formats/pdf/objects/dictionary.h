#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "base/affine.h"
#include "formats/pdf/objects/qpdf.h"

namespace gradmesh {

/// Returns a finite number of an object; nothing if it is none.
inline std::optional<double> number_of(QPDFObjectHandle object) {
  if (!object.isNumber()) return {};
  const double number = object.getNumericValue();
  return std::isfinite(number) ? std::optional(number) : std::nullopt;
}

/// Returns the elements of an array; none if it is none.
inline std::vector<QPDFObjectHandle> elements_of(QPDFObjectHandle object) {
  return object.isArray() ? object.getArrayAsVector() : std::vector<QPDFObjectHandle>();
}

/// Returns the numbers of an array; empty if it is none, or holds something else.
inline std::vector<double> numbers_of(QPDFObjectHandle object) {
  std::vector<double> numbers;
  if (!object.isArray()) return numbers;
  for (QPDFObjectHandle each : object.getArrayAsVector()) {
    const auto number = number_of(each);
    if (!number) return {};
    numbers.push_back(*number);
  }
  return numbers;
}

/// Returns what a dictionary, or that of a stream, holds; null, of PDF, if it is neither.
inline QPDFObjectHandle value_of(QPDFObjectHandle object, const std::string& key) {
  if (object.isStream()) object = object.getDict();
  return object.isDictionary() ? object.getKey(key) : QPDFObjectHandle::newNull();
}

/// Returns the map of an array [a b c d e f]; the identity if it is none.
inline Affine matrix_of(QPDFObjectHandle object) {
  const std::vector<double> n = numbers_of(object);
  if (n.size() != 6) return {};
  return {glm::dmat2(n[0], n[1], n[2], n[3]), {n[4], n[5]}};
}

}  // namespace gradmesh
