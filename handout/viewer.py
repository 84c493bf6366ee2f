"""A picture of the viewer's window, as its user sees it: on an X server of its own (Xvfb), by real keys and clicks (xdotool)."""
import contextlib
import json
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import time
import zlib
from pathlib import Path

SIZE = (1120, 720)
PATCH = (802, 476)  # in the window as it is before a patch is picked: the top of the small block
SHOTS = 600
WAIT = 240.0  # seconds


@contextlib.contextmanager
def display(folder):
    """An X server that chooses its own number and keeps what it shows in a file."""
    read, write = os.pipe()
    server = subprocess.Popen(["Xvfb", "-displayfd", str(write), "-fbdir", folder, "-noreset", "-screen", "0", f"{SIZE[0]}x{SIZE[1]}x24"],
                              pass_fds=[write], stderr=subprocess.DEVNULL)
    os.close(write)
    try:
        with os.fdopen(read) as number:
            places = {key: value for key, value in os.environ.items() if key != "WAYLAND_DISPLAY"}
            yield {**places, "DISPLAY": ":" + number.readline().strip()}
    finally:
        server.terminate()
        server.wait()


def state_when(trace, holds):
    """What the viewer writes of itself, once that holds."""
    end = time.monotonic() + WAIT
    while time.monotonic() < end:
        with contextlib.suppress(OSError, ValueError):
            state = json.loads(trace.read_text())
            if holds(state):
                return state
        time.sleep(0.1)
    sys.exit("radlab: handout: the viewer did not come so far; run ./radlab view --solution to see why")


def rows_of(dump):
    """The lines of an XWD file of 32 bits a pixel, as bytes red, green, blue."""
    head = struct.unpack(">25I", dump[:100])
    width, height, stride = head[4], head[5], head[12]
    start = head[0] + 12 * head[19]
    for y in range(height):
        line = dump[start + y * stride:start + y * stride + 4 * width]
        colours = bytearray(3 * width)
        colours[0::3], colours[1::3], colours[2::3] = line[2::4], line[1::4], line[0::4]
        yield bytes(colours)


def png(rows):
    """A PNG of lines of bytes, each as the difference from the pixel to its left or from the line above, whichever is less."""
    def part(name, body):
        return struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body))

    packed, above = bytearray(), bytes(len(rows[0]))
    for row in rows:
        ways = [bytes([1]) + bytes((a - b) & 255 for a, b in zip(row, bytes(3) + row)),
                bytes([2]) + bytes((a - b) & 255 for a, b in zip(row, above))]
        packed += min(ways, key=lambda way: sum(min(value, 256 - value) for value in way))
        above = row
    size = struct.pack(">II5B", len(rows[0]) // 3, len(rows), 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + part(b"IHDR", size) + part(b"IDAT", zlib.compress(bytes(packed), 9)) + part(b"IEND", b"")


def picture_of(view, scene, target):
    """Shoots some of the light, stops, picks a patch, and leaves what the window then shows in that file."""
    for tool in (view, "Xvfb", "xdotool"):
        if not shutil.which(tool):
            sys.exit(f"radlab: handout: {tool} was not found, so there is no picture of the viewer; on Debian: apt-get install xvfb xdotool")
    with tempfile.TemporaryDirectory() as folder, display(folder) as places:
        trace = Path(folder) / "trace.json"
        viewer = subprocess.Popen([view, scene, "--solution", "--play", "--forget", "--patch-size", "30", "--width", str(SIZE[0]),
                                   "--height", str(SIZE[1]), "--trace", trace, "--folder", Path(folder) / "kept"], env=places)
        try:
            def press(*words):
                subprocess.run(["xdotool", *map(str, words)], env=places, check=True)
            state_when(trace, lambda state: state["shots"] >= SHOTS)
            press("key", "space")
            state_when(trace, lambda state: not state["playing"])
            press("mousemove", *PATCH, "click", 1)
            state_when(trace, lambda state: state["sum"] is not None and "pixels' weights" in state["buttons"])
            press("mousemove", SIZE[0] - 1, SIZE[1] - 1)  # out of the picture
            time.sleep(3)  # what is still drawn
            rows = list(rows_of((Path(folder) / "Xvfb_screen0").read_bytes()))
        finally:
            viewer.terminate()
            viewer.wait()
    target.write_bytes(png(rows))
