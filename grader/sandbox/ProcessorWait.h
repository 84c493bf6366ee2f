#pragma once

#include <sys/types.h>

namespace radlab::grader {

/// How long a process and those that it started were ready to run while every processor was busy with others.
///
/// What they ran is counted against the time between two looks; what is missing was waiting if one of them is ready at the
/// second look, and sleeping otherwise. Where the kernel does not say, nothing was waiting.
class ProcessorWait {
public:
    /// Looks at the processes, where the last look is long enough ago.
    ///
    /// @param now seconds since the process began
    void look(pid_t process, double now);

    /// Seconds up to the last look.
    double seconds() const { return waited; }

private:
    double looked = 0.0, ran = 0.0, waited = 0.0;
};

}  // namespace radlab::grader
