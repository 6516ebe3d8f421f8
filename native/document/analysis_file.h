#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mesh/mesh.h"
#include "select/analysis.h"

namespace gradmesh {

/// The analyses of a document's meshes, kept in a file of their own (paper B.3): JSON,
///   {"format": "gradmesh analysis", "version": 1, "checksum": C, "analyses": [
///     {"original": H, "content": H, "metric": "flip", "width": w, "height": h,
///      "color_model": "bicubic", "prices": [[face, top, rows, columns, price], ...]}]}
/// with hashes as 16 hexadecimal digits. The price of a region that cannot be merged is null. Which
/// analysis belongs to which mesh follows from the keys alone.
class AnalysisFile {
 public:
  /// Throws InputError where the file cannot be read, is something else, or damaged.
  static AnalysisFile read(const std::filesystem::path& path);

  /// The analysis of `mesh` with this key. Throws InputError where there is none, with what differs
  /// where that can be told, and where regions do not fit the mesh.
  const Analysis& find(const AnalysisKey& key, const Mesh& mesh) const;

 private:
  std::string name_;
  std::vector<Analysis> analyses_;
};

/// Writes them as one file, of equal keys the last. The file is whole or as it was before.
void write_analyses(const std::filesystem::path& path, const std::vector<Analysis>& analyses);

}  // namespace gradmesh
