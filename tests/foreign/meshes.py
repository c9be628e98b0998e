"""Bodies as meshes, in mm, as a CAD program would export them."""

from __future__ import annotations

from pathlib import Path

import numpy as np

AROUND, RINGS = 96, 48


def capsule(radius_mm: float, half_mm: float) -> np.ndarray:
    """Triangles (n, 3, 3) of a cylinder along x with half balls on its ends; half_mm: half of the straight part."""
    polar = np.linspace(0, np.pi, RINGS + 1)
    turn = np.linspace(0, 2 * np.pi, AROUND + 1)
    off = radius_mm * np.sin(polar)
    off[[0, -1]] = 0  # to the bit, like the seam: corners that are nearly the same would be holes
    cosine, sine = np.cos(turn), np.sin(turn)
    cosine[-1], sine[-1] = cosine[0], sine[0]
    x = radius_mm * np.cos(polar) + half_mm * np.sign(np.round(np.cos(polar), 12))
    points = np.stack(
        [np.broadcast_to(x[:, None], (RINGS + 1, AROUND + 1)), off[:, None] * cosine[None, :], off[:, None] * sine[None, :]],
        axis=-1,
    )
    a, b = points[:-1, :-1].reshape(-1, 3), points[1:, :-1].reshape(-1, 3)
    c, d = points[1:, 1:].reshape(-1, 3), points[:-1, 1:].reshape(-1, 3)
    triangles = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    area = np.linalg.norm(np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]), axis=1)
    return triangles[area > 1e-12]


def write_stl(file: Path, triangles: np.ndarray) -> None:
    """Binary STL."""
    rows = np.zeros(len(triangles), dtype=[("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("spare", "<u2")])
    rows["corners"] = triangles
    file.write_bytes(b" " * 80 + np.uint32(len(rows)).tobytes() + rows.tobytes())
