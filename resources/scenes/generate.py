#!/usr/bin/env python3
"""Writes the scenes of this folder as X3D files.

    python3 resources/scenes/generate.py           write every scene beside this file
    python3 resources/scenes/generate.py --check   write nothing; name the files that differ, exit 1

The output is the same, byte for byte, on every run. Measured data stand in two text files here:
cornell_spectra.txt and teapot_patches.txt. Sources are named by their key in ../references.bib.

Conventions of all scenes: y is up. A face's corners run counter-clockwise seen from its front, the
side that emits and reflects; fronts face into a room and out of a block. Colours are linear RGB:
diffuseColor is a reflectance (0 to 1), emissiveColor a radiosity (W/m² per channel, any size).
"""

import argparse
import math
import sys
from dataclasses import dataclass
from itertools import pairwise, product
from pathlib import Path
from xml.sax.saxutils import escape

FOLDER = Path(__file__).resolve().parent

Vector = tuple[float, float, float]
Polygon = list[Vector]
Lines = list[str]


# --- Colour: from measured spectra to linear sRGB -------------------------------------------------

BRADFORD = ((0.8951, 0.2664, -0.1614), (-0.7502, 1.7135, 0.0367), (0.0389, -0.0685, 1.0296))

# Chromaticities of sRGB's primaries and of its white, D65 [IEC61966].
SRGB_PRIMARIES = ((0.64, 0.33), (0.30, 0.60), (0.15, 0.06))
SRGB_WHITE = (0.3127, 0.3290)


def read_table(name: str) -> list[list[float]]:
    """The numbers of a text file of this folder, line by line, without its comments."""
    lines = (FOLDER / name).read_text(encoding="utf-8").splitlines()
    return [[float(word) for word in line.split()] for line in lines if not line.startswith("#")]


def lobe(wavelength: float, scale: float, peak: float, below: float, above: float) -> float:
    """A Gaussian with one inverse width below its peak and another above."""
    return scale * math.exp(-0.5 * ((wavelength - peak) * (below if wavelength < peak else above)) ** 2)


def colour_matching(nm: float) -> Vector:
    """CIE 1931 2° colour matching functions x, y, z at a wavelength: multi-lobe fit of [Wyman2013]."""
    return (
        lobe(nm, 0.362, 442.0, 0.0624, 0.0374)
        + lobe(nm, 1.056, 599.8, 0.0264, 0.0323)
        + lobe(nm, -0.065, 501.1, 0.0490, 0.0382),
        lobe(nm, 0.821, 568.8, 0.0213, 0.0247) + lobe(nm, 0.286, 530.9, 0.0613, 0.0322),
        lobe(nm, 1.217, 437.0, 0.0845, 0.0278) + lobe(nm, 0.681, 459.0, 0.0385, 0.0725),
    )


def apply(matrix, vector) -> Vector:
    """Matrix times vector."""
    return tuple(sum(m * v for m, v in zip(row, vector)) for row in matrix)


def inverse(matrix):
    """The inverse of a 3 x 3 matrix, by Cramer's rule."""
    a, b, c = matrix
    columns = (cross(b, c), cross(c, a), cross(a, b))
    determinant = sum(x * y for x, y in zip(a, columns[0]))
    return tuple(tuple(column[i] / determinant for column in columns) for i in range(3))


def xyz_of_chromaticity(x: float, y: float) -> Vector:
    """The colour of luminance Y = 1 with chromaticity x, y."""
    return (x / y, 1.0, (1.0 - x - y) / y)


def xyz_to_srgb(xyz: Vector, white: Vector) -> Vector:
    """Linear sRGB of a colour seen under `white`, adapted to D65 by Bradford [Lam1985]: white -> 1, 1, 1."""
    d65 = xyz_of_chromaticity(*SRGB_WHITE)
    cone_ratio = [to / of for to, of in zip(apply(BRADFORD, d65), apply(BRADFORD, white))]
    cones = [c * ratio for c, ratio in zip(apply(BRADFORD, xyz), cone_ratio)]
    adapted = apply(inverse(BRADFORD), cones)
    primaries = tuple(zip(*(xyz_of_chromaticity(*p) for p in SRGB_PRIMARIES)))
    scale = apply(inverse(primaries), d65)
    return tuple(c / s for c, s in zip(apply(inverse(primaries), adapted), scale))


