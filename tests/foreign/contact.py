"""What presses on the face, and what the skin does: it follows the rigid body where it must, leaves it before the rim,
and bulges a little around.

The skin over its layer is a membrane on an elastic bed: outside of the contact its depth d dies away as
lambda^2 * laplacian(d) = d, and nowhere may it lie inside of the body. The least-energy d of that obstacle problem is
found by over-relaxation on a grid that is even on the face, not in the picture.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from face import Face

GRID_MM = 0.1
FAR_MM = 50.0


@dataclass(frozen=True)
class Skin:
    lift_off_mm: float  # lambda: how far from the body's rim the skin comes back
    bulge: float  # of the depth around, given to the ring
    bulge_mm: float  # how wide the ring is


@dataclass(frozen=True)
class Body:
    """A rigid body whose lowest point would rest on the face at (s, w), pushed in by depth_mm along z.

    shape: ball | cylinder | plate | ring | tee | two_balls | step | punch | pin | thread. size_mm: of a ball the radius, else see `relief`.
    """

    shape: str
    s_mm: float
    w_mm: float
    depth_mm: float
    size_mm: tuple[float, ...]
    turn_rad: float = 0.0

    def reach_mm(self) -> float:
        """No part that presses is further than this from its middle."""
        if self.shape == "ball":
            return float(np.sqrt(2 * self.size_mm[0] * self.depth_mm)) + 1.0
        if self.shape in ("plate", "step"):
            return float(np.hypot(self.size_mm[0], self.size_mm[1])) / 2 + 2.0
        if self.shape == "two_balls":
            return float(self.size_mm[1] / 2 + np.sqrt(2 * self.size_mm[0] * self.depth_mm)) + 1.0
        if self.shape in ("punch", "pin"):
            return self.size_mm[0] + 1.0
        if self.shape == "thread":
            return float(np.hypot(self.size_mm[1], np.sqrt(2 * self.size_mm[0] * self.depth_mm))) + 1.0
        return float(self.size_mm[1] + self.size_mm[0])

    def relief(self, along: np.ndarray, across: np.ndarray) -> np.ndarray:
        """How far the body's surface lies outward of the plane it rests on, mm."""
        cosine, sine = np.cos(self.turn_rad), np.sin(self.turn_rad)
        a, b = cosine * along + sine * across, cosine * across - sine * along
        radius = self.size_mm[0]
        if self.shape == "cylinder":  # radius, half of the straight part
            return _rounded(np.hypot(np.maximum(np.abs(a) - self.size_mm[1], 0), b), radius)
        if self.shape == "ring":  # of the wire, of the ring
            return _rounded(np.abs(np.hypot(a, b) - self.size_mm[1]), radius)
        if self.shape == "tee":  # of the bars, their length
            length = self.size_mm[1]
            bar = np.hypot(np.maximum(np.abs(a) - length / 2, 0), b - length / 2)
            stem = np.hypot(a, np.maximum(np.abs(b) - length / 2, 0))
            return _rounded(np.minimum(bar, stem), radius)
        if self.shape == "two_balls":  # radius, distance of the middles
            half = self.size_mm[1] / 2
            return _rounded(np.hypot(np.abs(a) - half, b), radius)
        if self.shape in ("punch", "pin"):  # radius, radius of the edge
            return _rounded(np.maximum(np.hypot(a, b) - radius + self.size_mm[1], 0), self.size_mm[1])
        if self.shape == "thread":  # outer radius, half of the length, pitch
            local = radius - _groove(a, self.size_mm[2])
            inside = (np.abs(b) < local) & (np.abs(a) < self.size_mm[1])
            return np.where(inside, radius - np.sqrt(np.maximum(local**2 - b**2, 0)), FAR_MM)
        if self.shape in ("plate", "step"):  # length, width, radius of the edge
            edge = self.size_mm[2]
            outside = np.hypot(
                np.maximum(np.abs(a) - self.size_mm[0] / 2 + edge, 0),
                np.maximum(np.abs(b) - self.size_mm[1] / 2 + edge, 0),
            )
            return _rounded(outside, edge)
        raise ValueError(self.shape)


def _rounded(off_mm: np.ndarray, radius_mm: float) -> np.ndarray:
    inside = off_mm < radius_mm
    return np.where(inside, radius_mm - np.sqrt(np.maximum(radius_mm**2 - off_mm**2, 0)), FAR_MM)


