#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/document/document.h"
#include "app/runs/price_files.h"
#include "app/runs/runs.h"
#include "simplify/state_curve.h"

namespace gradmesh {

/// A mesh of a document, and the states that simplifying it passes.
struct MeshCurve {
  MeshEntry entry;
  Problem problem;
  MeshKind kind;
  StateCurve curve;
};

/// Returns the curves of the selected meshes: of blocks if `options.method` is `best`, of one
/// gradient if it is `plain`, and if it is `simplest` of one gradient where a mesh has such a
/// curve. Throws InputError as simplify() does, and std::invalid_argument for other methods and for
/// options that bound a run, as a curve has all errors.
std::vector<MeshCurve> find_curves(const Document& document, const std::vector<std::string>& ids,
                                   const RunOptions& options, PriceFiles& files);

/// Puts candidates into the places of their meshes in the document. Returns what became of them. A
/// mesh whose candidate is not changed stays as it is.
struct TakenState {
  MeshEntry entry;
  Problem problem;
  MeshKind kind;
  Candidate candidate;
};
std::vector<MeshReport> write_states(Document& document, std::vector<TakenState> states,
                                     const WriteOptions& writing);

/// Writes the state of that number, from 0, of each curve into the document, the last where a curve
/// has fewer; state 0 is the mesh as it is. Returns what became of the meshes.
std::vector<MeshReport> write_states(Document& document, const std::vector<MeshCurve>& curves,
                                     int number, const WriteOptions& writing);

}  // namespace gradmesh
