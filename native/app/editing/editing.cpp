#include "app/editing/editing.h"

#include "app/runs/curves.h"

namespace gradmesh {

Box Editing::box() const {
  Box box;
  const Mesh& mesh = session.shown().start().surface();
  for (const Halfedge curve : mesh.curves())
    for (const glm::dvec2 point : points_along(mesh.curve_of(curve), view)) box.add(point);
  return box;
}

std::unique_ptr<Editing> edit_by_eye(const Document& document, const MeshEntry& entry,
                                     const RunOptions& options) {
  auto files = std::make_unique<PriceFiles>(PricePaths{});
  const Problem problem = problem_of(document, entry, options, *files);
  return document.naming(entry, [&] {
    return std::unique_ptr<Editing>(new Editing{entry, std::move(files), document.view(entry),
                                                document.objects(entry), Session(problem)});
  });
}

MeshReport write_shown(Document& document, const Editing& editing, const WriteOptions& writing) {
  const Session& session = editing.session;
  Candidate shown = session.shown().is_unchanged() ? session.shown().problem().unchanged()
                                                   : session.shown().now();
  return write_states(document,
                      {{editing.entry, session.shown().problem_as_written(), session.shown().form(),
                        std::move(shown)}},
                      writing)
      .front();
}

}  // namespace gradmesh
