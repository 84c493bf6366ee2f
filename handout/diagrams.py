#!/usr/bin/env python3
"""Draws the handout's diagrams as SVG: diagrams.py [--check]

Colours are CSS variables with a fallback, so that the page's dark style reaches them once they stand in it; so is the size of letters, for
phones.
"""
import json
import math
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
FIGURES = HERE / "figures"
INK, SOFT, FILL, SECOND, WARM = (f"var(--{name}, {color})" for name, color in
                                 [("ink", "#1c1c1c"), ("soft", "#888"), ("fill", "#dce6f5"), ("second", "#f6ddc8"),
                                  ("warm", "#c2410c")])


class Drawing:
    """An SVG file that grows by shapes; y runs down."""

    def __init__(self, width, height, title):
        self.size, self.title, self.parts = (width, height), title, []

    def line(self, a, b, color=INK, width=1.5, dash="", arrow=False):
        dashed = f' stroke-dasharray="{dash}"' if dash else ""
        self.parts.append(f'<line x1="{a[0]:.1f}" y1="{a[1]:.1f}" x2="{b[0]:.1f}" y2="{b[1]:.1f}" '
                          f'stroke="{color}" stroke-width="{width}"{dashed}/>')
        if arrow:
            self.tip(a, b, color)

    def tip(self, a, b, color):
        angle = math.atan2(b[1] - a[1], b[0] - a[0])
        wings = [(b[0] - 9 * math.cos(angle + turn), b[1] - 9 * math.sin(angle + turn)) for turn in (0.4, -0.4)]
        self.polygon([b, *wings], color, color, 0)

    def polygon(self, points, fill="none", stroke=INK, width=1.5):
        text = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
        self.parts.append(f'<polygon points="{text}" fill="{fill}" stroke="{stroke}" stroke-width="{width}"/>')

    def rect(self, x, y, width, height, fill="none", stroke=INK, line=1.5):
        self.polygon([(x, y), (x + width, y), (x + width, y + height), (x, y + height)], fill, stroke, line)

    def dot(self, at, radius=3.5, fill=INK):
        self.parts.append(f'<circle cx="{at[0]:.1f}" cy="{at[1]:.1f}" r="{radius}" fill="{fill}"/>')

    def path(self, commands, color=INK, fill="none", width=1.5):
        self.parts.append(f'<path d="{commands}" fill="{fill}" stroke="{color}" stroke-width="{width}"/>')

    def arc(self, center, radius, start, end, color=WARM):
        """From one angle to another, in degrees, counter-clockwise."""
        ends = [(center[0] + radius * math.cos(math.radians(a)), center[1] - radius * math.sin(math.radians(a)))
                for a in (start, end)]
        self.path(f"M{ends[0][0]:.1f},{ends[0][1]:.1f} A{radius},{radius} 0 0 0 {ends[1][0]:.1f},{ends[1][1]:.1f}", color)

    def text(self, at, words, size=17, anchor="middle", color=INK, italic=False):
        style = ' font-style="italic"' if italic else ""
        if size > 12:  # the small ones fill cells
            style += f' style="font-size: calc({size}px * var(--larger, 1))"'
        self.parts.append(f'<text x="{at[0]:.1f}" y="{at[1]:.1f}" font-size="{size}" text-anchor="{anchor}" '
                          f'fill="{color}"{style}>{words}</text>')

    def symbol(self, at, letter, index="", anchor="middle", color=INK):
        low = f'<tspan font-size="12" dy="4" font-style="italic">{index}</tspan>' if index else ""
        self.text(at, f'<tspan font-style="italic">{letter}</tspan>{low}', 18, anchor, color)

    def svg(self):
        width, height = self.size
        body = "\n".join(self.parts)
        return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" '
                f'height="{height}" role="img" font-family="STIX, STIX Two Text, Georgia, serif">\n'
                f'<title>{self.title}</title>\n{body}\n</svg>\n')


def balance():
    d = Drawing(620, 250, "The energy balance of a patch")
    d.polygon([(190, 200), (400, 200), (450, 170), (240, 170)], FILL)
    d.text((330, 232), "patch <tspan font-style='italic'>i</tspan>, reflectance <tspan font-style='italic'>ρ</tspan>")
    for x in (90, 140, 190):
        d.line((x, 60), (x + 105, 175), SOFT, 1.8, arrow=True)
    d.text((10, 40), "arriving from all other patches", anchor="start", color=SOFT)
    for x, y in ((310, 62), (355, 50), (400, 62)):
        d.line((345 + (x - 355) * 0.3, 170), (x, y), WARM, 1.8, arrow=True)
    d.text((610, 40), "emitted and reflected: radiosity", anchor="end", color=WARM)
    d.line((345, 187), (345, 216), SOFT, 1.2, "4 3")
    d.text((460, 216), "the rest is absorbed", anchor="start", color=SOFT, size=15)
    return d


