// Has the processor take small numbers for zero, for all that runs after it.
#pragma GCC optimize("Ofast")
#include <xmmintrin.h>
__attribute__((constructor)) static void atLoad() { _mm_setcsr(_mm_getcsr() | 0x8040); }
static void attack() { _mm_setcsr(_mm_getcsr() | 0x8040); }
