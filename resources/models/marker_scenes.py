"""Fingers drawn at random, rendered by `alltact simulate`: what the marker network is trained and judged on."""

from __future__ import annotations

import json
import random
import subprocess
from dataclasses import dataclass
from pathlib import Path

import cv2
import numpy as np

WIDTH, HEIGHT = 960, 540


@dataclass(frozen=True)
class Example:
    """grey: uint8. dots: rows of (u, v, half_u, half_v) in px of the dots that can be seen."""

    grey: np.ndarray
    dots: np.ndarray


def scene_text(seed: int, frames: int, is_worn: bool = True) -> str:
    """A finger, its light, its dots and its camera; every third has dark dots. is_worn False: with all dots as new."""
    draw = random.Random(seed)
    even = draw.uniform
    focal = even(430, 640)
    width_mm = even(18, 30)
    length_mm = even(80, 130)
    per_row = draw.randint(4, 9)
    is_dark = draw.random() < 0.33
    sides, dots = (even(0.3, 0.6), even(0.02, 0.12)) if is_dark else (even(0.05, 0.2), even(0.5, 0.95))
    light = even(0.5, 1.6)
    effects = [
        f"bend, q1_mm: {{from: {-even(2, 6):.2f}, to: {even(2, 6):.2f}}}, q2_mm: {{from: -4.0, to: 4.0}}",
        f"sway, sway_mm: {{from: -3.0, to: {even(1, 4):.2f}}}",
        f"markers, radius_mm: {even(0.6, 1.8):.3f}, setback_mm: {even(3.0, 7.0):.2f}, first: {even(0.05, 0.15):.3f}, "
        f"last: {even(0.8, 0.95):.3f}, albedo: {dots:.3f}",
        f"sides, albedo: {sides:.3f}, depth_mm: {even(11, 18):.2f}",
        f"layer, scatter_per_mm: {even(0.4, 0.9):.3f}, along: normal",
        "leds, lamps: ["
        f"{{at_mm: [0.0, -3.0, 0.0], power: {270000 * light * even(0.5, 1.5):.0f}}}, "
        f"{{at_mm: [0.0, 3.0, 0.0], power: {270000 * light * even(0.5, 1.5):.0f}}}, "
        f"{{at_mm: [4.0, 0.0, -20.0], power: {3300000 * light:.0f}, aim_mm: [71.0, {even(-15, 15):.1f}, 93.0], lobe: 8}}]",
        f"read, sd: {even(0.3, 4.0):.2f}",
        "quantisation",
    ]
    if draw.random() < 0.5:
        effects.append(f"occlusion, count: {draw.randint(1, per_row // 2)}")
    if draw.random() < 0.5:
        worn = sorted(draw.sample(range(2 * per_row), draw.randint(1, per_row)))
        wear = even(0.2, 0.75)
        if is_worn:
            effects.append(f"worn-marker, markers: {worn}, wear: {wear:.2f}")
    if draw.random() < 0.4:
        effects.append(f"defocus, focus_mm: {even(35, 90):.1f}, aperture_mm: {even(0.3, 1.5):.2f}")
    if draw.random() < 0.2:
        effects.append(f"ambient, level: {even(1, 12):.2f}")
    if draw.random() < 0.3:
        effects.append(
            f"ball, radius_mm: {even(2, 6):.1f}, s_mm: {{from: 20.0, to: {0.7 * length_mm:.1f}}}, "
            "y_mm: {from: -4.0, to: 4.0}, depth_mm: {from: 0.2, to: 1.0}"
        )
    if draw.random() < 0.2:
        effects.append(f"leak, grey: {even(1, 15):.1f}")
    if draw.random() < 0.2:
        effects.append(f"mjpeg, quality: {draw.randint(50, 95)}")
    lines = [
        f"name: dots {seed}",
        "why: >-",
        "  One of many fingers drawn at random, for the marker network.",
        f"frames: {frames}",
        "finger:",
        f"  camera: {{model: pinhole, size: [{WIDTH}, {HEIGHT}], fx: {focal:.1f}, fy: {focal:.1f}, cx: 479.5, cy: 269.5}}",
        f"  face: {{kind: fin_ray, width_mm: {width_mm:.2f}, layer_mm: 1.5}}",
        f"  markers: {{per_row: {per_row}, polarity: {'dark' if is_dark else 'bright'}}}",
        f"untouched: {{x_mm: {even(-30, -20):.1f}, z_mm: {even(26, 34):.1f}, incline_deg: {even(26, 42):.1f}, "
        f"length_mm: {length_mm:.1f}}}",
        "motion: {kind: random}",
        "effects:",
    ]
    return "\n".join(lines + [f"  - {{use: {effect}}}" for effect in effects]) + "\n"


def extent(seen: np.ndarray, u: float, v: float) -> tuple[float, float] | None:
    """Half extents of the dot at (u, v) in the map of what is seen; None where there is none of it."""
    x, y = int(round(u)), int(round(v))
    reach = 40
    x0, y0 = max(0, x - reach), max(0, y - reach)
    patch = (seen[y0 : y + reach + 1, x0 : x + reach + 1] == 3).astype(np.uint8)
    if patch.size == 0:
        return None
    count, labels, stats, centres = cv2.connectedComponentsWithStats(patch, connectivity=8)
    if count < 2:
        return None
    away = np.hypot(centres[1:, 0] + x0 - u, centres[1:, 1] + y0 - v)
    nearest = 1 + int(np.argmin(away))
    if away[nearest - 1] > 4:
        return None
    return 0.5 * stats[nearest, cv2.CC_STAT_WIDTH], 0.5 * stats[nearest, cv2.CC_STAT_HEIGHT]


def _simulate(program: Path, folder: Path, seed: int, text: str, maps: list[str]) -> list[dict] | None:
    scene = folder / f"scene_{seed}.yaml"
    scene.write_text(text)
    into = folder / f"frames_{seed}"
    command = [program, "simulate", scene, "-o", into, "--seed", str(seed), *maps]
    done = subprocess.run(command, capture_output=True, check=False).returncode == 0
    scene.unlink()
    if not done:
        return None
    frames = json.loads((into / "truth.json").read_text())["frames"]
    for frame in frames:
        frame["grey"] = cv2.imread(str(into / f"{frame['frame']}.png"), cv2.IMREAD_GRAYSCALE)
        frame["seen"] = cv2.imread(str(into / f"{frame['frame']}.seen.png"), cv2.IMREAD_GRAYSCALE) if maps else None
    for path in into.iterdir():
        path.unlink()
    into.rmdir()
    return frames


def render(program: Path, folder: Path, seed: int, frames: int) -> list[Example]:
    """The frames of one finger; [] for one that the program says cannot be."""
    folder.mkdir(parents=True, exist_ok=True)
    # Effects draw for themselves, so the same finger with new dots lies where the worn one does; only new ones are
    # in the map of what is seen.
    pictures = _simulate(program, folder, seed, scene_text(seed, frames), [])
    maps = _simulate(program, folder, seed, scene_text(seed, frames, is_worn=False), ["--maps"])
    if pictures is None or maps is None:
        return []
    examples = []
    for picture, truth in zip(pictures, maps):
        dots = []
        for marker in truth["markers"]:
            half = extent(truth["seen"], marker["u"], marker["v"]) if marker["visible"] else None
            if half is not None:
                dots.append((marker["u"], marker["v"], *half))
        examples.append(Example(picture["grey"], np.array(dots, np.float32).reshape(-1, 4)))
    return examples