def spectrum_to_srgb(spectrum: list[tuple[float, float]], normalise: bool = False) -> Vector:
    """Linear sRGB of a spectrum (pairs of nm and value) relative to one that is 1 everywhere.

    So the perfect white reflector under the equal-energy illuminant has Y = 1 and is 1, 1, 1.
    With `normalise`, the result is scaled to luminance Y = 1. Negative channels become 0.
    """
    weights = [colour_matching(nm) for nm, _ in spectrum]
    luminance = sum(weight[1] for weight in weights)
    white = tuple(sum(channel) / luminance for channel in zip(*weights))
    xyz = tuple(
        sum(weight[i] * value for weight, (_, value) in zip(weights, spectrum)) / luminance for i in range(3)
    )
    scale = 1.0 / xyz[1] if normalise else 1.0
    return tuple(max(0.0, c * scale) for c in xyz_to_srgb(xyz, white))


def interpolate(nodes: list[tuple[float, float]], x: float) -> float:
    """Piecewise linear through the nodes."""
    (x0, y0), (x1, y1) = next(pair for pair in pairwise(nodes) if x <= pair[1][0])
    return y0 + (y1 - y0) * (x - x0) / (x1 - x0)


# --- Geometry ------------------------------------------------------------------------------------


def cross(a: Vector, b: Vector) -> Vector:
    """The cross product."""
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def inside_out(faces: list[Polygon]) -> list[Polygon]:
    """The same faces with their fronts on the other side."""
    return [face[::-1] for face in faces]


def wall(axis: int, at: float, facing: int, cuts: list[list[float]]) -> list[Polygon]:
    """The rectangles of a plane axis = at, cut at `cuts` of the two other axes, facing +1 or -1."""
    u, v = (axis + 1) % 3, (axis + 2) % 3

    def corner(on_u: float, on_v: float) -> Vector:
        place = {axis: at, u: on_u, v: on_v}
        return (place[0], place[1], place[2])

    faces = [
        [corner(u0, v0), corner(u1, v0), corner(u1, v1), corner(u0, v1)]
        for (u0, u1), (v0, v1) in product(pairwise(cuts[u]), pairwise(cuts[v]))
    ]
    return faces if facing > 0 else inside_out(faces)


def box_room(cuts: list[list[float]]) -> dict[str, list[Polygon]]:
    """The six walls of a box, fronts inwards, one face each but for the ceiling, which is cut at `cuts`."""
    names = (("x0", "x1"), ("floor", "ceiling"), ("z0", "z1"))
    whole = [[cut[0], cut[-1]] for cut in cuts]
    return {
        name: wall(axis, at, facing, cuts if name == "ceiling" else whole)
        for axis, pair in enumerate(names)
        for name, at, facing in zip(pair, (cuts[axis][0], cuts[axis][-1]), (1, -1))
    }


def room_with_ceiling_light(cuts: list[list[float]]) -> dict[str, list[Polygon]]:
    """A box room whose ceiling, cut in 3 x 3, has the light as its middle rectangle."""
    room = box_room(cuts)
    room["light"] = [room["ceiling"].pop(4)]
    return room


def prism(base: list[tuple[float, float]], bottom: float, top: float) -> dict[str, list[Polygon]]:
    """An upright prism, fronts outwards, from corners (x, z) that run counter-clockwise seen from above."""
    low = [(x, bottom, z) for x, z in base]
    high = [(x, top, z) for x, z in base]
    sides = [[low[i - 1], low[i], high[i], high[i - 1]] for i in range(len(base))]
    return {"top": [high], "bottom": [low[::-1]], "sides": sides}


def block(base: list[tuple[float, float]], height: float) -> list[Polygon]:
    """A prism on the floor, without its bottom: that would lie in the floor's plane."""
    faces = prism(base, 0.0, height)
    return faces["top"] + faces["sides"]


