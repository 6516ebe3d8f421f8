#pragma once

#include <string>
#include <vector>

#include "base/message.h"
#include "window/eye/eye.h"

namespace gradmesh {

/// Return numbers as a language writes them.

/// A number with so many decimals.
Message fixed(double number, int decimals);
/// A change, with its sign, which one that is not seen in so many decimals has not.
Message signed_fixed(double number, int decimals);
/// An error with at most two digits that count, without powers of ten.
Message short_error(double error);
/// An error, which weights can bring above 1.
Message error_of(double error, int decimals);
/// The error that a mesh would have, and by how much that is another one.
Message error_after(double error, double before);

/// Return what a window says of the mesh that is looked at.

/// Lines on how the mesh is that is shown, always as many.
std::vector<Message> words_of_mesh(const Eye& eye);
/// What a click would do; there must be a proposal.
Message words_of_proposal(const Eye& eye);
/// What Undo takes back, and Redo makes again.
Message words_of_undo(const Session& session);
Message words_of_redo(const Session& session);
/// What is seen of the regions of a patch, and of the parts of a motorcycle graph.
Message words_of_regions(const Eye& eye);
Message words_of_parts(const Analysis& analysis);

}  // namespace gradmesh
