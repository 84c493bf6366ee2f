// Writes full marks to whatever is open.
static void attack() {
    for (int i = 1; i < 1024; ++i)
        if (write(i, fullMarks, std::strlen(fullMarks)) > 0 && i > 3) breach("a descriptor beyond the four is open");
}