def rectangle(x0: float, x1: float, z0: float, z1: float) -> list[tuple[float, float]]:
    """Corners (x, z) of a rectangle, counter-clockwise seen from above."""
    return [(x0, z0), (x0, z1), (x1, z1), (x1, z0)]


# --- The teapot ----------------------------------------------------------------------------------

RIM, BODY, LID, BOTTOM = range(0, 4), range(4, 12), range(20, 28), range(28, 32)
HANDLE_START, HANDLE_END = range(12, 14), range(14, 16)
SPOUT_START, SPOUT_END = range(16, 18), range(18, 20)

Grid = list[list[Vector]]


def teapot_patches() -> list[list[Vector]]:
    """The 32 Bezier patches of 16 control points each [Newell1975]."""
    rows = read_table("teapot_patches.txt")
    indices, points = rows[:32], rows[32:]
    return [[tuple(points[int(i) - 1]) for i in patch] for patch in indices]


def bernstein(t: float) -> tuple[float, float, float, float]:
    """The four cubic Bernstein polynomials."""
    s = 1.0 - t
    return (s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t)


def evaluate(patch: list[Vector], u: float, v: float) -> Vector:
    """The point of a bicubic Bezier patch; u runs over its rows. Rounded, so that neighbours meet."""
    weights = [a * b for a, b in product(bernstein(u), bernstein(v))]
    return tuple(round(sum(w * p[i] for w, p in zip(weights, patch)), 6) + 0.0 for i in range(3))


def grid_of(patch: list[Vector], steps: int) -> Grid:
    """Points of a patch at equal steps of its parameters."""
    return [[evaluate(patch, i / steps, j / steps) for j in range(steps + 1)] for i in range(steps + 1)]


def split(a: Vector, b: Vector, c: Vector, d: Vector) -> list[Polygon]:
    """A quad as two triangles; one that has shrunk to a line, as at the lid's pole, is left out."""
    return [triangle for triangle in ([a, b, c], [a, c, d]) if len(set(triangle)) == 3]


def grid_triangles(grid: Grid) -> list[Polygon]:
    """The triangles of a grid, fronts outwards: Newell's rows and columns turn the other way."""
    return [
        triangle
        for upper, lower in pairwise(grid)
        for (a, b), (d, c) in zip(pairwise(upper), pairwise(lower))
        for triangle in split(a, b, c, d)
    ]


def ring(grids: list[Grid], row: int) -> Polygon:
    """The closed curve that one row of several patches makes."""
    return [point for grid in grids for point in grid[row][:-1]]


def fan(loop: Polygon) -> list[Polygon]:
    """A flat convex loop as triangles."""
    return [[loop[0], b, c] for b, c in pairwise(loop[1:])]


def lid_seat(outer: Polygon, inner: Polygon) -> list[Polygon]:
    """The flat ring that closes the gap between the rim and the lid."""
    return [
        triangle
        for i in range(len(inner))
        for triangle in split(inner[i - 1], inner[i], outer[i], outer[i - 1])
    ]


def teapot(steps: int) -> list[Polygon]:
    """The teapot as triangles, z up: three closed shells (body, handle, spout).

    Newell left the handle's two ends, the spout's two ends and the gap round the lid open; flat faces
    close them here, so that no ray gets behind a front.
    """
    grids = [grid_of(patch, steps) for patch in teapot_patches()]

    def of(patches: range) -> list[Grid]:
        return [grids[i] for i in patches]

    triangles = [triangle for grid in grids for triangle in grid_triangles(grid)]
    triangles += lid_seat(ring(of(RIM), 0), ring(of(LID[4:]), steps))
    for start, end in ((HANDLE_START, HANDLE_END), (SPOUT_START, SPOUT_END)):
        triangles += fan(ring(of(start), 0)[::-1]) + fan(ring(of(end), steps))
    return triangles


# --- X3D -----------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Material:
    """What a surface is made of; the fields are X3D's, in linear RGB."""

    diffuse: Vector
    emissive: Vector = (0.0, 0.0, 0.0)
    specular: Vector = (0.0, 0.0, 0.0)
    shininess: float = 0.0


def grey(value: float) -> Vector:
    """The same value in each channel."""
    return (value, value, value)


