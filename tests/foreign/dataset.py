"""All that a technician would take of one finger, in a folder: recording, presses, pictures to measure, and the truth.

    camera.yaml  recording/*.png  presses/*.png  tests/*.png  truth/*.npz  finger.json (written last)
    bodies/*.png, rod.stl: presses of a rod with round ends, and its mesh
    points/*.png: pairs of points at the places of two presses, without noise, of the classes of POINTS_OF
    degraded/*.png, frozen/*.png: pictures that cannot be measured rightly, of the class of that name
"""

from __future__ import annotations

import json
import shutil
from dataclasses import asdict, dataclass, replace
from pathlib import Path

import cv2
import numpy as np

from contact import Body
from face import Face, Pose
from finger import Finger, draw_finger
from meshes import capsule, write_stl
from mirror import mirrored_camera, mirrored_truth
from points import DISTANCES_MM, Pair
from render import Renderer

VERSION = 10
PRESSES = 6
RODS = 2
TESTS = 10
POINTS_OF = ("clean", "scattering")


@dataclass(frozen=True)
class Shot:
    """One picture to measure. what: untouched | inside | rim | wide | steep."""

    what: str
    pose: Pose
    bodies: tuple[Body, ...]
    hidden: frozenset[int]


def folder_of(cache: Path, seed: int, index: int, kind: str) -> Path:
    return cache / f"{seed}-{index:03d}-{kind}"


def make_finger(cache: Path, seed: int, index: int, kind: str) -> Path:
    """Renders the finger unless the cache has it."""
    folder = folder_of(cache, seed, index, kind)
    facts = folder / "finger.json"
    if facts.exists() and json.loads(facts.read_text()).get("version") == VERSION:
        return folder
    if folder.exists():
        shutil.rmtree(folder)
    for part in ("recording", "presses", "bodies", "tests", "truth"):
        (folder / part).mkdir(parents=True)
    finger = draw_finger(seed, index, kind)
    renderer = Renderer(finger)
    rng = np.random.default_rng([seed, index, 77])
    told = mirrored_camera(finger.told_camera) if finger.mirrored else finger.told_camera
    (folder / "camera.yaml").write_text(told.yaml())
    _record(folder, finger, renderer, rng)
    presses = _press(folder, finger, renderer, rng)
    shots = _shoot(folder, finger, renderer, rng)
    rods = _press_rods(folder, finger, renderer, np.random.default_rng([seed, index, 78]))
    if kind == "degraded":
        _degrade(folder, finger, renderer, rng)
    pairs = _part_points(folder, finger, renderer, presses) if kind in POINTS_OF else []
    facts.write_text(json.dumps(_facts(finger, presses, rods, shots, pairs), indent=1))
    return folder


def _take(path: Path, finger: Finger, light: np.ndarray, rng: np.random.Generator, gain: float = 1.0) -> None:
    """Exposes a picture and writes it; JPEG blocks and noise are those of the mirrored one."""
    _save(path, finger.sensor.expose(light[:, ::-1] if finger.mirrored else light, rng, gain))


def _save(path: Path, picture: np.ndarray) -> None:
    if not cv2.imwrite(str(path), picture, [cv2.IMWRITE_PNG_COMPRESSION, 1]):
        raise OSError(f"could not write {path}")


def _lamp_gains(finger: Finger, rng: np.random.Generator) -> np.ndarray:
    return 1 + finger.lamp_drift * rng.standard_normal(len(finger.lamps.strengths))


def _record(folder: Path, finger: Finger, renderer: Renderer, rng: np.random.Generator) -> None:
    rates = np.array([3.0, 5.0, 2.0, 4.0])[rng.permutation(4)] + rng.uniform(-0.4, 0.4, 4)
    begin, end = _lamp_gains(finger, rng), _lamp_gains(finger, rng)
    motion = finger.motion
    for frame in range(finger.frames):
        time = frame / (finger.frames - 1)
        part = np.sin(2 * np.pi * rates * time)
        if motion.start_twist_deg:
            part[3] = np.sin(np.arcsin(motion.start_twist_deg / motion.twist_deg) + 2 * np.pi * rates[3] * time)
        light, _ = renderer.light(motion.pose(part), (1 - time) * begin + time * end)
        _take(folder / "recording" / f"frame_{frame:04d}.png", finger, light, rng)


