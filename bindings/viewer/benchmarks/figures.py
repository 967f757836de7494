"""figures.py [--quick]: the size of pages, the time that they take to open, and the rates at which headless Chromium
shows them, which draws by software. The recordings are synthetic: all blocks move and turn in all frames, each at a
speed of its own, and each has a contact with a force that changes. A run whose blocks rest takes less.

Three rates are measured in turn: of an empty picture, of the same triangles in one colour that do not move, and of the
run. Each has two numbers: frames per second, and processor time of all processes of the browser in ms per frame, which
other work on the machine changes less."""
import os
import pathlib
import sys
import tempfile
import time

import numpy as np

from halfspace._viewer import viewer_library, viewer_page

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "tests"))
from browser import Browser  # noqa: E402

BOX = np.array([[x, y, z] for z in (-0.5, 0.5) for y in (-0.5, 0.5) for x in (-0.5, 0.5)])
BOX_FACES = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
SQUARE = np.array([[-0.5, -0.5, 0], [0.5, -0.5, 0], [0.5, 0.5, 0], [-0.5, 0.5, 0]])


def write_recording(path, dimension, block_count, frame_count):
    """Blocks that start in a lattice, fly apart, and tumble."""
    viewer, random = viewer_library(), np.random.default_rng(1)
    recording = viewer.hs_recording_create(dimension, b"Tumbling blocks")

    def call(name, *arguments):
        values = [value.ctypes.data if isinstance(value, np.ndarray) else value for value in arguments]
        if getattr(viewer, f"hs_recording_{name}")(recording, *values) < 0:
            raise RuntimeError(viewer.hs_recording_error().decode())

    side = int(np.ceil(block_count ** (1 / dimension)))
    lattice = np.array([[i // side**axis % side for axis in range(dimension)] for i in range(block_count)], float)
    start = np.zeros((block_count, 3))
    start[:, :dimension] = 1.05 * lattice
    vertices, faces = (SQUARE, [[0, 1, 2, 3]]) if dimension == 2 else (BOX, BOX_FACES)
    sizes, corners = np.array([len(face) for face in faces], np.int32), np.array(sum(faces, []), np.int32)
    for place in start:
        pose = np.array([*place, 0, 0, 0, 1])
        at = vertices + place
        call("add_block", b"", 2, 0, pose, len(at), at, len(faces), sizes, corners)
    velocities = random.normal(0, 2, start.shape) + [1, 0, 0]
    turns = random.normal(0, 1, start.shape)
    if dimension == 2:
        velocities[:, 2] = turns[:, 0] = turns[:, 1] = 0
    numbers = np.arange(block_count)
    partner = (numbers + 1) % block_count
    for frame in range(frame_count):
        moment = frame * 0.02
        call("add_frame", moment)
        places = start + moment * velocities + random.normal(0, 0.01, start.shape) * (np.arange(3) < dimension)
        angles = np.linalg.norm(turns, axis=1) * moment
        axes = turns / np.linalg.norm(turns, axis=1)[:, None]
        poses = np.hstack((places, np.sin(angles / 2)[:, None] * axes, np.cos(angles / 2)[:, None]))
        call("set_poses", block_count, numbers, np.ascontiguousarray(poses))
        for name, unit in ((b"speed", b"m/s"), (b"angular speed", b"rad/s"), (b"contact force", b"N")):
            call("set_values", name, unit, block_count, numbers, np.exp(random.normal(0, 1, block_count)))
        points = 0.5 * (places + places[partner])
        forces = 1e4 * np.exp(random.normal(0, 1, block_count))[:, None] * [0.3, 1, 0.2] * (np.arange(3) < dimension)
        call("set_contacts", block_count, numbers, partner, points, np.ascontiguousarray(forces),
             np.linalg.norm(forces, axis=1))
    viewer.hs_recording_write(recording, str(viewer_page()).encode(), str(path).encode())
    viewer.hs_recording_destroy(recording)


EMPTY = "mesh.visible = false; picture.renderer.render(picture.scene, camera)"
BARE = "mesh.material = bare; picture.renderer.render(picture.scene, camera); mesh.material = material"
PLAYED = "await viewer.player.goTo((viewer.frame.number + 1) % viewer.recording.frameCount)"


def processor_seconds(process):
    """Processor seconds of a process and those that it has begun."""
    below, seconds = {}, {}
    for path in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            fields = path.read_text().rpartition(")")[2].split()
        except (FileNotFoundError, ProcessLookupError):
            continue
        below.setdefault(int(fields[1]), []).append(int(path.parent.name))
        seconds[int(path.parent.name)] = (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")
    pending, total = [process], 0
    while pending:
        process = pending.pop()
        total += seconds.get(process, 0)
        pending += below.get(process, [])
    return total


def rate(browser, script, seconds):
    """Frames per second and processor time in ms per frame, as fast as a script can show frames."""
    process = browser.driver.service.process.pid
    before = processor_seconds(process)
    count, passed = browser.run(
        "const {picture} = viewer, {camera} = picture.control, {mesh, material} = picture.blockMesh;"
        "const bare = new THREE.MeshBasicMaterial({color: 0x8080ff, side: material.side});"
        "let count = 0; const begin = performance.now();"
        "while (performance.now() - begin < 1000 * a[0]) {"
        f"  {script};"
        "  await new Promise((next) => requestAnimationFrame(next));"
        "  ++count;"
        "}"
        "mesh.visible = true;"
        "return [count, (performance.now() - begin) / 1000]", seconds)
    return count / passed, 1000 * (processor_seconds(process) - before) / count


def main():
    quick = "--quick" in sys.argv
    cases = [(2, 6000, 300), (3, 6000, 300), (3, 100000, 20)]
    if quick:
        cases = [(2, 500, 20), (3, 500, 20)]
    print("dimension  blocks  frames     MB  packed in s  opens in s   empty picture  bare triangles         the run")
    with tempfile.TemporaryDirectory() as folder, Browser() as browser:
        for dimension, blocks, frames in cases:
            page = pathlib.Path(folder, "page.html")
            begin = time.perf_counter()
            write_recording(page, dimension, blocks, frames)
            packed = time.perf_counter() - begin
            begin = time.perf_counter()
            browser.open(page)
            opened = time.perf_counter() - begin
            rates = [rate(browser, script, 2 if quick else 8) for script in (EMPTY, BARE, PLAYED)]
            size = page.stat().st_size / 1e6
            print(f"{dimension:9} {blocks:7} {frames:7} {size:6.1f} {packed:12.1f} {opened:11.1f}",
                  *(f"{count:6.1f}/s {cost:3.0f} ms" for count, cost in rates), flush=True)


if __name__ == "__main__":
    main()
