#pragma once

#include <string>
#include <vector>

#include "base/message.h"
#include "window/eye/eye.h"

namespace gradmesh {

/// Returns a number with so many decimals.
std::string fixed(double number, int decimals);
/// Returns a change, with its sign.
std::string signed_fixed(double number, int decimals);
/// Returns an error with at most two digits that count, without powers of ten.
std::string short_error(double error);

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
