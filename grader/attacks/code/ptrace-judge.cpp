// Takes hold of other processes, or kills them.
static void attack() {
    if (ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) == 0) breach("traced");
    if (ptrace(PTRACE_ATTACH, getppid(), nullptr, nullptr) == 0) breach("the parent is traced");
    char byte = 0;
    iovec mine = {&byte, 1}, theirs = {reinterpret_cast<void*>(0x400000), 1};
    if (syscall(SYS_process_vm_readv, getppid(), &mine, 1, &theirs, 1, 0) > 0) breach("the parent's memory");
    for (pid_t other = 1; other < 100000; ++other)
        if (other != getpid() && kill(other, SIGKILL) == 0) breach("a process was killed");
    if (kill(-1, SIGSTOP) == 0) breach("all processes were stopped");
}
