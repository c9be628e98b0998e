"""Fingers and recordings to measure, made once for all tests by the command line."""
import atexit, functools, os, shutil, subprocess, tempfile
from pathlib import Path

from alltact import calibrate  # as the command line does (alltact_test.py), but for the report

TOP = Path(__file__).parents[2]
PROGRAM = os.environ["ALLTACT_PROGRAM"]
FOLDER = Path(tempfile.mkdtemp(prefix="alltact-python-"))
atexit.register(shutil.rmtree, FOLDER, ignore_errors=True)
BALL_MM = 4.0
BENDING = 120  # frames of the reference recording


def alltact(*arguments, status: int = 0) -> str:
    run = subprocess.run([PROGRAM, *map(str, arguments)], stdin=subprocess.DEVNULL, capture_output=True, text=True)
    assert run.returncode == status, f"{arguments}: {run.returncode}\n{run.stderr}"
    return run.stdout


def scene(which: str, **changes) -> Path:
    """A scene that comes with the program, with lines (by what they begin with) in place of its own."""
    lines = []
    for line in (TOP / f"resources/scenes/{which}.yaml").read_text().splitlines():
        key = next((key for key in changes if line.strip().startswith(key.replace("_", " ") + ":")), None)
        lines.append(line[: len(line) - len(line.lstrip())] + changes[key] if key else line)
    file = FOLDER / f"{which}-{abs(hash(tuple(changes.items())))}.yaml"
    file.write_text("\n".join(lines) + "\n")
    return file


@functools.cache
def flat_finger() -> Path:
    """A flat sensor, calibrated; beside it its presses/ and the scene flat.yaml, 30 frames of a moving ball."""
    folder = FOLDER / "flat"
    for name in ("flat_press", "flat_reference"):
        alltact("simulate", scene(name), "-o", FOLDER / name)
    camera = FOLDER / "flat_camera.yaml"
    camera.write_text("model: orthographic\nsize: [480, 360]\nmm_per_px: 0.05\ncx: 239.5\ncy: 179.5\ndistortion: []\n"
                      "orientation: none\n")
    alltact("new", folder, "--camera", camera, "--layer-mm", 1.5, "--kind", "flat", "--plane-z-mm", 30)
    calibrate(folder, flat_presses(), BALL_MM, reference=flat_reference())
    return folder


def flat_presses() -> list:
    return sorted((FOLDER / "flat_press").glob("frame_*.png"))


def flat_reference() -> Path:
    return FOLDER / "flat_reference/frame_00000.png"


def flat_scene(frames: int = 30, frames_per_s: float = 30) -> Path:
    return scene("flat_press", frames=f"frames: {frames}\nframes_per_s: {frames_per_s}", s_mm="s_mm: {from: -6.0, to: 6.0}", y_mm="y_mm: {from: -4.0, to: 4.0}",
                 depth_mm="depth_mm: {from: 0.3, to: 1.1}")


SMALL = "camera: {model: pinhole, size: [480, 270], fx: 261.95, fy: 261.95, cx: 239.5, cy: 134.5}"


@functools.cache
def fin_ray() -> Path:
    """A Fin Ray finger with a reference recording, calibrated; pictures of 480 x 270 px."""
    folder = FOLDER / "left-07"
    alltact("simulate", scene("demo_reference", camera=SMALL, frames=f"frames: {BENDING}"), "-o", FOLDER / "bending", "--video", "--threads", 2)
    alltact("simulate", scene("demo_presses", camera=SMALL), "-o", FOLDER / "presses", "--threads", 2)
    camera = FOLDER / "camera.yaml"
    camera.write_text(f"model: pinhole\nsize: [480, 270]\nfx: 261.95\nfy: 261.95\ncx: 239.5\ncy: 134.5\ndistortion: []\n"
                      "orientation: none\n")
    alltact("new", folder, "--camera", camera, "--width-mm", 24, "--layer-mm", 1.5, "--per-row", 6)
    alltact("reference", folder, FOLDER / "bending/frames.mkv")
    calibrate(folder, FOLDER / "presses", BALL_MM)
    return folder


def touched_scene(frames: int, frames_per_s: float = 30) -> Path:
    """The Fin Ray finger bending, with a ball that wanders over it."""
    return scene("demo_presses", camera=SMALL, frames=f"frames: {frames}\nframes_per_s: {frames_per_s}", name="name: touched",
                 motion="motion: {kind: wander, frames_per_move: 8}", s_mm="s_mm: {from: 24.0, to: 84.0}",
                 depth_mm="depth_mm: {from: 0.2, to: 1.1}")
