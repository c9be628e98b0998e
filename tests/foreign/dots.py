"""Marks engraved along both side faces, and what looks like them.

A side face begins at the view face's long edge and goes back towards the camera, a little outward. Each row has its own
law of step, size and distance from the edge: equal in millimetres, equal in the picture, or between.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from camera import Camera
from face import Face


@dataclass(frozen=True)
class Dot:
    """On one side face: along it, back from its edge.

    contrast: grey levels of a bright one; of a dark one the part of its surroundings' light that it takes, negative.

    radii_mm: an ellipse's two half axes, each (along, back): those that make it round in the picture of the finger at
    rest, more or less.
    """

    side: int  # -1: upper in the picture, +1: lower
    s_mm: float
    back_mm: float
    radii_mm: tuple[tuple[float, float], tuple[float, float]]
    contrast: float
    engraved: bool  # False: a bubble or a speck that only looks like one
    outward_rad: float  # of the side face

    def place_mm(self, face: Face, ds_mm: np.ndarray | float = 0.0, dback_mm: np.ndarray | float = 0.0) -> np.ndarray:
        """Of its middle, or of what lies so far along and back from it."""
        s = self.s_mm + np.asarray(ds_mm, float)
        edge = face.point(s, np.full(s.shape, self.side * face.rest.width_mm / 2))
        back = (
            -np.cos(self.outward_rad) * face.normal_at(s) + self.side * np.sin(self.outward_rad) * face.across_at(s)
        )
        return edge + (self.back_mm + np.asarray(dback_mm, float))[..., None] * back

    def pixel(self, camera: Camera, face: Face) -> np.ndarray:
        return camera.project(self.place_mm(face))


def draw_dot(picture: np.ndarray, camera: Camera, face: Face, dot: Dot, soft_px: float = 0.7) -> None:
    """Puts the dot into the picture, its rim soft_px wide; defocus comes later."""
    (first_s, first_back), (second_s, second_back) = dot.radii_mm
    ends = dot.place_mm(face, np.array([0.0, first_s, second_s]), np.array([0.0, first_back, second_back]))
    middle, first, second = camera.project(ends)
    axes = np.stack([first - middle, second - middle], axis=1)
    reach = np.abs(axes).sum(axis=1) + 3
    height, width = picture.shape
    u0, u1 = max(0, int(middle[0] - reach[0])), min(width, int(middle[0] + reach[0]) + 2)
    v0, v1 = max(0, int(middle[1] - reach[1])), min(height, int(middle[1] + reach[1]) + 2)
    if u0 >= u1 or v0 >= v1:
        return
    offset = np.stack(np.meshgrid(np.arange(u0, u1), np.arange(v0, v1)), axis=-1) - middle
    inverse = np.linalg.inv(axes)
    unit = offset @ inverse.T
    off = np.hypot(unit[..., 0], unit[..., 1])
    # Distance to the rim in px, to first order: (off - 1) over its gradient.
    slope = np.hypot(*np.moveaxis((unit / np.maximum(off, 1e-6)[..., None]) @ inverse, -1, 0))
    inside = np.clip(0.5 - (off - 1) / np.maximum(slope, 1e-6) / (2 * soft_px), 0, 1)
    window = picture[v0:v1, u0:u1]
    part = inside.astype(picture.dtype)
    window += dot.contrast * part * (1 if dot.contrast > 0 else window)
