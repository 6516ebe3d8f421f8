#include "select/analysis.h"

#include <bit>

namespace gradmesh {
namespace {

/// FNV-1a with 64 bits (draft-eastlake-fnv), over whole words.
class Hash {
 public:
  void add(std::uint64_t word) {
    for (int i = 0; i < 64; i += 8) value_ = (value_ ^ ((word >> i) & 0xff)) * 0x100000001b3;
  }
  void add(double x) { add(std::bit_cast<std::uint64_t>(x == 0 ? 0.0 : x)); }
  void add(int x) { add(std::uint64_t(std::uint32_t(x))); }
  void add(const Value& v) {
    for (int i = 0; i < 2; ++i) add(v.position[i]);
    for (int i = 0; i < 4; ++i) add(v.color[i]);
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325;
};

void add(Hash& hash, const Mesh& mesh) {
  for (const Face f : mesh.faces()) {
    const Patch patch = mesh.patch(f);
    for (const auto& row : patch.c)
      for (const Value& v : row) hash.add(v);
    for (const Halfedge h : mesh.sides(f)) {
      hash.add(h.value);
      hash.add(mesh.curve(h).value);
    }
  }
}

}  // namespace

AnalysisKey analysis_key(const Mesh& original, const Mesh& mesh, const Frame& frame,
                         MetricKind metric) {
  Hash hash;
  add(hash, original);
  add(hash, mesh);
  for (const glm::dvec2 p : {glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(0, 1)})
    for (int i = 0; i < 2; ++i) hash.add(frame.to_pixels.point(p)[i]);
  return {hash.value(), metric, frame.width, frame.height, mesh.color_model()};
}

double price(MergeTrial& trial, Analysis& analysis, const Region& name) {
  const auto known = analysis.prices.find(name);
  if (known != analysis.prices.end()) return known->second;
  const double error = trial.price(name, region_tops(trial.mesh(), name));
  analysis.prices.emplace(name, error);
  return error;
}

}  // namespace gradmesh
