#pragma once

#include <filesystem>
#include <list>
#include <string>
#include <string_view>

#include "mesh/mesh.h"
#include "pricing/price_table.h"

namespace gradmesh {

/// Where known prices come from, and where those go that a run has used. Empty: neither.
struct AnalysisPaths {
  std::filesystem::path load, save;
  /// A folder where each mesh has a file of its own, named by its key: what is there is used, and
  /// what a run has used is kept for the next. Nothing depends on it: it may be emptied at any
  /// time, and what is damaged there or cannot be written is done without.
  std::filesystem::path cache = {};
};

/// The analyses in the text of such a file (AnalysisFiles); `name` is the file's, for messages.
/// Throws InputError where the text is something else, or damaged.
std::list<PriceTable> parse_analyses(std::string_view text, const std::string& name);

/// The first of its regions that is not in the mesh; null where all are.
const Region* misfit(const PriceTable& analysis, const Mesh& mesh);

/// The analyses of a document's meshes, kept in a file of their own (paper B.3): JSON,
///   {"format": "gradmesh analysis", "version": 2, "checksum": C, "analyses": [
///     {"original": H, "content": H, "metric": "flip", "width": w, "height": h,
///      "color_model": "bicubic", "prices": [[face, top, rows, columns, price, exact], ...]}]}
/// with hashes as 16 hexadecimal digits. The price of a region that cannot be merged is null; one
/// that is not exact is a number that the price is above. Which analysis belongs to which mesh
/// follows from the keys alone.
class AnalysisFiles {
 public:
  /// Throws InputError where the file to load cannot be read, is something else, or damaged.
  explicit AnalysisFiles(AnalysisPaths paths);

  /// What a run over `mesh` begins with, and adds to: the analysis with this key, or where no file
  /// is loaded the one in the cache, or an empty one. Throws InputError where the file holds none,
  /// with what differs where that can be told, and where regions do not fit the mesh.
  PriceTable& start(const PriceTableKey& key, const Mesh& mesh);

  /// Writes what was loaded and added, whole or not at all. Throws InputError naming the file.
  void save() const;

 private:
  std::filesystem::path cached(const PriceTableKey& key) const;
  PriceTable from_cache(const PriceTableKey& key, const Mesh& mesh) const;
  void save_to_cache() const;

  AnalysisPaths paths_;
  std::list<PriceTable> analyses_;
};

}  // namespace gradmesh
