// Answers before the worker does, with noise.
static void attack() {
    for (int i = 0; i < 1000; ++i) dprintf(3, "%c%c noise %d", i, 255 - i, i);
}
