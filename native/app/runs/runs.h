#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/document/document.h"
#include "app/runs/price_files.h"
#include "simplify/simplify.h"

namespace gradmesh {

/// What became of one mesh of a document.
struct MeshReport {
  std::string id;
  SimplifyResult result;
  /// The value of MeshEntry::refused. If there is one, there is no result.
  std::optional<Message> refused = std::nullopt;
};

/// Returns the problem of a run over one mesh of a document: the mesh in the colour model that is
/// asked for, what it is measured against and how it will be written. It is measured against the
/// first of these that there is: `options.original`, given_original, the picture that the
/// mesh was traced from (MeshSource::traced_original), known_original, and the mesh as it was
/// before it was converted to another colour model. Prices are in one of `files`. Throws as
/// problem_of() does, with InputErrors that name the mesh, as MeshSource::covered does, and
/// std::invalid_argument if a weight is out of range.
Problem problem_of(const Document& document, const MeshEntry& entry, const RunOptions& options,
                   PriceFiles& files);

/// Simplifies the selected meshes of a document in place (simplify_as_asked). Meshes that cannot be
/// read are only reported. A mesh that does not become simpler stays as it is. If another colour
/// model than the mesh's own is asked for, the mesh is converted first, and the conversion counts
/// towards the error. If an analysis is loaded, it must hold prices for each of the meshes.
///
/// Throws InputError as simplify() does, and if the error of a mesh is above epsilon before
/// anything is merged. Throws std::invalid_argument as problem_of() does, if edges are named for
/// another method than `manual`, if `manual` has no edges, and if there are no prices to save. The
/// document is unchanged after an exception.
std::vector<MeshReport> simplify(Document& document, const std::vector<std::string>& ids,
                                 const RunOptions& options, const PricePaths& analyses = {},
                                 const WriteOptions& writing = {});
/// Returns the reports that simplify() would return, and changes nothing. With the method `manual`
/// reports the error of the edges even if the error is too large.
std::vector<MeshReport> preview(const Document& document, const std::vector<std::string>& ids,
                                RunOptions options, const PricePaths& analyses = {});
/// Prices the selected meshes up to epsilon and saves the prices. Returns the number of prices.
std::size_t analyze(const Document& document, const std::vector<std::string>& ids,
                    const RunOptions& options, const PricePaths& analyses);

}  // namespace gradmesh