def number(value: float) -> str:
    """A number with at most six decimals, no more digits than it needs, and no negative zero."""
    return f"{round(value, 6) + 0.0:.6f}".rstrip("0").rstrip(".")


def numbers(values) -> str:
    """Numbers with spaces between them."""
    return " ".join(number(value) for value in values)


def wrapped(words: Lines, per_line: int) -> str:
    """Words in lines of so many each; a line break inside an attribute counts as a space."""
    if len(words) <= per_line:
        return "  ".join(words)
    return "".join("\n" + "  ".join(words[i : i + per_line]) for i in range(0, len(words), per_line))


def element(tag: str, attributes: dict[str, str], *children: Lines) -> Lines:
    """An XML element as lines, its children indented."""
    head = tag + "".join(f' {key}="{escape(value)}"' for key, value in attributes.items())
    if not children:
        return [f"<{head}/>"]
    return [f"<{head}>", *("  " + line for child in children for line in child), f"</{tag}>"]


class Palette:
    """Named materials: written in full where first used (DEF), referred to afterwards (USE).

    Their DEF names begin with material_, since X3D has one space of names for all kinds of nodes.
    """

    def __init__(self, **materials: Material):
        self.materials = materials
        self.written: set[str] = set()

    def appearance(self, name: str) -> Lines:
        """The Appearance node of a material."""
        if name in self.written:
            return element("Appearance", {"USE": f"material_{name}"})
        self.written.add(name)
        return element("Appearance", {"DEF": f"material_{name}"}, material_node(self.materials[name]))


def material_node(material: Material) -> Lines:
    """The Material node; fields that do not matter are left out, but for the colour of emission."""
    fields = {"diffuseColor": numbers(material.diffuse), "emissiveColor": numbers(material.emissive)}
    if any(material.specular):
        fields |= {"specularColor": numbers(material.specular), "shininess": number(material.shininess)}
    return element("Material", fields)


def index_corners(faces: list[Polygon]) -> tuple[list[str], list[list[int]]]:
    """The distinct points of the faces, as text, and each face as indices of them."""
    places: dict[str, int] = {}
    indexed = [[places.setdefault(numbers(corner), len(places)) for corner in face] for face in faces]
    return list(places), indexed


def face_set(faces: list[Polygon], **attributes: str) -> Lines:
    """An IndexedFaceSet with its own Coordinate node."""
    points, indexed = index_corners(faces)
    corners = [" ".join(map(str, [*face, -1])) for face in indexed]
    fields = {**attributes, "solid": "true", "coordIndex": wrapped(corners, 6)}
    return element("IndexedFaceSet", fields, element("Coordinate", {"point": wrapped(points, 4)}))


def wall_set(faces: list[Polygon]) -> Lines:
    """The faces of one wall; where it is cut, shading stays smooth over the cuts."""
    return face_set(faces, creaseAngle="0.1") if len(faces) > 1 else face_set(faces)


def shape(appearance: Lines, geometry: Lines, name: str | None = None) -> Lines:
    """A Shape node."""
    return element("Shape", {"DEF": name} if name else {}, appearance, geometry)


def look_at(position: Vector, target: Vector) -> Vector:
    """The unit vector from a position to a target."""
    way = tuple(t - p for p, t in zip(position, target))
    return tuple(w / math.hypot(*way) for w in way)


def orientation(direction: Vector) -> tuple[float, float, float, float]:
    """Axis and angle that turn X3D's view (along -z, y up) to a direction, upright: pitch, then yaw."""
    x, y, z = direction
    yaw, pitch = math.atan2(0.0 - x, -z) / 2, math.asin(y) / 2
    real = math.cos(yaw) * math.cos(pitch)
    axis = (math.cos(yaw) * math.sin(pitch), math.sin(yaw) * math.cos(pitch), -math.sin(yaw) * math.sin(pitch))
    length = math.hypot(*axis)
    if length == 0.0:
        return (0.0, 1.0, 0.0, 0.0)
    return (axis[0] / length, axis[1] / length, axis[2] / length, 2 * math.atan2(length, real))


