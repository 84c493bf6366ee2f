// Fills whatever can be written, with bytes and with names.
static void attack() {
    static char block[65536];
    for (const char* folder : {"/tmp", "/dev/shm", "/dev", "/var/tmp", "/submission", "/", "."}) {
        std::size_t bytes = 0;
        int names = 0;
        for (int i = 0; i < 1000; ++i) {
            const std::string name = std::string(folder) + "/" LEFT "-" + std::to_string(i);
            const int file = open(name.c_str(), O_WRONLY | O_CREAT, 0600);
            if (file < 0 && mkdir(name.c_str(), 0700) != 0) break;
            ++names;
            for (ssize_t got; file >= 0 && bytes < 1 << 24 && (got = write(file, block, sizeof block)) > 0;)
                bytes += static_cast<std::size_t>(got);
            close(file);
        }
        if (names || bytes) breach(folder);
    }
    const int memory = static_cast<int>(syscall(SYS_memfd_create, "x", 0));
    if (memory >= 0 && write(memory, block, sizeof block) > 0) breach("a file in memory");
}
