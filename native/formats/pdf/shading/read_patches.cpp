#include "formats/pdf/shading/read_patches.h"

#include <optional>
#include <utility>

#include "geom/patch.h"

namespace gradmesh {
namespace {

void make_inner_points_coons(ShadingPatch& patch) {
  BezierNet net;
  const auto points = patch.net();
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) net[i][j].position = points[i][j];
  const auto inner = coons_interior(net);
  patch.inner = {inner[0][0], inner[0][1], inner[1][1], inner[1][0]};
}

/// Begins a patch at side `flag`, 1 to 3, of the one before.
ShadingPatch beside(const ShadingPatch& before, int flag) {
  const ShadingPatch turned = before.turned(std::size_t(flag));
  ShadingPatch patch;
  for (std::size_t n = 0; n < 4; ++n) patch.outer[n] = turned.outer[n];
  for (std::size_t k = 0; k < 2; ++k) patch.colors[k] = turned.colors[k];
  return patch;
}

/// Reads points or colours, from number `first` on. Returns false if the data end first.
template <class Values, class Read>
bool read_from(std::size_t first, Values& values, const Read& read) {
  for (std::size_t n = first; n < values.size(); ++n) {
    auto value = read();
    if (!value) return false;
    values[n] = *std::move(value);
  }
  return true;
}

/// Reads the points and colours of a patch that are not those of the one before. Returns nothing
/// if the data end first.
std::optional<ShadingPatch> rest_of(ShadingReader& data, ShadingPatch patch, bool is_new,
                                    PatchKind kind) {
  const auto point = [&] { return data.point(); };
  const bool is_whole = read_from(is_new ? 0 : 4, patch.outer, point) &&
                        (kind == PatchKind::coons || read_from(0, patch.inner, point)) &&
                        read_from(is_new ? 0 : 2, patch.colors, [&] { return data.color(); });
  if (!is_whole) return {};
  if (kind == PatchKind::coons) make_inner_points_coons(patch);
  return patch;
}

}  // namespace

ShadingPatches read_patches(std::string_view bytes, const Packing& packing, PatchKind kind,
                            std::size_t most) {
  ShadingPatches read;
  ShadingPatch last;
  for (ShadingReader data(bytes, packing); data.has_more(); data.end_record()) {
    const bool would_be_missed = data.has_much_more();
    const auto flag = data.flag();
    const bool is_new = flag == 0;
    std::optional<ShadingPatch> patch;
    if (flag && (is_new || read.count > 0))
      patch = rest_of(data, is_new ? ShadingPatch() : beside(last, *flag), is_new, kind);
    if (!patch) {
      read.is_damaged = would_be_missed;
      break;
    }
    last = *std::move(patch);
    if (read.count++ < most) read.patches.push_back(last);
  }
  return read;
}

}  // namespace gradmesh