def viewpoint(description: str, position: Vector, target: Vector, field_of_view: float) -> Lines:
    """A Viewpoint node; the field of view is the angle over the picture's smaller side, in radians."""
    return element(
        "Viewpoint",
        {
            "description": description,
            "position": numbers(position),
            "orientation": numbers(orientation(look_at(position, target))),
            "fieldOfView": number(field_of_view),
        },
    )


def document(comment: str, view: Lines, *nodes: Lines) -> str:
    """A whole X3D file that begins with a comment."""
    background = element("Background", {"skyColor": "0 0 0"})
    scene = element("Scene", {}, view, background, *nodes)
    root = element("X3D", {"profile": "Interchange", "version": "3.3"}, scene)
    return "\n".join(['<?xml version="1.0" encoding="UTF-8"?>', f"<!--\n{comment.strip()}\n-->", *root]) + "\n"


# --- The scenes ----------------------------------------------------------------------------------

CORNELL_CUTS = [[0.0, 213.0, 343.0, 552.8], [0.0, 548.8], [0.0, 227.0, 332.0, 559.2]]
CORNELL_LIGHT_SPECTRUM = [(400.0, 0.0), (500.0, 8.0), (600.0, 15.6), (700.0, 18.4)]
CORNELL_LIGHT_REFLECTANCE = 0.78

# W/(m² sr), the luminance of the light, whose measured spectrum has no absolute unit: chosen so that
# white walls are displayed (radiance = radiosity / pi) well lit without any exposure.
CORNELL_LIGHT_RADIANCE = 17.0

SHORT_BLOCK = block([(130.0, 65.0), (82.0, 225.0), (240.0, 272.0), (290.0, 114.0)], 165.0)
TALL_BLOCK = block([(423.0, 247.0), (265.0, 296.0), (314.0, 456.0), (472.0, 406.0)], 330.0)


def rounded(colour: Vector, low: float = 0.0, high: float = math.inf) -> Vector:
    """A colour with four decimals, within bounds."""
    return tuple(round(min(max(c, low), high), 4) for c in colour)


def cornell_colours() -> dict[str, Material]:
    """Materials from the measured spectra [CornellBox]."""
    table = read_table("cornell_spectra.txt")
    reflectances = {
        name: rounded(spectrum_to_srgb([(row[0], row[column]) for row in table]), high=1.0)
        for column, name in enumerate(("white", "green", "red"), start=1)
    }
    lamp = [(row[0], interpolate(CORNELL_LIGHT_SPECTRUM, row[0])) for row in table]
    radiosity = math.pi * CORNELL_LIGHT_RADIANCE
    emission = rounded(tuple(radiosity * c for c in spectrum_to_srgb(lamp, normalise=True)))
    return {
        **{name: Material(diffuse) for name, diffuse in reflectances.items()},
        "light": Material(grey(CORNELL_LIGHT_REFLECTANCE), emission),
        "mirror": Material(grey(0.0), specular=grey(0.9), shininess=1.0),
    }


def cornell_comment(purpose: str, colours: dict[str, Material]) -> str:
    """The comment of a Cornell box: its purpose, and where its numbers come from."""
    rgb = {name: numbers(colours[name].diffuse) for name in ("white", "green", "red")}
    radiance, own = number(CORNELL_LIGHT_RADIANCE), number(CORNELL_LIGHT_REFLECTANCE)
    emission = numbers(colours["light"].emissive)
    light = f"radiance Y = {radiance}: E = {emission}; reflects {own}"
    return f"""
{purpose} Lengths as measured [CornellBox], emission in W/m².
The published corners are up to 3.2 off a box; here it is one, so walls are planar and close. Open at z = 0.
RGB: spectra x CIE 1931 2° functions [Wyman2013], 400..700 nm by 4, over equal energy, Bradford [Lam1985] to D65,
linear sRGB in 0 to 1: white {rgb["white"]}, green {rgb["green"]}, red {rgb["red"]}; perfect white is 1 1 1.
Light: 0, 8, 15.6, 18.4 at 400, 500, 600, 700 nm, the same way, at {light}.
"""


