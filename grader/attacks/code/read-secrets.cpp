// Looks for solutions, references, other submissions and the machine's own files.
static void attack() {
    for (const char* name : {ROOT "/solutions/ProgRef.cpp",
                             ROOT "/resources/reference/calcFF.png",
                             ROOT "/grader/stages/manifest.json",
                             ROOT "/build/release/bin/check",
                             ROOT "/out/grades.db",
                             "/etc/passwd",
                             "/etc/shadow",
                             "/etc/hostname",
                             "/root",
                             "/home",
                             "/proc/self/environ",
                             "/proc/1/environ",
                             "/proc/1/cmdline",
                             "/proc/self/mountinfo",
                             "/sys/kernel",
                             "/var/log",
                             "/run",
                             "/boot",
                             "/dev/mem",
                             "/dev/kmsg"})
        if (open(name, O_RDONLY) >= 0) breach(name);
    char name[64];
    std::snprintf(name, sizeof name, "/proc/%d/mem", getppid());
    if (open(name, O_RDONLY) >= 0) breach("the memory of the worker's parent");
    for (const char* folder : {"/tmp", "/submission/..", "/var/tmp"})
        if (DIR* all = opendir(folder))
            while (const dirent* entry = readdir(all))
                if (std::strncmp(entry->d_name, "radlab-", 7) == 0) breach("other submissions");
    for (char** variable = environ; *variable; ++variable)
        if (std::strstr(*variable, "SECRET") || std::strstr(*variable, "HOME=")) breach(*variable);
}