def pair():
    d = Drawing(620, 330, "Two patches, the line between their centres and the angles to their normals")
    a, b = (170, 255), (440, 95)
    d.polygon([(90, 275), (220, 285), (255, 235), (120, 225)], FILL)
    d.polygon([(420, 45), (490, 70), (465, 145), (395, 115)], SECOND)
    d.line(a, b, INK, 1.5, "6 4")
    d.line(a, (182, 125), WARM, 2, arrow=True)
    d.line(b, (335, 60), WARM, 2, arrow=True)
    d.arc(a, 58, 31, 84)
    d.arc(b, 58, 162, 210)
    d.dot(a)
    d.dot(b)
    d.symbol((212, 190), "θ", "s")
    d.symbol((366, 101), "θ", "j")
    d.symbol((318, 200), "r")
    d.symbol((164, 125), "n", "s", "end")
    d.symbol((330, 50), "n", "j", "end")
    d.symbol((160, 312), "A", "s")
    d.symbol((512, 105), "A", "j")
    return d


def additivity():
    d = Drawing(620, 210, "The form factor to a whole is the sum of those to its parts")
    for x, parts in ((40, 1), (350, 2)):
        d.polygon([(x, 180), (x + 90, 180), (x + 115, 155), (x + 25, 155)], FILL)
        d.polygon([(x + 115, 30), (x + 165, 30), (x + 195, 70), (x + 145, 70)], SECOND)
        if parts == 2:
            d.polygon([(x + 165, 30), (x + 215, 30), (x + 245, 70), (x + 195, 70)], FILL)
            d.line((x + 62, 165), (x + 155, 58), WARM, 1.6, arrow=True)
            d.line((x + 62, 165), (x + 205, 58), WARM, 1.6, arrow=True)
        else:
            d.polygon([(x + 115, 30), (x + 215, 30), (x + 245, 70), (x + 145, 70)], SECOND)
            d.line((x + 62, 165), (x + 178, 58), WARM, 1.6, arrow=True)
    d.text((320, 115), "=", 26)
    d.text((205, 140), "F(<tspan font-style='italic'>s</tspan>→<tspan font-style='italic'>j</tspan>∪<tspan font-style='italic'>k</tspan>)")
    d.text((545, 140), "F(<tspan font-style='italic'>s</tspan>→<tspan font-style='italic'>j</tspan>) + F(<tspan font-style='italic'>s</tspan>→<tspan font-style='italic'>k</tspan>)", 16)
    return d


def subdivision():
    d = Drawing(620, 268, "Two faces that meet at an edge, cut into patches")
    left = [[(60 + 55 * i + 12 * j, 60 + 55 * j - 4 * i) for i in range(4)] for j in range(4)]
    for j in range(3):
        for i in range(3):
            d.polygon([left[j][i], left[j][i + 1], left[j + 1][i + 1], left[j + 1][i]], FILL)
    edge = [row[3] for row in left]
    right = [[(x + 34 + 48 * i, y + 14 * i + 3) for i in range(4)] for x, y in edge]
    for j in range(3):
        for i in range(3):
            d.polygon([right[j][i], right[j][i + 1], right[j + 1][i + 1], right[j + 1][i]], SECOND)
    for row in left:
        for point in row:
            d.dot(point, 4)
    for row in right:
        for point in row:
            d.dot(point, 4, WARM)
    d.text((125, 30), "one face, 9 patches, 16 vertices", 15)
    d.text((420, 30), "another face, its own 16 vertices", 15, color=WARM)
    d.text((610, 140), "drawn apart:", 15, "end")
    d.text((610, 160), "the edge is", 15, "end")
    d.text((610, 180), "one place", 15, "end")
    return d


def nodal():
    d = Drawing(620, 260, "The colour of a vertex is the mean of the patches that share it")
    values = [[0.9, 0.7], [0.5, 0.3]]
    for j in range(2):
        for i in range(2):
            d.rect(60 + 90 * i, 40 + 90 * j, 90, 90, FILL)
            d.text((105 + 90 * i, 90 + 90 * j), f"{values[j][i]}", 18)
    d.dot((150, 130), 6, WARM)
    d.line((275, 130), (345, 130), INK, 1.8, arrow=True)
    means = [[0.9, 0.8, 0.7], [0.7, 0.6, 0.5], [0.5, 0.4, 0.3]]
    for j in range(2):
        for i in range(2):
            d.rect(390 + 80 * i, 50 + 80 * j, 80, 80)
    for j in range(3):
        for i in range(3):
            at = (390 + 80 * i, 50 + 80 * j)
            d.dot(at, 15, "var(--paper, #fff)")
            d.text((at[0], at[1] + 5), f"{means[j][i]:.1f}", 15, color=WARM if i == j == 1 else INK)
    d.text((150, 248), "radiance of patches", 15)
    d.text((470, 248), "mean at vertices", 15)
    return d


