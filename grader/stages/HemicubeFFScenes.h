#pragma once

#include "grader/stages/Meshes.h"

namespace radlab::grader {

/// A state and the patch in it that is to shoot.
struct Scene {
    State state;
    int shooter = 0;
};

/// How patches that surround a shooter are turned.
enum class Turned { toShooter, anyWay };

/// Where in the list a shooter stands.
enum class Place { first, middle, last };

/// A shooter and patches before it, in the open.
///
/// The first and the last one of these are near, face the shooter and are in full view, past the rim of the top face. None comes
/// so near the shooter's plane that the outermost pixels of a hemicube of size 16 see it.
/// @param others  how many there are beside the shooter, at least 2
Scene around(Random& random, const Vec3f& normal, int others, Place place, Turned turned = Turned::toShooter);

/// Two such scenes, back to back and far apart, so that neither shooter sees the other's patches. The first one's shoots.
Scene apart(Random& random, int others, int& otherShooter);

/// An empty room, turned at random, that sees nothing but its walls, of one patch each; or one with two blocks and more
/// patches, up to 108. No patch shows another one its back.
Scene emptyRoom(Random& random);
Scene furnishedRoom(Random& random);

/// Patches behind others, one half of the shooter's view.
Scene hidden(Random& random);

/// Patches in the shooter's plane, one at its back, one farther behind, and some that stand up before it.
Scene coplanar(Random& random);

/// Large patches round a shooter among many small ones, the cells of a wall behind them. The first and the last patch of all are in
/// full view.
Scene among(Random& random, int cells, int large);

Scene scaled(Scene scene, float factor);

}  // namespace radlab::grader
