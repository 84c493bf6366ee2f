// More messages than anybody reads.
#define TEN(x) x x x x x x x x x x
#define LOUD _Pragma("message \"\033[2J<script>alert(1)</script>=1+1\"")
TEN(TEN(TEN(TEN(LOUD))))
