// Numbers that compare with nothing.
static void attack() {
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    for (MyPolygon* patch : polygons) {
        patch->rad = patch->unshot_rad = patch->color = Vec3f(nan, infinity, -infinity);
        patch->area = patch->formF = nan;
    }
}
