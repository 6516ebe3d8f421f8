#pragma once

#include <optional>

#include "ops/journal.h"

namespace gradmesh {

/// Splits a patch exactly, as split() does: by a line from left to right at `row`, from the top, by
/// one from top to bottom at `column`, from the left, or by both, which cross. Places are in (0,
/// 1); nothing for no such line. Each split is one operation of the journal.
void split_patch(Journal& journal, Face face, std::optional<double> row,
                 std::optional<double> column);

}  // namespace gradmesh
