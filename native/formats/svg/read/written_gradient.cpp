#include "formats/svg/read/written_gradient.h"

#include <charconv>
#include <cstdio>

#include "base/hash.h"
#include "base/power_of_ten.h"
#include "formats/svg/read/read_group.h"
#include "formats/svg/read/read_mesh.h"
#include "formats/svg/xml/node.h"

namespace gradmesh {
namespace {

void add_rounded(Hash& hash, double x) { hash.add(std::uint64_t(std::llround(x))); }

void add_patch(Hash& hash, const Patch& patch, double step) {
  const auto add = [&](glm::dvec2 p) {
    add_rounded(hash, p.x / step);
    add_rounded(hash, p.y / step);
  };
  const BezierNet net = bezier_net(patch);
  const auto coons = coons_interior(net);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      const bool inside = i % 3 != 0 && j % 3 != 0;
      // From the Coons patch it is zero where there is no tensor.
      add(inside ? net[i][j].position - coons[i - 1][j - 1] : net[i][j].position);
    }
  for (int k = 0; k < 4; ++k)
    for (int channel = 0; channel < 4; ++channel)
      add_rounded(hash, 255 * patch.corner(k).color[channel]);
}

}  // namespace

std::string original_name(PaintRole role) {
  return role == PaintRole::fill ? "fill-original" : "stroke-original";
}
std::string fingerprint_name(PaintRole role) {
  return role == PaintRole::fill ? "fill-written" : "stroke-written";
}

std::string gradient_fingerprint(const SvgDocument& document, const xmlNode* gradient,
                                 double step) {
  const PatchGrid grid = gradient_patches(document, gradient);
  Hash hash;
  hash.add(int(is_smooth(gradient)));
  hash.add(grid.rows);
  hash.add(grid.columns);
  for (const Patch& patch : grid.patches) add_patch(hash, patch, step);
  char text[32];
  std::snprintf(text, sizeof text, "%d %016llx", int(std::lround(std::log10(step))),
                static_cast<unsigned long long>(hash.value()));
  return text;
}

bool is_as_written(const SvgDocument& document, const MeshObject& object) {
  const auto written =
      attribute(object.node, fingerprint_name(object.role).c_str(), gradmesh_namespace);
  int exponent = 0;
  if (!written) return false;
  const auto [end, error] =
      std::from_chars(written->data(), written->data() + written->size(), exponent);
  constexpr int finest = -9;
  if (error != std::errc{} || exponent > 0 || exponent < finest) return false;
  return gradient_fingerprint(document, object.gradient, power_of_ten(exponent)) == *written;
}

}  // namespace gradmesh
