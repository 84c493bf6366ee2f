// Becomes root of a world of its own.
static void attack() {
    if (unshare(CLONE_NEWUSER) == 0) breach("a user namespace");
    if (unshare(CLONE_NEWNS) == 0) breach("a mount namespace");
    const long child = syscall(SYS_clone, CLONE_NEWUSER | SIGCHLD, nullptr, nullptr, nullptr, nullptr);
    if (child == 0) _exit(0);
    if (child > 0) breach("a process in a user namespace");
    if (mount("none", "/tmp", "tmpfs", 0, nullptr) == 0) breach("a mount");
    if (chroot("/") == 0) breach("chroot");
}
