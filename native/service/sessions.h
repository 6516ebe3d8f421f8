#pragma once

#include <string>
#include <vector>

#include "app/editing/editing.h"
#include "service/call.h"

namespace gradmesh {

/// What the functions of sessions have in common: their arguments, and how they say how a session
/// is. Members are named as in docs/reference/helper.md.

/// Returns the session over the mesh that the argument `id` names. Throws std::invalid_argument if
/// there is none.
Editing& editing(const Call& call);
inline Session& session(const Call& call) { return editing(call).session; }

/// Returns the kind of that name. Throws std::invalid_argument with all names if there is none.
MeshKind kind_named(const std::string& wanted);

/// Returns the map from mesh units to the pixels of a picture, which shows the place (x, y) of what
/// a person sees in its middle.
Affine to_pixels(const Call& call);

/// Returns the patches of the mesh that is shown whose numbers are an argument.
std::vector<Face> faces(const Call& call, const std::string& name);

Json numbers(const std::vector<Face>& faces);
Json counts_json(const Candidate& shown, int objects);
Json status_json(const Editing& editing);

}  // namespace gradmesh
