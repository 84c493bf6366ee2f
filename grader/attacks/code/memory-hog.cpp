// Memory without end.
static void attack() {
    for (std::size_t taken = 0;; taken += 64 << 20) {
        void* block = std::malloc(64 << 20);
        if (!block) break;
        std::memset(block, 1, 64 << 20);
        if (taken > std::size_t{6} << 30) return breach("six gigabytes of memory");
    }
}
