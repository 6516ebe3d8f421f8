#include "app/pages/insert_pages.h"

#include "app/document/svg_document.h"
#include "app/pages/page_objects.h"
#include "app/pages/tiles_of_meshes.h"
#include "files/atomic_file.h"

namespace gradmesh {

InsertedPages insert_pages(Document& document, const std::filesystem::path& path,
                           const InsertOptions& options) {
  SvgDocument& svg = as_svg(
      document, Message("{0}: meshes of pages are put into SVG documents alone.", document.name()));
  const std::string name = path.string();
  const std::string bytes = read_bytes(path);
  if (!holds_pages(bytes)) throw InputError("{0}: it is no PDF document.", name);
  PageMeshes read = read_page_meshes(bytes, name, options.pages);
  // It was stopped before there was one.
  if (read.objects.empty()) return {std::move(read.found)};
  for (SvgPage& page : read.pages)
    page.name = read.pages.size() == 1
                    ? path.filename().string()
                    : page_name(std::size_t(page.number)).in(document.translation());
  InsertedPages inserted;
  svg.add_pages(read.pages, options.into, [&](PagesInSvg& pages, const auto& groups) {
    std::vector<Affine> places;
    for (std::size_t n = 0; n < read.pages.size(); ++n) places.push_back(pages.place(n));
    std::vector<PartOfTiles> tiles(read.objects.size());
    if (options.replace_tiles) tiles = tiles_of_meshes(read.objects, places, groups);
    std::size_t next = 0;
    write_objects(read.objects, document.translation(), [&](std::size_t page, const NewMesh& mesh) {
      const PartOfTiles& instead = tiles[next];
      inserted.replaced += instead.count() > 0;
      read.found.meshes[next++].id =
          instead.count() > 0 ? pages.add_instead(instead, page, mesh) : pages.add(page, mesh);
    });
  });
  inserted.found = std::move(read.found);
  return inserted;
}

}  // namespace gradmesh
