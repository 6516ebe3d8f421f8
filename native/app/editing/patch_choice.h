#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/document/mesh_source.h"

namespace gradmesh {

/// Rows or columns from the first to the last, counted from 1.
struct LineRange {
  int first = 1, last = 1;
};

/// Which patches a person means.
struct PatchChoice {
  /// Blocks of simplified meshes, or meshes that are one rectangle, by id. With `patches` the mesh
  /// in which they are; nothing for the only mesh of the document.
  std::vector<std::string> ids = {};
  /// Patches by their numbers, as drawings tell them.
  std::vector<int> patches = {};
  /// Which rows and columns of the one block or mesh; nothing for all.
  std::optional<LineRange> rows = std::nullopt, columns = std::nullopt;

  bool is_empty() const { return ids.empty() && patches.empty() && !rows && !columns; }
};

/// Patches of one mesh.
struct ChosenFaces {
  MeshEntry entry;
  /// Each once: of a block row by row, or in the order of their numbers.
  std::vector<Face> faces;
};

/// Returns the patches that are chosen. Throws InputError, which names the document, if there are
/// none of that name or number, or if they are of several meshes, and std::invalid_argument if rows
/// or columns run backwards or are chosen beside numbers.
ChosenFaces chosen_faces(const MeshSource& document, const PatchChoice& choice);

/// Returns the face with a number in the mesh of an entry. Throws InputError if there is none.
Face face_numbered(const MeshSource& document, const MeshEntry& entry, int number);

/// Throws InputError if the patches of the mesh of an entry are not edited one by one: if its
/// colours follow those of the neighbours.
void check_editable(const MeshSource& document, const MeshEntry& entry);

}  // namespace gradmesh
