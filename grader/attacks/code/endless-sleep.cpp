// Waits for ever.
static void attack() {
    for (;;) pause();
}