def cornell(purpose: str, *blocks: tuple[str, str, list[Polygon]]) -> str:
    """The Cornell box [CornellBox] with blocks given as (name, material, faces)."""
    colours = cornell_colours()
    palette = Palette(**colours)
    room = room_with_ceiling_light(CORNELL_CUTS)
    materials = {
        "floor": "white",
        "ceiling": "white",
        "z1": "white",
        "x0": "green",
        "x1": "red",
        "light": "light",
    }
    names = {"z1": "back", "x0": "right", "x1": "left"}
    walls = [
        shape(palette.appearance(material), wall_set(room[wall_]), names.get(wall_, wall_))
        for wall_, material in materials.items()
    ]
    things = [shape(palette.appearance(material), face_set(faces), name) for name, material, faces in blocks]
    view = viewpoint(
        "Through the open front",
        (278.0, 273.0, -800.0),
        (278.0, 273.0, 0.0),
        2 * math.atan(0.0125 / 0.035),
    )
    return document(cornell_comment(purpose, colours), view, *walls, *things)


def cornell_1() -> str:
    """The empty Cornell box."""
    return cornell("The empty Cornell box, the course's first scene.")


def cornell_2() -> str:
    """The Cornell box with its two blocks."""
    return cornell(
        "The Cornell box with both blocks: shadows, bleeding colour.",
        ("short", "white", SHORT_BLOCK),
        ("tall", "white", TALL_BLOCK),
    )


def mirror() -> str:
    """The Cornell box with a mirror."""
    return cornell(
        "The Cornell box, its tall block a mirror (specular 0.9).",
        ("short", "white", SHORT_BLOCK),
        ("tall", "mirror", TALL_BLOCK),
    )


UNIT_CUBE = [[0.0, 1.0], [0.0, 1.0], [0.0, 1.0]]


def unit_cube(comment: str, material: Material) -> str:
    """A closed unit cube of one material, seen from near a corner."""
    palette = Palette(all=material)
    faces = [face for faces in box_room(UNIT_CUBE).values() for face in faces]
    view = viewpoint("Near a corner", (0.9, 0.85, 0.9), (0.3, 0.35, 0.25), 1.2)
    return document(comment, view, shape(palette.appearance("all"), face_set(faces), "cube"))


def furnace() -> str:
    """The white furnace: a closed form for every patch."""
    return unit_cube(
        """
The white furnace: a closed cube that reflects and emits the same everywhere, to test energy balance.
Units: edge 1; reflectance 0.5; emission E = 1 W/m² per channel. Source: energy balance [CohenWallace1993].
Expected: radiosity B = E / (1 - 0.5) = 2 W/m² on every patch, in every channel; form factors sum to 1.
""",
        Material(grey(0.5), grey(1.0)),
    )


def dark() -> str:
    """A scene without light."""
    return unit_cube(
        """
A closed cube in which nothing emits, to test that programs notice and say so.
Units: edge 1; reflectance 0.5; emission 0. Source: made for radlab.
Expected: radiosity 0 everywhere, no patch to shoot from, no division by a total energy of 0.
""",
        Material(grey(0.5)),
    )


def plates() -> str:
    """Two parallel plates: a closed form for one form factor."""
    comment = """
Two unit squares that face each other at distance 1: the form factor with a closed form.
Units: edge 1; the upper emits E = 1 W/m² and reflects nothing, the lower reflects 0.5.
Source: parallel equal rectangles [Howell], also in [CohenWallace1993].
Expected: F = 0.199824895698387 both ways; mean radiosity of the lower 0.5 F = 0.0999124478491935 W/m².
"""
    palette = Palette(emitter=Material(grey(0.0), grey(1.0)), receiver=Material(grey(0.5)))
    upper = wall(1, 1.0, -1, UNIT_CUBE)
    lower = wall(1, 0.0, 1, UNIT_CUBE)
    view = viewpoint("Between the plates, from outside", (0.5, 0.55, 2.2), (0.5, 0.45, 0.5), 1.0)
    return document(
        comment,
        view,
        shape(palette.appearance("emitter"), face_set(upper), "upper"),
        shape(palette.appearance("receiver"), face_set(lower), "lower"),
    )


