#pragma once

#include <gtest/gtest.h>

#include <string>

#include "files/atomic_file.h"
#include "service/service.h"

namespace gradmesh::test {

/// Returns the bytes of a document in samples/.
inline std::string sample(const std::string& name) {
  return read_bytes(std::string(GRADMESH_SOURCE_DIR) + "/samples/" + name);
}

inline Json bytes_json(const std::string& bytes) {
  return Json::binary({bytes.begin(), bytes.end()});
}

/// Returns the bytes that a result is.
inline std::string bytes_of(const Json& json) {
  if (!json.is_binary()) ADD_FAILURE() << "these are no bytes: " << json;
  return json.is_binary() ? std::string(json.get_binary().begin(), json.get_binary().end()) : "";
}

inline Json request(const std::string& function, const Json& arguments) {
  return {{"call", function}, {"arguments", arguments}};
}

inline Json parse_request(const std::string& bytes, bool translated = false) {
  return request(
      "parse", {{"bytes", bytes_json(bytes)}, {"name", "drawing.svg"}, {"translated", translated}});
}

inline Json no_answer(const Json& /*question*/) { return nullptr; }

/// A run over all meshes of a document, coarse, so that it takes a tenth of a second, with these
/// arguments.
inline Json simplify_request(const Json& document, const Json& more = Json::object()) {
  Json arguments = {
      {"document", document}, {"resolution", 32}, {"method", "best"}, {"renderer", "software"}};
  arguments.update(more);
  return request("simplify", arguments);
}

}  // namespace gradmesh::test
