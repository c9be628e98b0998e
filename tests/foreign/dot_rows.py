"""Both rows of marks of a finger, drawn at random: law of step, size and gap, and what is broken of them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from camera import Camera
from dots import Dot
from face import Face, Pose, RestShape


def draw_rows(
    rng: np.random.Generator, kind: str, camera: Camera, rest: RestShape
) -> tuple[tuple[Dot, ...], str, int] | None:
    """All marks, their polarity, and how many a row was meant to have; None where they do not fit into the picture."""
    polarity = "bright" if rng.random() < 0.7 or kind == "near-dots" else "dark"
    if kind == "no-dots":
        return (), polarity, 0
    count = int(rng.integers(4, 13))
    if kind == "few-dots":
        count = int(rng.integers(1, 4))
    if kind == "many-dots":
        count = int(rng.integers(16, 41))
    share = rng.choice([0.0, 1.0, rng.uniform(0.2, 0.8)])
    gap_px = rng.uniform(3, 14)
    radius_px = rng.uniform(1.5, 4.5) * (0.75 + 0.25 * camera.width_px / 640)
    contrast = rng.uniform(25, 140)
    if kind == "near-dots":
        gap_px, radius_px, contrast = rng.uniform(1.5, 5), rng.uniform(4, 7.5), rng.uniform(90, 170)
    if kind == "paper-dots":
        share = 1.0
    if polarity == "dark":
        contrast = rng.uniform(0.5, 0.9)
    face = Face(rest, Pose())
    s = np.linspace(0.0, rest.length_mm, 800)
    middle = camera.project(face.point(s, np.zeros(800)))[:, 0]
    seen = s[(middle > 0.03 * camera.width_px) & (middle < 0.95 * camera.width_px) & (middle < middle[-1] - radius_px - 4)]
    first, last = seen[0] + rng.uniform(0, 0.08) * np.ptp(seen), seen[-1] - rng.uniform(0, 0.1) * np.ptp(seen)
    outward, stretch = rng.uniform(0.0, 0.25), rng.uniform(0.85, 1.2)
    # A mark back from the edge is seen further along than the edge beside it: the last one still beside the face.
    for _ in range(3):
        trial = _placed(camera, face, rest, 1, last, 1.5, gap_px + radius_px, contrast, outward, stretch)
        if trial is None:
            return None
        over = trial.pixel(camera, face)[0] + 2 * radius_px + 3 - middle[-1]
        if over <= 0:
            break
        last = float(np.interp(np.interp(last, s, middle) - over, middle, s))
    if last - first < 0.4 * rest.length_mm:
        return None
    dots: list[Dot] = []
    for side in (-1, 1):
        here = count
        if kind == "broken-dots" and side > 0:
            here = max(2, count - int(rng.integers(0, 3)))
        part = (np.arange(here) + 0.5) / here if here < 3 else np.linspace(0, 1, here)
        part = np.clip(part + rng.normal(0, 0.012 / here, here), 0, 1)
        even_mm = first + part * (last - first)
        even_px = np.interp(
            np.interp(first, s, middle) + part * (np.interp(last, s, middle) - np.interp(first, s, middle)), middle, s
        )
        places = (1 - share) * even_mm + share * even_px
        distance = face.point(places, np.zeros(here))[:, 2]
        grow = (distance[0] / distance) ** (1 - share)
        step_px = np.diff(np.interp(places, s, middle)).min() if here > 1 else 1e9
        radii = np.maximum(1.5, min(radius_px, (step_px - 2.5) / 2.3) * grow)
        if 2 * radii[-1] + 2 > step_px:
            return None
        gaps = np.maximum(1.5, gap_px * grow)
        for place, radius, gap in zip(places, radii, gaps):
            strength = contrast * rng.uniform(0.9, 1.1) * (1 if polarity == "bright" else -1)
            dot = _placed(camera, face, rest, side, place, radius, gap, strength, outward, stretch)
            if dot is None:
                return None
            dots.append(dot)
    if kind == "broken-dots":
        dots = _broken(rng, dots)
    per_row = max(count, 1)
    return tuple(dots), polarity, per_row


def _placed(
    camera: Camera,
    face: Face,
    rest: RestShape,
    side: int,
    s_mm: float,
    radius_px: float,
    gap_px: float,
    contrast: float,
    outward_rad: float,
    stretch: float,
) -> Dot | None:
    """The dot that has this radius and this gap to the face's edge, in the picture of the finger at rest."""
    trial = Dot(side, float(s_mm), 0.0, ((1.0, 0.0), (0.0, 1.0)), contrast, True, outward_rad)
    edge = trial.pixel(camera, face)
    back = np.linspace(0, 12, 241)
    row = np.array([camera.project(trial.place_mm(face, 0.0, b)) for b in back[::8]])
    off = np.abs(row[:, 1] - edge[1])
    wanted = gap_px + radius_px
    if off[-1] < wanted + radius_px or np.any(np.diff(off) <= 0):
        return None
    middle = float(np.interp(wanted, off, back[::8]))
    at = replace(trial, back_mm=middle)
    place, along, further = camera.project(at.place_mm(face, np.array([0.0, 0.02, 0.0]), np.array([0.0, 0.0, 0.02])))
    per_mm = np.stack([along - place, further - place], axis=1) / 0.02
    if abs(np.linalg.det(per_mm)) < 1.0:
        return None
    radii = np.linalg.inv(per_mm) * radius_px
    if not radius_px + 2 < place[1] < camera.height_px - radius_px - 3:
        return None
    first, second = radii[:, 0] * stretch, radii[:, 1]
    return replace(at, radii_mm=((float(first[0]), float(first[1])), (float(second[0]), float(second[1]))))


def _broken(rng: np.random.Generator, dots: list[Dot]) -> list[Dot]:
    missing = set(rng.choice(len(dots), min(int(rng.integers(1, 3)), len(dots) - 4), replace=False).tolist())
    kept = [dot for i, dot in enumerate(dots) if i not in missing]
    for _ in range(int(rng.integers(1, 4))):
        model = kept[int(rng.integers(len(kept)))]
        kept.append(
            replace(
                model,
                s_mm=model.s_mm + rng.uniform(-4, 4),
                back_mm=max(0.3, model.back_mm + rng.uniform(0.8, 2.5)),
                radii_mm=_scaled(model.radii_mm, rng.uniform(0.4, 0.9), rng.uniform(0.4, 0.9)),
                contrast=model.contrast * rng.uniform(0.4, 1.0),
                engraved=False,
            )
        )
    return kept


def _scaled(
    radii: tuple[tuple[float, float], tuple[float, float]], first: float, second: float
) -> tuple[tuple[float, float], tuple[float, float]]:
    return (radii[0][0] * first, radii[0][1] * first), (radii[1][0] * second, radii[1][1] * second)