def _groove(along_mm: np.ndarray, pitch_mm: float) -> np.ndarray:
    """Depth of an ISO metric thread along its bolt: flanks of 60 degrees, crests an eighth of the pitch wide, 0.6134
    pitches deep."""
    from_crest = np.abs(along_mm - pitch_mm * np.rint(along_mm / pitch_mm))
    return np.clip((from_crest - pitch_mm / 16) * np.sqrt(3.0), 0, 0.6134 * pitch_mm)


class OuterSide:
    """The untouched outer side of the layer as z over (x, y), on a grid around a place, and beyond the face's ends."""

    def __init__(self, face: Face, s_mm: float, w_mm: float, reach_mm: float):
        layer = face.rest.layer_mm
        middle = face.point(np.array(s_mm), np.array(w_mm), layer)
        normal = face.normal_at(np.array(s_mm))
        half = min(int(np.ceil((reach_mm + 5.5) / GRID_MM)), 300)
        self.grid_mm = max(GRID_MM, (reach_mm + 5.5) / half)
        # Even on the face: a step along x is shorter by the incline.
        self.dx, self.dy = self.grid_mm * max(0.2, float(normal[2])), self.grid_mm
        self.x = middle[0] + self.dx * np.arange(-half, half + 1)
        self.y = middle[1] + self.dy * np.arange(-half, half + 1)
        every = 8
        knots = np.unique(np.append(np.arange(0, 2 * half + 1, every), 2 * half))
        x, y = np.meshgrid(self.x[knots], self.y[knots])
        origins = np.stack([x, y, np.zeros_like(x)], axis=-1)
        s, w = face.meet(origins, np.broadcast_to([0.0, 0.0, 1.0], origins.shape), layer)
        along_x, along_y = cubic_weights(2 * half + 1, knots), cubic_weights(2 * half + 1, knots)
        self.z = along_y @ face.point(s, w, layer)[..., 2] @ along_x.T
        self.middle, self.normal = middle, normal

    def lookup(self, table: np.ndarray, x: np.ndarray, y: np.ndarray) -> np.ndarray:
        fx = np.clip((x - self.x[0]) / self.dx, 0, len(self.x) - 1.001)
        fy = np.clip((y - self.y[0]) / self.dy, 0, len(self.y) - 1.001)
        ix, iy = fx.astype(np.int64), fy.astype(np.int64)
        fx, fy = fx - ix, fy - iy
        return (table[iy, ix] * (1 - fx) + table[iy, ix + 1] * fx) * (1 - fy) + (
            table[iy + 1, ix] * (1 - fx) + table[iy + 1, ix + 1] * fx
        ) * fy


class Dent:
    """The skin's depth along z over (x, y), and so how thick the layer is under each point of the view face."""

    def __init__(self, face: Face, skin: Skin, body: Body):
        self.face, self.body = face, body
        side = OuterSide(face, body.s_mm, body.w_mm, body.reach_mm())
        self.side = side
        x, y = np.meshgrid(side.x, side.y)
        if body.shape == "ball":
            radius = body.size_mm[0]
            self.ball_mm = side.middle + radius * side.normal - np.array([0, 0, body.depth_mm])
            under = radius**2 - (x - self.ball_mm[0]) ** 2 - (y - self.ball_mm[1]) ** 2
            front = np.where(under > 0, self.ball_mm[2] - np.sqrt(np.maximum(under, 0)), FAR_MM * 10)
        else:
            n = side.normal
            plane = side.middle[2] - (n[0] * (x - side.middle[0]) + n[1] * (y - side.middle[1])) / n[2]
            point = np.stack([x, y, plane], axis=-1) - side.middle
            along = face.tangent_at(np.array(body.s_mm))
            across = np.cross(n, along)
            front = plane + body.relief(point @ along, point @ across) / n[2] - body.depth_mm
            # No body presses deeper than it was pushed, also where the face bends up to it.
            front = np.maximum(front, side.z - body.depth_mm)
        inside = side.z - front
        depth = _membrane(np.maximum(inside, -1.0), skin.lift_off_mm / side.grid_mm)
        self.depth = _bulged(depth, inside, skin, side.grid_mm)

    def reaches(self, x: np.ndarray, y: np.ndarray) -> np.ndarray:
        """True where the skin may be moved; a layer's width inside of the grid, so that normals stay on it."""
        side, away = self.side, 2.5
        return (np.abs(x - side.middle[0]) < side.x[-1] - side.middle[0] - away * side.dx / side.dy) & (
            np.abs(y - side.middle[1]) < side.y[-1] - side.middle[1] - away
        )

    def depth_at(self, x: np.ndarray, y: np.ndarray) -> np.ndarray:
        return self.side.lookup(self.depth, x, y)

    def thickness_at(self, s: np.ndarray, w: np.ndarray) -> np.ndarray:
        """Of the layer along the normal of the view face at (s, w)."""
        point, normal = self.face.point(s, w), self.face.normal_at(s)
        surface = self.side.z - self.depth
        thick = np.full(np.shape(s), self.face.rest.layer_mm)
        for _ in range(12):
            x, y = point[..., 0] + thick * normal[..., 0], point[..., 1] + thick * normal[..., 1]
            missing = self.side.lookup(surface, x, y) - point[..., 2] - thick * normal[..., 2]
            thick = thick + missing * normal[..., 2] * 0.9
        return np.maximum(thick, 0.02)


