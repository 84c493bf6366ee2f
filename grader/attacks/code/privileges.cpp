// Becomes somebody else.
static void attack() {
    if (setuid(0) == 0 || geteuid() == 0) breach("root");
    if (chmod("/submission/submission.so", 04755) == 0) breach("a setuid file");
    for (const char* program : {"/usr/bin/su", "/bin/su", "/usr/bin/passwd", "/usr/bin/mount"})
        if (access(program, F_OK) == 0) breach(program);
    char* const arguments[] = {const_cast<char*>("sh"), const_cast<char*>("-c"),
                               const_cast<char*>("echo breach: a shell"), nullptr};
    execve("/bin/sh", arguments, environ);
}