L_CORNERS = [(0.0, 0.0), (0.0, 6.0), (2.5, 6.0), (2.5, 2.5), (6.0, 2.5), (6.0, 0.0)]
L_HEIGHT = 2.6


def l_room() -> str:
    """A room whose light is round the corner."""
    comment = """
An L-shaped closed room with the light round the corner: from the viewpoint only its bounce is seen.
Floor and ceiling are one concave polygon of six corners each, to test that the mesher cuts them well.
Units: metres; emission W/m². The lamp is a thin closed box that hangs 0.24 m below the ceiling, so that
nothing overlaps; its underside emits 80, 74, 62. The wall x = 0, seen from both arms, is orange.
Source: made for radlab. Expected: the room is closed, so every row of form factors sums to 1.
"""
    palette = Palette(
        white=Material(grey(0.75)),
        orange=Material((0.75, 0.45, 0.25)),
        floor=Material((0.4, 0.35, 0.3)),
        light=Material(grey(0.8), (80.0, 74.0, 62.0)),
    )
    room = {name: inside_out(faces) for name, faces in prism(L_CORNERS, 0.0, L_HEIGHT).items()}
    sides = [(face, "orange" if all(x == 0.0 for x, _, _ in face) else "white") for face in room["sides"]]
    lamp = prism(rectangle(0.5, 2.0, 4.6, 5.4), 2.3, 2.36)
    view = viewpoint("Round the corner from the light", (5.6, 1.4, 1.25), (0.5, 1.2, 1.6), 1.0)
    return document(
        comment,
        view,
        shape(palette.appearance("floor"), face_set(room["bottom"], convex="false"), "floor"),
        shape(palette.appearance("white"), face_set(room["top"], convex="false"), "ceiling"),
        *(
            shape(palette.appearance(material), face_set([face]), f"wall_{i}")
            for i, (face, material) in enumerate(sides, start=1)
        ),
        shape(palette.appearance("white"), face_set(lamp["top"] + lamp["sides"]), "lamp"),
        shape(palette.appearance("light"), face_set(lamp["bottom"]), "lamp_underside"),
    )


TEAPOT_STEPS = 5
TEAPOT_LIFT = 0.02
TEAPOT_CREASE = 0.7  # radians: smooth over the bends of the body, sharp at the rims


def teapot_scene() -> str:
    """The teapot in a coloured box."""
    triangles = teapot(TEAPOT_STEPS)
    patches = f"32 patches [Newell1975], {TEAPOT_STEPS} x {TEAPOT_STEPS} steps each"
    comment = f"""
The Utah teapot in a coloured, closed box: a curved thing of {len(triangles)} triangles.
Units: Newell's (the pot is 3.15 high); emission W/m². Source: {patches}.
The handle's and spout's ends and the gap round the lid, open in the original, are closed by flat faces: body,
handle and spout are three closed shells that reach into each other.
The pot stands {number(TEAPOT_LIFT)} over the floor, so that no face touches it. Its creaseAngle asks for smooth shading.
"""
    palette = Palette(
        red=Material((0.6, 0.15, 0.1)),
        floor=Material((0.55, 0.45, 0.35)),
        white=Material(grey(0.75)),
        blue=Material((0.15, 0.25, 0.6)),
        light=Material(grey(0.75), (45.0, 42.0, 36.0)),
        china=Material((0.7, 0.68, 0.64)),
    )
    room = room_with_ceiling_light([[-6.0, -1.5, 1.5, 6.0], [0.0, 8.0], [-5.0, -1.5, 1.5, 9.0]])
    materials = {
        "x0": ("left", "red"),
        "x1": ("right", "blue"),
        "floor": ("floor", "floor"),
        "ceiling": ("ceiling", "white"),
        "z0": ("back", "white"),
        "z1": ("front", "white"),
        "light": ("light", "light"),
    }
    walls = [
        shape(palette.appearance(material), wall_set(room[key]), name)
        for key, (name, material) in materials.items()
    ]
    pot = element(
        "Transform",
        {"translation": numbers((0.0, TEAPOT_LIFT, 0.0)), "rotation": numbers((1.0, 0.0, 0.0, -math.pi / 2))},
        shape(palette.appearance("china"), face_set(triangles, creaseAngle=number(TEAPOT_CREASE)), "teapot"),
    )
    view = viewpoint("Before the teapot", (2.0, 4.4, 8.4), (0.2, 1.4, 0.0), 0.8)
    return document(comment, view, *walls, pot)


