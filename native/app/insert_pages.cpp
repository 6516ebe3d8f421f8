#include "app/insert_pages.h"

#include "app/page_objects.h"
#include "app/svg_meshes.h"
#include "files/atomic_file.h"

namespace gradmesh {

FoundPages insert_pages(Document& document, const std::filesystem::path& path,
                        const PageChoice& choice, const std::string& into) {
  SvgMeshes& svg = document.as_svg(
      Message("{0}: meshes of pages are put into SVG documents alone.", document.name()));
  const std::string name = path.string();
  const std::string bytes = read_bytes(path);
  if (!holds_pages(bytes)) throw InputError("{0}: it is no PDF document.", name);
  PageMeshes read = read_page_meshes(bytes, name, choice);
  for (SvgPage& page : read.pages)
    page.name = read.pages.size() == 1
                    ? path.filename().string()
                    : page_name(std::size_t(page.number)).in(document.translation());
  std::size_t next = 0;
  svg.add_pages(read.pages, into, [&](PagesInSvg& pages) {
    write_objects(read.objects, document.translation(), [&](std::size_t page, const NewMesh& mesh) {
      read.found.meshes[next++].id = pages.add(page, mesh);
    });
  });
  return std::move(read.found);
}

}  // namespace gradmesh