def _press(folder: Path, finger: Finger, renderer: Renderer, rng: np.random.Generator) -> list[dict[str, object]]:
    presses = []
    for number in range(PRESSES):
        pose = finger.motion.pose(rng.uniform(-0.8, 0.8, 4))
        depth = finger.rest.layer_mm * (0.2 + 0.55 * (number + rng.uniform(0, 1)) / PRESSES)
        body = _inside(finger, pose, rng, "ball", depth, (finger.ball_radius_mm,))
        light, _ = renderer.light(pose, _lamp_gains(finger, rng), (body,))
        _take(folder / "presses" / f"press_{number}.png", finger, light, rng)
        presses.append(asdict(body) | {"pose": asdict(pose)})
    return presses


def _under(face: Face, outer_mm: np.ndarray) -> np.ndarray:
    """Points of the view face at the x and y of others: where the truth of their depth along z stands."""
    origins = (outer_mm * [1.0, 1.0, 0.0])[None]
    s, w = face.meet(origins, np.broadcast_to([0.0, 0.0, 1.0], origins.shape))
    return face.point(s[0], w[0])


def _part_points(
    folder: Path, finger: Finger, renderer: Renderer, presses: list[dict[str, object]]
) -> list[dict[str, object]]:
    """At the places of the press nearest to the base and of that nearest to the tip, in their poses."""
    (folder / "points").mkdir()
    noiseless = replace(finger, sensor=replace(finger.sensor, read_sd=0.0, shot=0.0, jpeg_quality=None))
    order = sorted(range(PRESSES), key=lambda i: presses[i]["s_mm"])
    made = []
    for number in (order[0], order[-1]):
        press = presses[number]
        pose = Pose(**press["pose"])
        face = Face(finger.rest, pose)
        for is_along in (True, False):
            for distance in DISTANCES_MM:
                pair = Pair(press["s_mm"], press["w_mm"], distance, is_along)
                light, _ = renderer.light(pose, pairs=(pair,))
                name = f"press_{number}_{'along' if is_along else 'across'}_{round(100 * distance):03d}"
                _take(folder / "points" / f"{name}.png", noiseless, light, np.random.default_rng(1))
                places = finger.camera.project(_under(face, face.point(*pair.places().T, finger.rest.layer_mm)))
                if finger.mirrored:
                    places[:, 0] = finger.camera.width_px - 1 - places[:, 0]
                facts = {"name": name, "press": f"press_{number}", "places_px": places.tolist()}
                made.append(facts | {"distance_mm": distance, "is_along": is_along})
    return made


def _press_rods(folder: Path, finger: Finger, renderer: Renderer, rng: np.random.Generator) -> list[dict[str, object]]:
    """Beside the balls, and from numbers of their own: balls and pictures to measure are the same without them."""
    size = (float(rng.uniform(2, 3.5)), float(rng.uniform(2.5, 4)))
    write_stl(folder / "bodies" / "rod.stl", capsule(*size))
    rods = []
    for number in range(RODS):
        pose = finger.motion.pose(rng.uniform(-0.8, 0.8, 4))
        depth = finger.rest.layer_mm * rng.uniform(0.35, 0.6)
        body = _inside(finger, pose, rng, "cylinder", depth, size)
        light, _ = renderer.light(pose, _lamp_gains(finger, rng), (body,))
        _take(folder / "bodies" / f"rod_{number}.png", finger, light, rng)
        rods.append(asdict(body))
    return rods


def _place(finger: Finger, pose: Pose, rng: np.random.Generator, border_mm: float) -> tuple[float, float]:
    """On the face, border_mm from its edges and well in the picture."""
    rest, camera = finger.rest, finger.camera
    face = Face(rest, pose)
    border = min(border_mm, 0.42 * rest.width_mm)
    for _ in range(500):
        s = rng.uniform(border, rest.length_mm - border)
        w = rng.uniform(-1, 1) * (rest.width_mm / 2 - border)
        ends = camera.project(face.point(np.array([s - border, s + border]), np.array([w, w])))
        if 3 < ends[0, 0] and ends[1, 0] < camera.width_px - 4:
            return float(s), float(w)
    return rest.length_mm / 2, 0.0


