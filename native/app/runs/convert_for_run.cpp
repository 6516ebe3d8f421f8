#include "app/runs/convert_for_run.h"

#include "app/document/originals.h"
#include "app/runs/convert.h"

namespace gradmesh {
namespace {

/// The share of epsilon up to which patches are split; what is left is for merging.
constexpr double for_splitting = 0.9;

}  // namespace

ConvertedRun convert_for_run(const Document& from, const MeshEntry& entry, const Format& to,
                             RunOptions options) {
  ConvertOptions how;
  how.original = given_original(from, entry);
  how.metric = options.metric;
  how.resolution = options.resolution;
  if (!options.has_target()) how.epsilon = for_splitting * options.epsilon;
  Conversion conversion = convert(from, entry, to, how);
  if (conversion.lost_opacity)
    throw InputError(
        "{0}: the mesh {1} has opacities, which {2} cannot hold; gradmesh convert shows what is "
        "lost.",
        from.name(), entry.id, to.label);
  if (!to.holds(ColorModel::bicubic) && !options.has_target() && conversion.error > options.epsilon)
    throw InputError("{0}: written as {1} its error is {2} at least, above epsilon.", from.name(),
                     to.label, std::to_string(conversion.error));
  conversion.document->set_translation(from.translation());
  options.original = original_of(std::make_shared<const Mesh>(std::move(conversion.original)));
  if (!options.color_model) options.color_model = ColorModel::bilinear;
  return {std::move(conversion.document), std::move(options)};
}

}  // namespace gradmesh
