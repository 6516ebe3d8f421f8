#include "app/editing/patch_choice.h"

#include <algorithm>
#include <stdexcept>

#include "formats/text/excerpt.h"

namespace gradmesh {
namespace {

/// Returns the lines, or all of `count`. `no_such` makes the message for one that is not there.
template <class NoSuch>
LineRange lines_of(const std::optional<LineRange>& lines, int count, const NoSuch& no_such) {
  if (!lines) return {1, count};
  if (lines->first > lines->last)
    throw std::invalid_argument("rows and columns run from the first to the last.");
  if (lines->first < 1) throw InputError(no_such(lines->first));
  if (lines->last > count) throw InputError(no_such(lines->last));
  return *lines;
}

/// Appends the patches of a rectangle in the chosen rows and columns.
void append_faces(const Mesh& mesh, const Rectangle& rectangle, const PatchChoice& choice,
                  std::vector<Face>& faces) {
  const LineRange rows = lines_of(choice.rows, rectangle.rows, [&](int row) {
    return Message("it has no row {0}, only {1} of them.", row, rectangle.rows);
  });
  const LineRange columns = lines_of(choice.columns, rectangle.columns, [&](int column) {
    return Message("it has no column {0}, only {1} of them.", column, rectangle.columns);
  });
  for (int i = rows.first; i <= rows.last; ++i)
    for (int j = columns.first; j <= columns.last; ++j)
      faces.push_back(mesh.face(rectangle.top(i - 1, j - 1)));
}

ChosenFaces faces_numbered(const MeshSource& document, const PatchChoice& choice) {
  if (choice.rows || choice.columns)
    throw std::invalid_argument("patches are chosen by numbers, or by rows and columns.");
  ChosenFaces chosen{one_mesh(document, choice.ids), {}};
  for (const int number : choice.patches)
    chosen.faces.push_back(face_numbered(document, chosen.entry, number));
  std::ranges::sort(chosen.faces);
  chosen.faces.erase(std::unique(chosen.faces.begin(), chosen.faces.end()), chosen.faces.end());
  return chosen;
}

ChosenFaces faces_of_rectangles(const MeshSource& document, const PatchChoice& choice) {
  std::vector<std::string> ids = choice.ids;
  if (ids.empty()) ids = {one_mesh(document, ids).id};
  std::ranges::sort(ids);
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  if (ids.size() > 1 && (choice.rows || choice.columns))
    throw InputError("{0}: rows and columns are those of one block; choose one.", document.name());
  std::optional<ChosenFaces> chosen;
  for (const std::string& id : ids) {
    const ChosenPatches block = document.rectangle(id);
    if (!chosen) chosen = {block.entry, {}};
    if (chosen->entry.index != block.entry.index)
      throw InputError("{0}: the blocks {1} and {2} are of different meshes.", document.name(),
                       excerpt(ids.front()), excerpt(id));
    try {
      append_faces(document.mesh(block.entry), block.rectangle, choice, chosen->faces);
    } catch (const InputError& error) {
      throw InputError("{0}: {1}: {2}", document.name(), excerpt(id), error.message());
    }
  }
  return *chosen;
}

}  // namespace

ChosenFaces chosen_faces(const MeshSource& document, const PatchChoice& choice) {
  ChosenFaces chosen = choice.patches.empty() ? faces_of_rectangles(document, choice)
                                              : faces_numbered(document, choice);
  check_editable(document, chosen.entry);
  return chosen;
}

Face face_numbered(const MeshSource& document, const MeshEntry& entry, int number) {
  const int count = int(document.mesh(entry).face_slots());
  if (number < 0 || number >= count)
    throw InputError("{0}: there is no patch {1}; the last is {2}.", document.name(), number,
                     count - 1);
  return Face{number};
}

void check_editable(const MeshSource& document, const MeshEntry& entry) {
  if (document.mesh(entry).is_smooth())
    throw InputError(
        "{0}: its colours follow those of the neighbours (type=\"bicubic\"), so that its patches "
        "are not edited one by one.",
        document.describe(entry));
}

}  // namespace gradmesh