def _inside(
    finger: Finger, pose: Pose, rng: np.random.Generator, shape: str, depth: float, size: tuple[float, ...]
) -> Body:
    turn = float(rng.uniform(0, np.pi))
    reach = Body(shape, 0, 0, depth, size, turn).reach_mm()
    s, w = _place(finger, pose, rng, reach + 0.8)
    return Body(shape, s, w, float(depth), size, turn)


def _size(rng: np.random.Generator, shape: str) -> tuple[float, ...]:
    if shape == "ball":
        return (float(rng.uniform(2, 6)),)
    if shape == "cylinder":
        return (float(rng.uniform(1.5, 4)), float(rng.uniform(1, 4)))
    if shape == "ring":
        return (float(rng.uniform(1.2, 2)), float(rng.uniform(2, 3)))
    if shape == "tee":
        return (float(rng.uniform(1.2, 1.8)), float(rng.uniform(3, 5)))
    if shape == "two_balls":
        return (float(rng.uniform(2, 3)), float(rng.uniform(7, 9)))
    if shape == "punch":
        return (float(rng.uniform(1.5, 3)), 0.1)
    if shape == "pin":
        return (0.5, 0.05)
    if shape == "thread":  # M8
        return (4.0, float(rng.uniform(3, 5)), 1.25)
    return (float(rng.uniform(3, 7)), float(rng.uniform(3, 6)), float(rng.uniform(0.8, 1.4)))


WORKSHOP = ("ball", "punch", "pin", "cylinder", "thread")  # what a technician has at hand
SMOOTH = ("ball", "ball", "cylinder", "ring", "tee", "two_balls", "plate")


def _touch(finger: Finger, pose: Pose, rng: np.random.Generator, what: str) -> tuple[Body, ...]:
    rest = finger.rest
    depth = rest.layer_mm * float(np.exp(rng.uniform(np.log(0.12), np.log(0.75))))
    if what == "inside":
        shape = str(rng.choice(WORKSHOP if finger.kind == "scattering" else SMOOTH))
        return (_inside(finger, pose, rng, shape, depth, _size(rng, shape)),)
    if what == "rim":
        radius = float(rng.uniform(2.5, 5.5))
        reach = np.sqrt(2 * radius * depth)
        end, side = rng.choice([(1, 0), (0, 1), (1, 1)], p=[0.3, 0.5, 0.2])
        s, w = _place(finger, pose, rng, reach)
        if end:
            s = rest.length_mm - rng.uniform(-0.2, 0.8) * reach
        if side:
            w = rng.choice([-1, 1]) * (rest.width_mm / 2 - rng.uniform(-0.2, 0.8) * reach)
        return (Body("ball", float(s), float(w), depth, (radius,)),)
    if what == "wide":
        length, width = rng.uniform(0.35, 0.6) * rest.length_mm, rng.uniform(0.8, 1.2) * rest.width_mm
        s = rng.uniform(0.35, 0.65) * rest.length_mm
        return (Body("plate", float(s), 0.0, min(depth, 0.6), (float(length), float(width), 1.5)),)
    steep = (float(rng.uniform(3, 6)), float(rng.uniform(3, 5)), 0.1)
    return (_inside(finger, pose, rng, "step", depth, steep),)


def _kinds(finger: Finger) -> list[str]:
    kinds = ["untouched", "untouched"] + ["inside"] * (TESTS - 3) + ["rim"]
    special = {"rim": "rim", "wide": "wide", "steep": "steep"}.get(finger.kind)
    if special:
        kinds[4:] = [special] * (TESTS - 4)
    return kinds


