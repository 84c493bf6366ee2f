#pragma once

namespace radlab {

/// Lets this process keep what it frees: large blocks come from the heap and go back to it, not to the system each time.
///
/// For programs that make the same large things again and again: new pages take the system's time. Where the library cannot
/// be told so, nothing happens.
void keepFreedMemory();

/// Gives the system what this process has freed so far, and joins what lies side by side.
///
/// For programs before they fork: what is not there need not be copied.
void giveBackFreedMemory();

}  // namespace radlab
