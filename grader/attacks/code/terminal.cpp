// Types into the terminal of whoever grades.
static void attack() {
    const char* command = "echo radlab-breach\n";
    for (int i = 0; i < 4; ++i)
        if (ioctl(i, TIOCSTI, command) == 0) breach("typed into a terminal");
    if (open("/dev/tty", O_RDWR) >= 0) breach("a terminal");
    if (open("/dev/ptmx", O_RDWR) >= 0) breach("a new terminal");
}
