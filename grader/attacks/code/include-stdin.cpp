// Headers out of the compiler's own descriptors.
#include "/dev/fd/3"
#include "/dev/stdin"
#include "/proc/self/fd/3"
