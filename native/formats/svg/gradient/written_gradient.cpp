#include "formats/svg/gradient/written_gradient.h"

#include <charconv>
#include <cstdio>

#include "base/hash.h"
#include "base/power_of_ten.h"
#include "form/blocks.h"
#include "formats/svg/gradient/color_texts.h"
#include "formats/svg/gradient/mesh_gradient.h"
#include "formats/svg/tree/own.h"
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

std::string original_name(PaintRole role) { return paint_name(role) + std::string("-original"); }
std::string fingerprint_name(PaintRole role) { return paint_name(role) + std::string("-written"); }

/// Returns the fingerprint of a gradient whose coordinates are multiples of a decimal step: the
/// step's exponent and a hash of the type, the rows and columns, all points in steps and all
/// colours in 8 bits. It stays the same where numbers are rounded, by less than half a step in
/// corners and handles. Throws InputError as gradient_patches does.
std::string gradient_fingerprint(const SvgTree& tree, const xmlNode* gradient, double step) {
  const PatchGrid grid = gradient_patches(tree, gradient);
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

}  // namespace

std::optional<std::string> original_of(const MeshObject& object) {
  return own_attribute(object.node, original_name(object.role).c_str());
}

bool is_as_written(const SvgTree& tree, const MeshObject& object) {
  const auto written = own_attribute(object.node, fingerprint_name(object.role).c_str());
  int exponent = 0;
  if (!written) return false;
  const auto [end, error] =
      std::from_chars(written->data(), written->data() + written->size(), exponent);
  constexpr int finest = -9;
  if (error != std::errc{} || exponent > 0 || exponent < finest) return false;
  return gradient_fingerprint(tree, object.gradient, power_of_ten(exponent)) == *written;
}

void remember_original(SvgTree& tree, const MeshObject& object, const Mesh& mesh,
                       double coons_tolerance, const std::string& original) {
  const Affine to_gradient = mesh_to_gradient(tree, object);
  double step = gradient_form(mesh, coons_tolerance, to_gradient).precision.step;
  // Coordinates that are kept to the last bit are multiples of none: another program that rounds
  // them may make the mesh count as edited.
  if (step == 0) step = gradient_precision(coons_tolerance, to_gradient).step;
  if (step == 0) return;
  set_own_attribute(object.node, original_name(object.role).c_str(), original);
  set_own_attribute(object.node, fingerprint_name(object.role).c_str(),
                    gradient_fingerprint(tree, object.gradient, step));
}

void forget_original(const MeshObject& object) {
  for (const std::string& name : {original_name(object.role), fingerprint_name(object.role)})
    set_own_attribute(object.node, name.c_str(), "");
  remember_color_texts(object, {});
}

}  // namespace gradmesh