def _membrane(inside: np.ndarray, lift_off_cells: float, rounds: int = 90) -> np.ndarray:
    stiff = lift_off_cells**2
    depth = np.maximum(inside, 0.0)
    rows, columns = np.indices(inside.shape)
    inner = np.zeros(inside.shape, bool)
    inner[1:-1, 1:-1] = True
    colours = [inner & ((rows + columns) % 2 == c) for c in (0, 1)]
    flat = depth.ravel()
    floor = inside.ravel()
    width = inside.shape[1]
    # Only near the body does anything move.
    from_body = _grown(inside > 0, int(np.ceil(8 * lift_off_cells)) + 2)
    places = [np.flatnonzero(colour & from_body) for colour in colours]
    relax = 1.55
    for _ in range(rounds):
        for here in places:
            around = flat[here - 1] + flat[here + 1] + flat[here - width] + flat[here + width]
            new = stiff * around / (1 + 4 * stiff)
            flat[here] = np.maximum(flat[here] + relax * (new - flat[here]), floor[here])
    return flat.reshape(inside.shape)


def _grown(mask: np.ndarray, steps: int) -> np.ndarray:
    """Everything within so many cells of the mask's rows and columns: a rectangle suffices."""
    rows, columns = np.flatnonzero(mask.any(axis=1)), np.flatnonzero(mask.any(axis=0))
    grown = np.zeros_like(mask)
    if len(rows):
        grown[max(rows[0] - steps, 0) : rows[-1] + steps + 1, max(columns[0] - steps, 0) : columns[-1] + steps + 1] = True
    return grown


def _bulged(depth: np.ndarray, inside: np.ndarray, skin: Skin, grid_mm: float) -> np.ndarray:
    touching = (depth <= inside + 1e-6) & (inside > 0)
    near = blurred(touching.astype(float), 0.35 / grid_mm, 0.35 / grid_mm)
    ring = blurred(depth, skin.bulge_mm / grid_mm, skin.bulge_mm / grid_mm)
    return depth - skin.bulge * ring * (1 - np.minimum(1.0, 2 * near)) ** 2


def blurred(values: np.ndarray, rows_sd: float, columns_sd: float) -> np.ndarray:
    """Gaussian, borders repeated."""
    return _blurred_rows(_blurred_rows(values, rows_sd).T, columns_sd).T


def _blurred_rows(values: np.ndarray, sd: float) -> np.ndarray:
    reach = int(np.ceil(3.5 * sd)) + 1
    weights = np.exp(-0.5 * (np.arange(-reach, reach + 1) / max(sd, 1e-3)) ** 2)
    weights = (weights / weights.sum()).astype(values.dtype)
    wide = np.pad(values, ((reach, reach), (0, 0)), mode="edge")
    total = weights[reach] * values
    for step in range(1, reach + 1):
        above, below = wide[reach - step : reach - step + len(values)], wide[reach + step : reach + step + len(values)]
        total += weights[reach + step] * (above + below)
    return total


def cubic_weights(count: int, knots: np.ndarray) -> np.ndarray:
    """(count, len(knots)): from values at some places of 0..count-1 to all of them, by cubics through four each."""
    weights = np.zeros((count, len(knots)))
    place = np.arange(count, dtype=float)
    first = np.clip(np.searchsorted(knots, place, side="right") - 2, 0, len(knots) - 4)
    for i in range(4):
        weight = np.ones(count)
        for j in range(4):
            if i != j:
                weight *= (place - knots[first + j]) / (knots[first + i] - knots[first + j])
        weights[np.arange(count), first + i] = weight
    return weights
