#pragma once

#include <functional>

namespace radlab::grader {

/// The end of ForkServer in the program that it starts: forks for each request until the judge goes.
///
/// `work` runs in a process of its own with descriptors 0 to 3 as `run` gives them, and the filter of system calls for submissions;
/// it must not return. When it has ended, all that it started is killed.
/// @pre    one thread
/// @return when the judge has closed its end
void serveForks(const std::function<void()>& work);

}  // namespace radlab::grader
