// Doubles the compiler's work with every level.
template <int depth, int side>
struct Bomb {
    Bomb<depth - 1, 2 * side> left;
    Bomb<depth - 1, 2 * side + 1> right;
};
template <int side>
struct Bomb<0, side> {
    char one[side % 7 + 1];
};
static Bomb<40, 0> bomb;
