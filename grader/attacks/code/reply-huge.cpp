// Patches that are not there, and a list that no memory holds.
static void attack() {
    polygons.resize(100000000, polygons.empty() ? nullptr : polygons[0]);
    vertices.clear();
}
