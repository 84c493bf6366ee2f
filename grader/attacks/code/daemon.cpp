// Leaves a process behind that holds every pipe, and prints full marks later on.
static void attack() {
    if (fork() == 0) {
        setsid();
        if (fork() == 0)
            for (;;) {
                for (int i = 1; i < 16; ++i) dprintf(i, "%s", fullMarks);
                usleep(1000);
            }
        _exit(0);
    }
}