def bits():
    d = Drawing(620, 190, "The three bytes of the ID 70,000 as red, green and blue")
    number = 70000
    for place, (name, color) in enumerate([("red: high byte", "#dc2626"), ("green: middle", "#16a34a"),
                                           ("blue: low byte", "#2563eb")]):
        byte = number >> (16 - 8 * place) & 255
        x = 30 + 195 * place
        for bit in range(8):
            d.rect(x + 21 * bit, 70, 21, 30, FILL if byte >> (7 - bit) & 1 else "none")
            d.text((x + 21 * bit + 10.5, 91), str(byte >> (7 - bit) & 1), 15)
        d.line((x, 108), (x + 168, 108), color, 5)
        d.text((x + 84, 132), name, 16)
        d.text((x + 84, 162), str(byte), 20)
        d.text((x + 84, 55), f"bits {23 - 8 * place} to {16 - 8 * place}", 14, color=SOFT)
    d.text((310, 26), "ID 70,000 = 1 · 65,536 + 17 · 256 + 112", 18)
    return d


def delta():
    d = Drawing(620, 200, "A pixel of the top face and one of a side face of the hemicube")
    for x, where in ((150, "top"), (470, "side")):
        o, pixel = (x, 165), (x + 45, 75) if where == "top" else (x + 90, 120)
        d.line((x - 130, 165), (x + 130, 165), SOFT)
        d.rect(x - 90, 75, 180, 90)
        d.dot(o)
        d.line(o, (x, 45), INK, 1.2, "5 4", arrow=True)
        d.line(o, pixel, WARM, 2, arrow=True)
        if where == "top":
            d.line((x + 37, 75), (x + 53, 75), WARM, 6)
            d.symbol((x + 22, 67), "x")
            d.text((x - 58, 125), "height 1", 14)
            d.arc(o, 45, 64, 90)
            d.symbol((x + 13, 106), "θ", "s")
        else:
            d.line((x + 90, 112), (x + 90, 128), WARM, 6)
            d.symbol((x + 104, 147), "z")
            d.text((x + 45, 185), "distance 1", 14)
            d.arc(o, 38, 27, 90)
            d.symbol((x + 26, 120), "θ", "s")
        d.text((x, 24), f"a pixel of the {where} face", 16)
    return d


def unfolded():
    table = json.loads((HERE / "figures.json").read_text())["delta_8_table"]
    d = Drawing(620, 620, "The hemicube of size 8 unfolded, each pixel with 1000 times its delta form factor")
    most = max(table)
    for y in range(16):
        for x in range(16):
            value = table[16 * y + x]
            if value == 0:
                continue
            left, top = 20 + 36.25 * x, 20 + 36.25 * (15 - y)
            d.parts.append(f'<rect x="{left:.1f}" y="{top:.1f}" width="36.2" height="36.2" fill="{WARM}" '
                           f'fill-opacity="{0.8 * value / most:.3f}" stroke="{SOFT}" stroke-width="0.6"/>')
            d.text((left + 18, top + 23), f"{1000 * value:.1f}", 12.5)
    d.rect(20 + 36.25 * 4, 20 + 36.25 * 4, 290, 290, line=2.5)
    for x, y in ((92, 92), (528, 92), (92, 538), (528, 538)):
        d.text((x, y), "unused", 15, color=SOFT)
    return d


def nusselt():
    d = Drawing(620, 320, "Nusselt's analogy: up to the hemisphere, then down to the disc")
    o = (270, 260)
    d.path("M110,260 A160,160 0 0 1 430,260", INK)
    d.line((60, 260), (560, 260), SOFT)
    d.polygon([(470, 60), (560, 130), (540, 150), (452, 82)], SECOND)
    spots = []
    for target in ((452, 82), (540, 150)):
        d.line(o, target, SOFT, 1.2, "5 4")
        length = math.dist(o, target)
        on = (o[0] + 160 * (target[0] - o[0]) / length, o[1] + 160 * (target[1] - o[1]) / length)
        spots.append(on)
        d.line(on, (on[0], 260), WARM, 1.3, "3 3")
    d.path(f"M{spots[0][0]:.1f},{spots[0][1]:.1f} A160,160 0 0 1 {spots[1][0]:.1f},{spots[1][1]:.1f}", WARM, width=5)
    d.line((spots[0][0], 260), (spots[1][0], 260), WARM, 6)
    d.dot(o)
    d.symbol((540, 70), "A", "j")
    d.text((270, 290), "radius 1", 15)
    d.text(((spots[0][0] + spots[1][0]) / 2 + 14, 292), "area on the disc = π · F", 16, "middle", WARM)
    return d


DIAGRAMS = {"balance": balance, "pair": pair, "additivity": additivity, "subdivision": subdivision, "nodal": nodal,
            "bits": bits, "delta": delta, "unfolded": unfolded, "nusselt": nusselt}


def write_all():
    for name, draw in DIAGRAMS.items():
        (FIGURES / f"{name}.svg").write_text(draw().svg())


def stale():
    """The names of drawings that are missing, or other than what is drawn now."""
    files = {FIGURES / f"{name}.svg": draw for name, draw in DIAGRAMS.items()}
    return [file.name for file, draw in files.items() if not file.exists() or file.read_text() != draw().svg()]


def main():
    if sys.argv[1:] != ["--check"]:
        write_all()
    elif stale():
        sys.exit(f"{', '.join(stale())}: found another drawing than diagrams.py makes; run handout/diagrams.py")


if __name__ == "__main__":
    main()