def _shoot(folder: Path, finger: Finger, renderer: Renderer, rng: np.random.Generator) -> list[dict[str, object]]:
    shots = []
    for number, what in enumerate(_kinds(finger)):
        pose = finger.motion.pose(rng.uniform(-0.8, 0.8, 4))
        bodies = () if what == "untouched" else _touch(finger, pose, rng, what)
        covered = rng.random(len(finger.dots)) < (0.12 if rng.random() < 0.4 else 0.0)
        shot = Shot(what, pose, bodies, frozenset(np.flatnonzero(covered).tolist()))
        light, truth = renderer.light(pose, _lamp_gains(finger, rng), bodies, shot.hidden, with_truth=True)
        name = f"test_{3 * number + 1:02d}"  # not numbered through: single pictures, no video
        _take(folder / "tests" / f"{name}.png", finger, light, rng)
        assert truth is not None
        truth = mirrored_truth(truth) if finger.mirrored else truth
        np.savez_compressed(
            folder / "truth" / f"{name}.npz",
            depth_mm=truth.depth_mm,
            border_mm20=np.clip(np.nan_to_num(truth.border_mm) * 20, 0, 255).astype(np.uint8),
            knots_u=truth.knots_u,
            knots_v=truth.knots_v,
            knot_z_mm=truth.knot_z_mm,
            knot_normal_z=truth.knot_normal_z,
            markers_px=truth.markers_px,
            markers_shown=truth.markers_shown,
        )
        shots.append(
            {
                "name": name,
                "what": what,
                "pose": asdict(pose),
                "bodies": [asdict(body) for body in bodies],
                "regions": truth.regions,
            }
        )
    return shots


def _degrade(folder: Path, finger: Finger, renderer: Renderer, rng: np.random.Generator) -> None:
    """Far too bright, black, of another finger, and a camera that hangs while it says that it delivers."""
    (folder / "degraded").mkdir()
    (folder / "frozen").mkdir()
    pose = finger.motion.pose(rng.uniform(-0.5, 0.5, 4))
    light, _ = renderer.light(pose)
    _take(folder / "degraded" / "too_bright.png", finger, light, rng, 1.6)
    _take(folder / "degraded" / "black.png", finger, light, rng, 0.004)
    slimmer = replace(finger.rest, width_mm=0.8 * finger.rest.width_mm, layer_mm=1.2 * finger.rest.layer_mm)
    shifted = tuple(replace(dot, s_mm=dot.s_mm + 2.5) for dot in finger.dots[1:])
    other, _ = Renderer(replace(finger, rest=slimmer, dots=shifted)).light(pose)
    _take(folder / "degraded" / "other_finger.png", finger, other, rng)
    hanging = finger.sensor.expose(light[:, ::-1] if finger.mirrored else light, rng)
    for frame in range(8):
        _save(folder / "frozen" / f"frame_{frame:03d}.png", hanging)


def _facts(
    finger: Finger,
    presses: list[dict[str, object]],
    rods: list[dict[str, object]],
    shots: list[dict[str, object]],
    pairs: list[dict[str, object]],
) -> dict[str, object]:
    camera = finger.camera
    return {
        "version": VERSION,
        "class": finger.kind,
        "seed": finger.seed,
        "index": finger.index,
        "size": [camera.width_px, camera.height_px],
        "lens": camera.model,
        "mirrored": finger.mirrored,
        "width_mm": finger.rest.width_mm,
        "layer_mm": finger.rest.layer_mm,
        "length_mm": finger.rest.length_mm,
        "per_row": finger.per_row,
        "polarity": finger.polarity,
        "ball_radius_mm": finger.ball_radius_mm,
        "noise_grey": float(np.hypot(finger.sensor.read_sd, np.sqrt(finger.sensor.shot * 140))),
        "defocus_px": finger.sensor.defocus_px,
        "jpeg": finger.sensor.jpeg_quality,
        "lift_off_mm": finger.skin.lift_off_mm,
        "spread_mm": finger.spread_mm,
        "lamp_drift": finger.lamp_drift,
        "frames": finger.frames,
        "motion": asdict(finger.motion),
        "blemishes": len(finger.blemishes),
        **finger.layer_facts,
        "presses": presses,
        "rods": rods,
        "shots": shots,
        "pairs": pairs,
    }
