"""Light: a few small lamps near the base, each falling off with the square of its distance."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from face import Face


@dataclass(frozen=True)
class Lamps:
    places_mm: np.ndarray  # (n, 3)
    strengths: np.ndarray  # (n,)
    scale: float  # grey levels per unit of irradiance

    def irradiance(self, face: Face, s: np.ndarray, w: np.ndarray, gains: np.ndarray | None = None) -> np.ndarray:
        """Grey levels of the untouched view face at (s, w). gains: of each lamp, now."""
        point, normal = face.point(s, w), face.normal_at(s)
        strengths = self.strengths if gains is None else self.strengths * gains
        total = np.zeros(point.shape[:-1])
        for place, strength in zip(self.places_mm, strengths):
            way = point - place
            squared = np.sum(way * way, axis=-1)
            total += strength * np.maximum(np.sum(way * normal, axis=-1), 0.0) / squared**1.5
        return total * self.scale
