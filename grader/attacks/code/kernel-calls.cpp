// Asks the kernel for what no exercise needs.
static void attack() {
    char parameters[256] = {};
    if (syscall(SYS_io_uring_setup, 4, parameters) >= 0) breach("io_uring");
    if (syscall(SYS_add_key, "user", "radlab", "x", 1, -2) >= 0) breach("a key");
    if (syscall(SYS_keyctl, 0, -3, 1) >= 0) breach("a keyring");
    if (syscall(SYS_bpf, 0, parameters, sizeof parameters) >= 0) breach("bpf");
    if (syscall(SYS_userfaultfd, 1) >= 0) breach("userfaultfd");
    if (syscall(SYS_perf_event_open, parameters, 0, -1, -1, 0) >= 0) breach("perf_event_open");
    if (syscall(SYS_pidfd_open, getppid(), 0) >= 0) breach("pidfd_open");
    if (syscall(SYS_personality, 0x0040000) >= 0) breach("personality");
    if (syscall(SYS_sethostname, "x", 1) == 0) breach("sethostname");
    if (syscall(SYS_settimeofday, nullptr, nullptr) == 0) breach("settimeofday");
}
