"""The same finger with its base at the picture's other side: pictures, camera and truth turned left to right."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from camera import Camera
from render import Truth


def mirrored_camera(camera: Camera) -> Camera:
    distortion = camera.distortion
    if camera.model == "brown":
        k1, k2, p1, p2, k3 = distortion
        distortion = (k1, k2, p1, -p2, k3)  # p2's part of x is even in x
    centre = (camera.width_px - 1 - camera.centre_px[0], camera.centre_px[1])
    return replace(camera, centre_px=centre, distortion=distortion)


def mirrored_truth(truth: Truth) -> Truth:
    last = truth.depth_mm.shape[1] - 1
    markers = truth.markers_px * [-1.0, 1.0] + [float(last), 0.0] if len(truth.markers_px) else truth.markers_px
    regions = []
    for region in truth.regions:
        x, y, z = np.array(region["place_mm"])
        regions.append({**region, "place_mm": [-x, y, z]})
    return replace(
        truth,
        depth_mm=truth.depth_mm[:, ::-1],
        border_mm=truth.border_mm[:, ::-1],
        knots_u=last - truth.knots_u[::-1],
        knot_z_mm=truth.knot_z_mm[:, ::-1],
        knot_normal_z=truth.knot_normal_z[:, ::-1],
        markers_px=markers,
        regions=regions,
    )
