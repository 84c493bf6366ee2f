#include "base/Heap.h"

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace radlab {

void keepFreedMemory() {
#if defined(__GLIBC__)
    constexpr int large = 1 << 30, ahead = 64 << 20;  // bytes
    mallopt(M_MMAP_THRESHOLD, large);
    mallopt(M_TRIM_THRESHOLD, large);
    mallopt(M_TOP_PAD, ahead);
#endif
}

void giveBackFreedMemory() {
#if defined(__GLIBC__)
    malloc_trim(0);
#endif
}

}  // namespace radlab