def grey_room() -> str:
    """A room without colour."""
    comment = """
A closed grey room with a table and a cabinet: all channels are equal, so one channel is enough.
Units: metres; reflectance 0.3 (floor), 0.6 (walls), 0.8 (ceiling, light), 0.5 (blocks); emission 30 W/m².
Both blocks are one unit block, placed by Transform nodes: for readers of DEF, USE and Transform.
Source: made for radlab. Expected: red, green and blue agree to the last bit; rows of form factors
sum to 1, but on the floor under a block.
"""
    palette = Palette(
        floor=Material(grey(0.3)),
        wall=Material(grey(0.6)),
        ceiling=Material(grey(0.8)),
        light=Material(grey(0.8), grey(30.0)),
        block=Material(grey(0.5)),
    )
    room = room_with_ceiling_light([[0.0, 1.4, 2.6, 4.0], [0.0, 2.8], [0.0, 1.4, 2.6, 5.0]])
    walls = [
        shape(palette.appearance("wall"), wall_set(room[key]), f"wall_{key}")
        for key in ("x0", "x1", "z0", "z1")
    ]
    unit = face_set(block(rectangle(-0.5, 0.5, -0.5, 0.5), 1.0), DEF="unit_block")
    table = shape(palette.appearance("block"), unit, "table")
    cabinet = shape(palette.appearance("block"), element("IndexedFaceSet", {"USE": "unit_block"}), "cabinet")
    view = viewpoint("From the corner", (3.6, 1.7, 4.7), (1.7, 0.9, 1.6), 1.1)
    return document(
        comment,
        view,
        shape(palette.appearance("floor"), wall_set(room["floor"]), "floor"),
        *walls,
        shape(palette.appearance("ceiling"), wall_set(room["ceiling"]), "ceiling"),
        shape(palette.appearance("light"), wall_set(room["light"]), "light"),
        placed(table, (1.2, 0.0, 2.0), 0.4, (1.2, 0.75, 0.8)),
        placed(cabinet, (3.1, 0.0, 1.0), -0.3, (0.6, 1.8, 0.6)),
    )


def placed(node: Lines, at: Vector, turn: float, size: Vector) -> Lines:
    """A node scaled, turned about the upright axis and moved."""
    fields = {"translation": numbers(at), "rotation": numbers((0.0, 1.0, 0.0, turn)), "scale": numbers(size)}
    return element("Transform", fields, node)


SCENES = {
    "cornell_1.x3d": cornell_1,
    "cornell_2.x3d": cornell_2,
    "furnace.x3d": furnace,
    "plates.x3d": plates,
    "l_room.x3d": l_room,
    "teapot.x3d": teapot_scene,
    "grey_room.x3d": grey_room,
    "dark.x3d": dark,
    "mirror.x3d": mirror,
}


def write(name: str, content: bytes) -> None:
    """Writes a scene beside this file."""
    (FOLDER / name).write_bytes(content)


def differs(name: str, content: bytes) -> bool:
    """Whether the file on disk is missing or holds something else."""
    path = FOLDER / name
    return not path.is_file() or path.read_bytes() != content


def main() -> int:
    parser = argparse.ArgumentParser(description="Writes the scenes of this folder as X3D files.")
    parser.add_argument("--check", action="store_true", help="write nothing; name the files that differ")
    arguments = parser.parse_args()
    contents = {name: scene().encode("utf-8") for name, scene in SCENES.items()}
    if not arguments.check:
        for name, content in contents.items():
            write(name, content)
        return 0
    stale = [name for name, content in contents.items() if differs(name, content)]
    for name in stale:
        print(f"{FOLDER / name}: differs from what generate.py writes")
    return 1 if stale else 0


if __name__ == "__main__":
    sys.exit(main())
