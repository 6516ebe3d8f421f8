#include "app/pages/page_form.h"

#include <algorithm>
#include <cstdlib>
#include <memory>

#include "app/pages/page_shapes.h"
#include "base/error.h"
#include "form/handles.h"
#include "form/smooth_colors.h"
#include "mesh/build.h"
#include "metric/metric.h"
#include "raster/rasterizer.h"
#include "simplify/options.h"

namespace gradmesh {
namespace {

/// How far, of 255, Illustrator's patches are from the smooth colours that they stand for, at most:
/// the picture of the page is no nearer to them than that. The share of the pixels for which it
/// must hold leaves out edges and seams.
constexpr int accuracy_of_pages = 4;
constexpr double most_pixels = 0.95;

Mesh in_pixels(MeshParts parts) {
  transform(parts, Affine::scaling(glm::dvec2(pixels_per_point)));
  return build_mesh(parts);
}

/// What a page shows of a shading, to which meshes are compared.
class PageLook {
 public:
  explicit PageLook(const Mesh& page)
      : frame_(fit_frame(page, {}, usual_resolution)),
        rasterizer_(make_software_rasterizer()),
        metric_(make_metric(MetricKind::flip, rasterizer_->paint(page, frame_))) {}

  Image seen(const Mesh& mesh) const {
    return rasterizer_->paint(mesh.is_smooth() ? painted_mesh(mesh) : mesh, frame_);
  }
  double flip(const Image& seen) const { return mean(metric_->map(seen)); }
  /// Returns true if the picture is as near to the page's as that is to smooth colours.
  bool is_accurate(const Image& seen) const {
    const Image& page = metric_->reference();
    std::size_t painted = 0, near = 0;
    for (int y = 0; y < page.height; ++y)
      for (int x = 0; x < page.width; ++x) {
        bool is_white = true, is_near = true;
        for (int channel = 0; channel < 3; ++channel) {
          const int a = *page.at(x, y, channel), b = *seen.at(x, y, channel);
          is_white = is_white && a == 255 && b == 255;
          is_near = is_near && std::abs(a - b) <= accuracy_of_pages;
        }
        if (is_white) continue;
        ++painted;
        if (is_near) ++near;
      }
    return double(near) >= most_pixels * double(painted);
  }

 private:
  const Frame frame_;
  const std::unique_ptr<Rasterizer> rasterizer_;
  const std::unique_ptr<Metric> metric_;
};

/// Returns the handles of the patches of the page, joined if they fit together so.
int handles_of_page(const MeshForm& joined, const MeshParts& loose) try {
  return count_handles(in_pixels(joined.mesh));
} catch (const InputError&) {
  return count_handles(in_pixels(loose));
}

}  // namespace

std::optional<ChosenForm> choose_form(const std::vector<PagePatch>& patches, MeshForms forms,
                                      const std::function<bool()>& goes_on) {
  const MeshParts loose = loose_mesh(patches);
  const PageLook page(in_pixels(loose));
  for (bool is_last = false; !is_last;) try {
      if (!goes_on()) return {};
      std::optional<MeshForm> form = forms.next();
      is_last = !form;
      // Without any joints the patches are a mesh as well, whatever they are.
      if (is_last) form = MeshForm{loose};
      Mesh mesh = in_pixels(form->mesh);
      const Image seen = page.seen(mesh);
      const double flip = page.flip(seen);
      const bool is_of_page = form->kind == MeshForm::Kind::page;
      // Smooth colours are what the patches of a page stand for, which are themselves, joined, what
      // the page shows.
      if (flip <= look_of_page || is_of_page ||
          (form->mesh.smooth && form->kind != MeshForm::Kind::joined && page.is_accurate(seen))) {
        const int handles = is_of_page ? count_handles(mesh) : handles_of_page(forms.page(), loose);
        return ChosenForm{form->kind, std::move(mesh), flip, handles};
      }
    } catch (const InputError&) {
      // Patches that do not fit together as these joints say.
      if (is_last) throw;
    }
  throw InputError("it has no patches");
}

}  // namespace gradmesh
