// Brings down the process that all checks are forked from.
static void attack() {
    if (kill(getppid(), SIGKILL) == 0) breach("the server was killed");
    if (kill(getppid(), SIGSTOP) == 0) breach("the server was stopped");
}
