#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "app/runs/price_files.h"
#include "base/hash.h"
#include "meshes.h"
#include "target.h"

namespace gradmesh::fuzz {
namespace {

using Json = nlohmann::ordered_json;

void check_file(std::string_view text) {
  static const Mesh mesh = test::grid_mesh({.rows = 3, .columns = 2});
  accepts([&] {
    for (const PriceTable& analysis : parse_analyses(text, input_name)) misfit(analysis, mesh);
  });
}

/// The checksum of a file keeps random bytes from everything behind it, so these are given theirs.
void check_analyses(std::string_view text) {
  Json analyses = Json::parse(text, nullptr, false);
  if (analyses.is_discarded()) return;
  Hash hash;
  try {
    hash.add(analyses.dump());
  } catch (const Json::exception&) {
    return;  // text that is no UTF-8 has no checksum, and a file that holds it none that is right
  }
  char sum[17];
  std::snprintf(sum, sizeof sum, "%016llx", static_cast<unsigned long long>(hash.value()));
  const Json file{{"format", "gradmesh analysis"},
                  {"version", 2},
                  {"checksum", sum},
                  {"analyses", std::move(analyses)}};
  check_file(file.dump());
}

}  // namespace

/// A file, or the value of its `analyses`.
void check(std::string_view text) {
  text.starts_with('[') ? check_analyses(text) : check_file(text);
}

}  // namespace gradmesh::fuzz
