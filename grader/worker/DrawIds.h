#pragma once

namespace radlab::grader {

/// Draws `polygons` in the colours of their IDs where the submission's renderPatchIDs is not what is judged.
///
/// @pre a GL context is current, its state set for an ID pass
void drawIds();

}  // namespace radlab::grader
