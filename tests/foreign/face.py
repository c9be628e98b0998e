"""The view face as a ruled surface that bends, sways and twists.

A centre curve leaves the clamped base with a curvature that is rest shape plus load; across it lie straight lines of
the face's width. Everything is tabulated along the arc length s; w runs across, from -width/2 to width/2. Beyond both
ends the curve goes on straight, so that what lies beside the face has coordinates too.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

STEP_MM = 0.04


@dataclass(frozen=True)
class Pose:
    """What the loads do to the tip, beyond the shape at rest."""

    bend_mm: float = 0.0
    s_bend_mm: float = 0.0
    sway_mm: float = 0.0
    twist_deg: float = 0.0


@dataclass(frozen=True)
class RestShape:
    """A clothoid with a wave on it, from a clamped base: what one finger is."""

    base_mm: tuple[float, float]  # x, z
    length_mm: float
    base_incline_rad: float
    curvature_per_mm: float
    curvature_slope_per_mm2: float
    wave_per_mm: float
    wave_phase: float
    load_exponent: float
    twist_exponent: float
    turning_share: float  # of a sway that turns the cross-sections; the rest shears them
    width_mm: float
    layer_mm: float


class Face:
    """One finger in one pose."""

    def __init__(self, rest: RestShape, pose: Pose):
        self.rest = rest
        length = rest.length_mm
        behind = min(18.0, 0.45 * rest.base_mm[1] / max(0.2, np.sin(rest.base_incline_rad)))
        self.first_mm = -behind
        count = int((length + behind + 25.0) / STEP_MM) + 1
        s = self.first_mm + STEP_MM * np.arange(count)
        part = np.clip(s / length, 0.0, 1.0)
        on_face = (s >= 0) & (s <= length)
        load = (1 - part) ** rest.load_exponent
        # Tip travel of a cantilever whose curvature is the load: integral of load times the way that is left.
        travel = length**2 / (rest.load_exponent + 2)
        wave = np.cos(1.5 * np.pi * part)
        curvature = (
            rest.curvature_per_mm
            + rest.curvature_slope_per_mm2 * (s - length / 2)
            + rest.wave_per_mm * np.sin(2 * np.pi * part + rest.wave_phase)
            + pose.bend_mm / travel * load
            + pose.s_bend_mm / (0.18 * length**2) * wave
        ) * on_face
        incline = rest.base_incline_rad + _integral(curvature)
        incline += rest.base_incline_rad - np.interp(0.0, s, incline)
        x, z = _integral(np.cos(incline)), _integral(np.sin(incline))
        x += rest.base_mm[0] - np.interp(0.0, s, x)
        z += rest.base_mm[1] - np.interp(0.0, s, z)
        beyond = np.maximum(s - length, 0.0) / length
        y = pose.sway_mm * (part**2 * (3 - part) / 2 + 1.5 * beyond)
        self.centre = np.stack([x, y, z], axis=1)
        tangent = _unit(np.gradient(self.centre, STEP_MM, axis=0))
        across = np.array([0.0, 1.0, 0.0])
        turned = _unit(across - tangent * tangent[:, 1:2])
        across = _unit(rest.turning_share * turned + (1 - rest.turning_share) * across)
        normal = _unit(np.cross(tangent, across))
        angle = np.radians(pose.twist_deg) * part[:, None] ** rest.twist_exponent
        self.across = across * np.cos(angle) + normal * np.sin(angle)
        self.normal = normal * np.cos(angle) - across * np.sin(angle)
        self.tangent = tangent

    def _lookup(self, table: np.ndarray, s: np.ndarray) -> np.ndarray:
        place = (np.asarray(s, float) - self.first_mm) / STEP_MM
        place = np.minimum(np.maximum(place, 0.0), len(table) - 1.001)
        low = place.astype(np.int64)
        share = (place - low)[..., None]
        below = table.take(low, axis=0)
        return below + share * (table.take(low + 1, axis=0) - below)

    def point(self, s: np.ndarray, w: np.ndarray, outward_mm: float = 0.0) -> np.ndarray:
        """Of the view face, or so far outward along the normal: layer_mm gives the untouched outer side."""
        place = self._lookup(self.centre, s) + np.asarray(w, float)[..., None] * self._lookup(self.across, s)
        return place + outward_mm * self._lookup(self.normal, s) if outward_mm else place

    def normal_at(self, s: np.ndarray) -> np.ndarray:
        return self._lookup(self.normal, s)

    def across_at(self, s: np.ndarray) -> np.ndarray:
        return self._lookup(self.across, s)

    def tangent_at(self, s: np.ndarray) -> np.ndarray:
        return self._lookup(self.tangent, s)

    def meet(
        self, origins: np.ndarray, directions: np.ndarray, outward_mm: float = 0.0
    ) -> tuple[np.ndarray, np.ndarray]:
        """(s, w) where a grid of lines (rows, columns, 3) meet the face or, outward_mm further out, its outer side: Newton's method on the one
        condition that the line and the straight line at s lie in one plane."""
        curve = self.centre + outward_mm * self.normal
        slope, turn = np.gradient(curve, STEP_MM, axis=0), np.gradient(self.across, STEP_MM, axis=0)
        tables = np.concatenate([curve, self.across, slope, turn], axis=1)
        last = self.first_mm + STEP_MM * (len(curve) - 1)
        s = self._begin(curve, origins, directions)
        for _ in range(6):
            found = self._lookup(tables, s)
            at, across, slope_here, turn_here = (found[..., i : i + 3] for i in (0, 3, 6, 9))
            way = at - origins
            plane = _cross(directions, across)
            value = _dot(way, plane)
            rate = _dot(slope_here, plane) + _dot(way, _cross(directions, turn_here))
            rate = np.where(np.abs(rate) < 1e-6, 1e-6, rate)
            step = np.minimum(np.maximum(value / rate, -8.0), 8.0)
            s = np.minimum(np.maximum(s - step, self.first_mm), last)
        found = self._lookup(tables[:, :6], s)
        way, plane = origins - found[..., :3], _cross(found[..., 3:], directions)
        return s, _dot(_cross(way, directions), plane) / _dot(plane, plane)

    def _begin(self, curve: np.ndarray, origins: np.ndarray, directions: np.ndarray) -> np.ndarray:
        """Where the centre curve has the line's x, as seen along it in the plane y = 0; lines of one column of a grid
        begin together."""
        coarse = curve[::25]
        origin, direction = origins[len(origins) // 2, :, 0], directions[len(directions) // 2, :, 0]
        off = coarse[:, 0][None, :] - origin[:, None] - direction[:, None] * coarse[:, 2][None, :]
        begin = self.first_mm + 25 * STEP_MM * np.argmin(np.abs(off), axis=1)
        return np.broadcast_to(begin.astype(float), origins.shape[:-1])


def _cross(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    out = np.empty(np.broadcast_shapes(a.shape, b.shape))
    out[..., 0] = a[..., 1] * b[..., 2] - a[..., 2] * b[..., 1]
    out[..., 1] = a[..., 2] * b[..., 0] - a[..., 0] * b[..., 2]
    out[..., 2] = a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]
    return out


def _dot(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    return a[..., 0] * b[..., 0] + a[..., 1] * b[..., 1] + a[..., 2] * b[..., 2]


def _integral(values: np.ndarray) -> np.ndarray:
    return np.concatenate([[0.0], np.cumsum(0.5 * (values[1:] + values[:-1])) * STEP_MM])


def _unit(vectors: np.ndarray) -> np.ndarray:
    return vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)
