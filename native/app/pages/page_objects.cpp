#include "app/pages/page_objects.h"

#include "app/document/mesh_label.h"
#include "app/document/svg_rules.h"
#include "simplify/options.h"

namespace gradmesh {

Message page_name(std::size_t number) { return Message("Page {0}", number); }

void write_objects(const std::vector<PageObject>& objects, const Translation& language,
                   const std::function<void(std::size_t page, const NewMesh& mesh)>& add) {
  for (const PageObject& object : objects) {
    const Mesh& mesh = object.mesh;
    const std::vector<SvgShape>& shapes = object.shapes;
    const WrittenForm form = exact_block_rules()->form(mesh, fit_frame(mesh, {}, usual_resolution));
    const MeshCounts counts = counts_of(form.surface);
    const MeshCounts before{object.handles, object.patches};
    const Message label =
        object.patches > counts.patches ? mesh_label(counts, before) : mesh_label(counts);
    NewMesh made{object.id,
                 shapes.front(),
                 {shapes.rbegin(), shapes.rend() - 1},
                 {mesh, *form.blocks, label.in(language), before}};
    made.stroke = object.stroke;
    made.blend_mode = object.blend_mode;
    made.to_page = object.to_page;
    made.groups = object.groups;
    add(object.page, made);
  }
}

}  // namespace gradmesh
