// Memory of many processes, each within its own limit.
static void attack() {
    const std::size_t part = std::size_t{1} << 30;
    auto* total =
        static_cast<std::size_t*>(mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
    for (int i = 0; i < 7; ++i)
        if (fork() == 0) {
            char* block = static_cast<char*>(std::malloc(part));
            for (std::size_t k = 0; block && k < part; k += 4096) block[k] = 1;
            if (block && __sync_add_and_fetch(total, part) > 6 * part) breach("seven gigabytes in seven processes");
            pause();
        }
    sleep(1);
}
