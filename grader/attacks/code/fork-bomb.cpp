// Processes without end.
static void attack() {
    int made = 0;
    for (int i = 0; i < 10000; ++i) {
        const pid_t child = fork();
        if (child == 0) {
            for (;;)
                if (fork() < 0) usleep(1000);
        }
        if (child > 0 && ++made > 200) breach("more than 200 processes");
    }
}
