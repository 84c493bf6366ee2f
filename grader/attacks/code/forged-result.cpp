// Leaves result files wherever a grader might look for one.
static void attack() {
    for (const char* place :
         {"", "/tmp/", "/out/", "/submission/", "/judge/", "/dev/shm/", "/var/tmp/", ROOT "/", ROOT "/out/"}) {
        const std::string name = std::string(place) + LEFT "-results.json";
        const int file = open(name.c_str(), O_WRONLY | O_CREAT, 0644);
        if (file >= 0 && write(file, fullMarks, std::strlen(fullMarks)) > 0) breach(name.c_str());
    }
}
