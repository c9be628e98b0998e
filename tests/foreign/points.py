"""Two points of the skin, pushed in at a press's place and at more and more distance: from where on are they seen apart?

No body is there and no noise, so that what parts the points is lens, layer, and what the program does of its own.
"""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np

from face import Face

POINT_MM = 0.25  # sd of a point, a normal curve
DEPTH_MM = 0.3
DISTANCES_MM = (0.6, 0.75, 0.9, 1.05, 1.2, 1.4, 1.6, 1.9, 2.3, 2.8)
DIP = 0.8  # of the deeper one, between them: Rayleigh
NORMAL_PARTED = 2.6593  # standard deviations between two normal curves whose sum dips to 0.8 of its highest


@dataclass(frozen=True)
class Pair:
    """Two points around (s, w), along the face or across it."""

    s_mm: float
    w_mm: float
    distance_mm: float
    is_along: bool

    def places(self) -> np.ndarray:
        """(2, 2): s and w of both."""
        away = 0.5 * self.distance_mm * np.array([1.0, 0.0] if self.is_along else [0.0, 1.0])
        return np.array([self.s_mm, self.w_mm]) + np.array([-away, away])

    def reach_mm(self) -> float:
        return 0.5 * self.distance_mm + 5 * POINT_MM


class PairDent:
    """The same for the renderer as a body's dent."""

    def __init__(self, face: Face, pair: Pair):
        self.face, self._pair = face, pair

    def reaches(self, x: np.ndarray, y: np.ndarray) -> np.ndarray:
        return np.ones(np.shape(x), bool)

    def _depth(self, s: np.ndarray, w: np.ndarray) -> np.ndarray:
        off = [((s - a) ** 2 + (w - b) ** 2) / POINT_MM**2 for a, b in self._pair.places()]
        return DEPTH_MM * sum(np.exp(-0.5 * square) for square in off)

    def thickness_at(self, s: np.ndarray, w: np.ndarray) -> np.ndarray:
        return self.face.rest.layer_mm - self._depth(s, w)


def dip(depth: np.ndarray, first_px: np.ndarray, second_px: np.ndarray) -> float:
    """Depth between the points over the deepest of their line; NaN where nothing is seen."""
    middle, half = (first_px + second_px) / 2, (second_px - first_px) / 2
    along = np.linspace(-1.6, 1.6, 65)
    line = (middle + along[:, None] * half).astype(np.float32)
    values = cv2.remap(depth.astype(np.float32), line[:, 0], line[:, 1], cv2.INTER_CUBIC, borderValue=float("nan"))
    values = values.ravel()
    if not np.isfinite(values).all() or values.max() < 0.03 * DEPTH_MM:
        return float("nan")
    return float(values[32] / values.max())


def parted_from_mm(distances_mm: np.ndarray, dips: np.ndarray) -> float:
    """The least distance from which on all dips are below DIP, between the tried ones; less the points' own width."""
    merged = np.flatnonzero(~(dips <= DIP))
    if not len(merged):
        return float(distances_mm[0])
    last = merged[-1]
    if last + 1 >= len(dips) or not np.isfinite(dips[last]):
        return float("nan")
    share = (dips[last] - DIP) / (dips[last] - dips[last + 1])
    found = distances_mm[last] + share * (distances_mm[last + 1] - distances_mm[last])
    return float(np.sqrt(max(found**2 - (NORMAL_PARTED * POINT_MM) ** 2, 0)))
