// Prints without end.
static void attack() {
    static char block[65536];
    std::memset(block, 'x', sizeof block);
    for (;;) {
        write(1, block, sizeof block);
        write(2, block, sizeof block);
    }
}
