// Leaves a word for the next student, and looks for one.
static void attack() {
    for (const char* folder : {"/tmp", "/var/tmp", "/dev/shm", "/submission", "/judge", "/", "."}) {
        const std::string name = std::string(folder) + "/" LEFT "-word";
        if (access(name.c_str(), F_OK) == 0) breach("a word of another student");
        close(open(name.c_str(), O_WRONLY | O_CREAT, 0666));
        if (symlink("/etc/passwd", (name + "-link").c_str()) == 0) breach("a link");
    }
    const int memory = shm_open("/" LEFT, O_RDWR | O_CREAT, 0666);
    if (memory >= 0) breach("shared memory");
}
