#pragma once

#include <filesystem>
#include <list>
#include <string>
#include <string_view>

#include "mesh/mesh.h"
#include "pricing/price_table.h"

namespace gradmesh {

/// Where known prices are read from, and where the prices that a run has used are written to. An
/// empty path means that there is none.
struct PricePaths {
  std::filesystem::path load, save;
  /// A folder where each mesh has a file of its own, named by its key: prices there are used, and
  /// those that a run has used are kept for the next. Nothing depends on the folder: it may be
  /// emptied at any time, and files that are damaged or cannot be written are ignored.
  std::filesystem::path cache = {};
};

/// Returns the analyses in the text of a file as of PriceFiles. `name` is the file's, for
/// messages. Throws InputError if the text is something else, or damaged.
std::list<PriceTable> parse_analyses(std::string_view text, const std::string& name);

/// Returns the first region of the analysis that is not in the mesh; null if all are.
const Region* misfit(const PriceTable& analysis, const Mesh& mesh);

/// The analyses of a document's meshes, kept in a file of their own (paper B.3): JSON,
///   {"format": "gradmesh analysis", "version": 2, "checksum": C, "analyses": [
///     {"original": H, "content": H, "metric": "flip", "width": w, "height": h,
///      "color_model": "bicubic", "prices": [[face, top, rows, columns, price, exact], ...]}]}
/// with hashes as 16 hexadecimal digits. The price of a region that cannot be merged is null; one
/// that is not exact is a number that the price is above. Which analysis belongs to which mesh
/// follows from the keys alone.
class PriceFiles {
 public:
  /// Reads the file to load. Throws InputError if it cannot be read, is something else, or is
  /// damaged.
  explicit PriceFiles(PricePaths paths);

  /// Returns the analysis that a run over `mesh` begins with, and adds to: the one with this key in
  /// the file; if no file is loaded, the one in the cache, or an empty one. Throws InputError if
  /// the file holds none, with what differs if that is known, or if regions do not fit the mesh.
  PriceTable& start(const PriceTableKey& key, const Mesh& mesh);

  /// Writes the analyses, loaded and added, whole or not at all. Throws InputError naming the file.
  void save() const;

 private:
  std::filesystem::path cached(const PriceTableKey& key) const;
  PriceTable from_cache(const PriceTableKey& key, const Mesh& mesh) const;
  void save_to_cache() const;

  PricePaths paths_;
  std::list<PriceTable> analyses_;
};

}  // namespace gradmesh
