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

/// A run over all meshes of a document, coarse, so that it takes a tenth of a second. `changes` are
/// arguments that are not the usual ones.
inline Json simplify_request(const Json& document, const Json& changes = Json::object()) {
  Json arguments = {
      {"document", document},
      {"ids", Json::array()},
      {"metric", "flip"},
      {"epsilon", 0.01},
      {"max_local_error", nullptr},
      {"handles", nullptr},
      {"patches", nullptr},
      {"ratio", nullptr},
      {"count", nullptr},
      {"resolution", 32},
      {"color_model", nullptr},
      {"visible_only", true},
      {"method", "best"},
      {"seed", 0},
      {"omega", 0.75},
      {"kappa", 0.05},
      {"edges", Json::array()},
      {"time_budget", 0},
      {"threads", 0},
      {"renderer", "software"},
      {"remember_original", true},
      {"keep_original", false},
      {"preview", false},
      {"original", nullptr},
      {"kind", nullptr},
      {"load_analysis", nullptr},
      {"save_analysis", nullptr},
      {"analysis_cache", nullptr},
  };
  arguments.update(changes);
  return request("simplify", arguments);
}

}  // namespace gradmesh::test
