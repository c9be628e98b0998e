"""Fingers drawn at random: each belongs to one class of difficulty, all the rest of it is mildly different as well."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from camera import Camera, Port
from contact import Skin
from dot_rows import draw_rows
from dots import Dot
from face import Face, Pose, RestShape
from lamps import Lamps
from layer import Layer, walk
from pencils import ScatteringLayer
from sensor import Sensor

CLASSES = (
    "clean",
    "near-dots",
    "paper-dots",
    "broken-dots",
    "few-dots",
    "many-dots",
    "no-dots",
    "small-picture",
    "twist",
    "sway",
    "rim",
    "wide",
    "drift",
    "jpeg",
    "blemished",
    "absorbing",
    "steep",
    "port",
    "twisted-start",
    "short-recording",
    "degraded",
    "scattering",
)


@dataclass(frozen=True)
class Blemish:
    """Fixed to the skin: part of the light it takes (or gives), as an ellipse with soft rim."""

    s_mm: float
    w_mm: float
    half_length_mm: float
    half_width_mm: float
    turn_rad: float
    strength: float


@dataclass(frozen=True)
class Backdrop:
    """What is seen beside the face, as shares of the light on the face's edge, and grey levels."""

    side_share: float
    side_fade_mm: float
    wave: float
    base_grey: float
    tip_grey: float
    floor_grey: float


@dataclass(frozen=True)
class Motion:
    """How far the modes go: mm and degrees of the tip, and where the recording begins."""

    bend_mm: tuple[float, float]
    s_bend_mm: float
    sway_mm: float
    twist_deg: float
    start_twist_deg: float = 0.0

    def pose(self, part: np.ndarray) -> Pose:
        """part: four numbers in -1..1."""
        bend = part[0] * (self.bend_mm[1] if part[0] > 0 else self.bend_mm[0])
        return Pose(bend, part[1] * self.s_bend_mm, part[2] * self.sway_mm, part[3] * self.twist_deg)


@dataclass(frozen=True)
class Finger:
    kind: str
    seed: int
    index: int
    camera: Camera
    told_camera: Camera  # what the user believes
    rest: RestShape
    layer: Layer
    layer_facts: dict[str, float]
    spread_mm: float
    scattering: ScatteringLayer | None  # None: light stays where it is, but for spread_mm
    lamps: Lamps
    backdrop: Backdrop
    vignetting: float
    dots: tuple[Dot, ...]
    per_row: int  # as designed and told
    polarity: str
    skin: Skin
    motion: Motion
    sensor: Sensor
    blemishes: tuple[Blemish, ...]
    frames: int
    lamp_drift: float  # sd of each lamp's gain, slowly over the recording
    ball_radius_mm: float
    mirrored: bool  # the base lies at the picture's right: see mirror.py


SIZES = ((480, 300), (640, 400), (640, 480), (800, 500), (800, 600), (960, 540), (1280, 720), (1920, 1080))
SIZE_WEIGHTS = (0.16, 0.16, 0.22, 0.14, 0.12, 0.12, 0.06, 0.02)


def draw_finger(seed: int, index: int, kind: str, photons: int = 120_000) -> Finger:
    """The same finger for the same numbers, always. photons: fewer for a rougher law of its layer."""
    rng = np.random.default_rng([seed, index, CLASSES.index(kind)])
    for _ in range(400):
        size = _size(rng, kind)
        camera = _camera(rng, kind, size)
        motion = _motion(rng, kind)
        rest = _rest(rng, camera)
        if camera.folds() or rest is None or not _is_seen(camera, rest, motion):
            continue
        dots = draw_rows(rng, kind, camera, rest)
        if dots is None:
            continue
        row, polarity, per_row = dots
        return _complete(rng, seed, index, kind, camera, rest, motion, row, polarity, per_row, photons)
    raise RuntimeError(f"no finger of class {kind} fits into the picture (seed {seed}, finger {index})")


def _size(rng: np.random.Generator, kind: str) -> tuple[int, int]:
    if kind == "small-picture":
        return (480, 300)
    return SIZES[rng.choice(len(SIZES), p=np.array(SIZE_WEIGHTS) / sum(SIZE_WEIGHTS))]


def _camera(rng: np.random.Generator, kind: str, size: tuple[int, int]) -> Camera:
    width, height = size
    model = str(rng.choice(["pinhole", "brown", "fisheye"], p=[0.4, 0.35, 0.25]))
    focal = width / 2 / np.tan(np.radians(rng.uniform(58, 92)) / 2)
    port = None
    if kind == "port":
        model = "pinhole"
        port = Port(rng.uniform(1, 6), rng.uniform(1, 3.5), rng.uniform(1.47, 1.55), rng.uniform(1.39, 1.43))
        focal *= 0.78
    distortion: tuple[float, ...] = ()
    if model == "brown":
        distortion = (rng.uniform(-0.16, -0.02), rng.uniform(0, 0.03), *rng.normal(0, 4e-4, 2), 0.0)
    if model == "fisheye":
        distortion = (*rng.normal(0, [0.02, 0.008, 0.003]), 0.0)
        focal *= 1.1
    aspect = rng.normal(1, 8e-4)
    centre = (width / 2 - 0.5 + rng.normal(0, 0.012) * width, height / 2 - 0.5 + rng.normal(0, 0.012) * height)
    return Camera(model, width, height, (focal, focal * aspect), centre, distortion, port)


def _motion(rng: np.random.Generator, kind: str) -> Motion:
    sway = rng.uniform(2.0, 4.0) if kind == "sway" else rng.uniform(0.1, 0.8)
    twist = rng.uniform(0, 1.0) if rng.random() < 0.85 else rng.uniform(1.5, 5)
    if kind in ("twist", "twisted-start"):
        twist = rng.uniform(6, 12)
    bend = (rng.uniform(2.5, 5.5), rng.uniform(4, 9))
    if rng.random() < 0.4:
        bend = bend[::-1]
    start = rng.choice([-1, 1]) * rng.uniform(0.7, 1.0) * twist if kind == "twisted-start" else 0.0
    return Motion(bend, rng.uniform(0.3, 2.0), sway, twist, float(start))


def _rest(rng: np.random.Generator, camera: Camera) -> RestShape | None:
    width, height = camera.width_px, camera.height_px
    near = rng.uniform(25, 42)
    far = min(near * rng.uniform(1.45, 2.9), 108)
    base_u = rng.choice([rng.uniform(-0.12, -0.03), rng.uniform(0.02, 0.09)]) * width
    tip_u = rng.choice([rng.uniform(0.8, 0.95), rng.uniform(1.02, 1.12)], p=[0.75, 0.25]) * width
    ends = np.array([[base_u, camera.centre_px[1]], [tip_u, camera.centre_px[1]]])
    inside = np.clip(ends, 0, [width - 1, height - 1])
    origins, lines = camera.sight_lines(inside)
    x = origins[:, 0] + np.array([near, far]) * lines[:, 0]
    x[0] += (ends[0, 0] - inside[0, 0]) / camera.f_px[0] * near
    x[1] += (ends[1, 0] - inside[1, 0]) / camera.f_px[0] * far
    chord = np.array([x[1] - x[0], far - near])
    # The curve for a chord of length one, turned and scaled to the chord.
    turn, change, wave = rng.uniform(-0.25, 0.75), rng.normal(0, 0.35), rng.uniform(0, 0.25)
    phase = rng.uniform(0, 2 * np.pi)
    part = np.linspace(0, 1, 2001)
    curvature = turn + change * (part - 0.5) + wave * np.sin(2 * np.pi * part + phase)
    angle = np.cumsum(curvature) / 2001
    end = np.array([np.cos(angle).mean(), np.sin(angle).mean()])
    length = np.linalg.norm(chord) / np.linalg.norm(end)
    incline = np.arctan2(chord[1], chord[0]) - np.arctan2(end[1], end[0])
    steepest = incline + angle.max()
    if not 0.05 < incline + angle.min() or steepest > np.radians(64) or not 35 < length < 130:
        return None
    apparent = near if camera.port is None else near * 0.78
    width_mm = min(rng.uniform(13, 29), rng.uniform(0.55, 0.74) * height * apparent / camera.f_px[1])
    if width_mm < 9:
        return None
    return RestShape(
        base_mm=(float(x[0]), near),
        length_mm=float(length),
        base_incline_rad=float(incline),
        curvature_per_mm=turn / length,
        curvature_slope_per_mm2=change / length**2,
        wave_per_mm=wave / length,
        wave_phase=phase,
        load_exponent=rng.uniform(0.6, 2.2),
        twist_exponent=rng.uniform(1.0, 1.8),
        turning_share=rng.uniform(0, 1),
        width_mm=float(width_mm),
        layer_mm=float(rng.uniform(1.05, 2.3)),
    )


def _is_seen(camera: Camera, rest: RestShape, motion: Motion) -> bool:
    """In every pose: nowhere along a line of sight, not too steep, with both edges in the picture near the base."""
    for bend in (-motion.bend_mm[0], 0.0, motion.bend_mm[1]):
        for s_bend in (-motion.s_bend_mm, motion.s_bend_mm):
            face = Face(rest, Pose(bend, s_bend, motion.sway_mm, motion.twist_deg))
            s = np.linspace(0, rest.length_mm, 60)
            point, normal = face.point(s, np.zeros(60)), face.normal_at(s)
            sight = np.sum(point * normal, axis=1) / np.linalg.norm(point, axis=1)
            if sight.min() < 0.28 or normal[:, 2].min() < np.cos(np.radians(68)) or point[:, 2].min() < 18:
                return False
            if point[:, 2].max() > 118:
                return False
            for side in (-1, 1):
                edge = camera.project(face.point(s, np.full(60, side * rest.width_mm / 2)))
                shown = (edge[:, 0] > 0) & (edge[:, 0] < camera.width_px)
                if np.any((edge[shown, 1] < 6) | (edge[shown, 1] > camera.height_px - 7)):
                    return False
    return True


def _lamps(rng: np.random.Generator, camera: Camera, rest: RestShape) -> Lamps:
    face = Face(rest, Pose())
    s = np.linspace(0, rest.length_mm, 40)
    middle = camera.project(face.point(s, np.zeros(40)))
    seen = s[(middle[:, 0] > 0) & (middle[:, 0] < camera.width_px)]
    # Now and then somebody sets the exposure a little too long.
    brightest = float(rng.uniform(175, 232)) if rng.random() < 0.95 else float(rng.uniform(245, 262))
    best: tuple[float, Lamps] | None = None
    for _ in range(60):
        count = int(rng.integers(2, 5))
        places = np.stack(
            [rng.uniform(-22, 14, count), rng.uniform(-11, 11, count), rng.uniform(-45, 6, count)], axis=1
        )
        lamps = Lamps(places, rng.uniform(0.5, 1.5, count), 1.0)
        s_grid, w_grid = np.meshgrid(seen, np.linspace(-0.5, 0.5, 7) * rest.width_mm)
        light = lamps.irradiance(face, s_grid, w_grid)
        fade = light[:, -1].mean() / light.max()
        scaled = replace(lamps, scale=brightest / float(light.max()))
        if best is None or fade > best[0]:
            best = (fade, scaled)
        if 0.22 < fade < 0.8:
            return scaled
    assert best is not None
    return best[1]


def _complete(
    rng: np.random.Generator,
    seed: int,
    index: int,
    kind: str,
    camera: Camera,
    rest: RestShape,
    motion: Motion,
    dots: tuple[Dot, ...],
    polarity: str,
    per_row: int,
    photons: int,
) -> Finger:
    scatter = float(np.exp(rng.uniform(np.log(0.5), np.log(2.0))))
    # Kubelka and Munk's K/S is 2 absorb / (0.75 scatter) for light that is diffuse.
    ratio = rng.uniform(0.08, 0.15) if kind == "absorbing" else rng.uniform(0, 0.04)
    absorb = 0.375 * ratio * scatter
    forwardness, incidence = rng.uniform(0, 0.7), rng.uniform(0.65, 1.0)
    layer = Layer(walk(rng, scatter, absorb, forwardness, incidence, photons), rest.layer_mm)
    # How far light comes out aside has a long tail of faint light; what blurs a picture is its core.
    spread = min(layer.aside_mm, rng.uniform(0.02, 0.15))
    noise = rng.uniform(1, 3) if kind in ("jpeg", "small-picture") else rng.uniform(1, 2.2)
    shot_share = rng.uniform(0.1, 0.7)
    pattern_sd = rng.uniform(0.001, 0.006)
    pattern = 1 + pattern_sd * rng.standard_normal((camera.height_px, camera.width_px))
    defocus = rng.uniform(1.1, 1.8) if kind == "jpeg" else rng.uniform(0.4, 1.0)
    quality = int(rng.integers(85, 96)) if rng.random() < 0.08 else None
    if kind == "jpeg":
        quality = int(rng.integers(75, 96))
    sensor = Sensor(
        defocus,
        float(noise * np.sqrt(1 - shot_share)),
        float(noise**2 * shot_share / 140),
        pattern.astype(np.float32),
        quality,
    )
    is_dark = polarity == "dark"
    backdrop = Backdrop(
        rng.uniform(0.1, 0.25) if is_dark else rng.uniform(0.03, 0.3),
        rng.uniform(10, 40) if is_dark else rng.uniform(4, 20),
        rng.uniform(0, 0.12),
        rng.uniform(4, 40),
        rng.uniform(3, 20),
        rng.uniform(20, 32) if is_dark else rng.uniform(2, 10),
    )
    focal_sd, centre_sd_px = 3e-4, 0.15
    told = replace(
        camera,
        f_px=tuple(f * (1 + rng.normal(0, focal_sd)) for f in camera.f_px),
        centre_px=tuple(c + rng.normal(0, centre_sd_px) for c in camera.centre_px),
        sd_px=(*(focal_sd * f for f in camera.f_px), centre_sd_px, centre_sd_px),
    )
    frames = int(rng.integers(70, 150))
    if camera.width_px >= 1280:
        frames = 60
    if kind == "short-recording":
        frames = int(rng.integers(14, 30))
    finger = Finger(
        kind=kind,
        seed=seed,
        index=index,
        camera=camera,
        told_camera=told,
        rest=rest,
        layer=layer,
        layer_facts={"scatter_per_mm": scatter, "absorb_over_scatter": ratio, "aside_mm": layer.aside_mm},
        spread_mm=float(spread),
        scattering=None,
        lamps=_lamps(rng, camera, rest),
        backdrop=backdrop,
        vignetting=float(rng.uniform(0, 0.35)),
        dots=dots,
        per_row=per_row,
        polarity=polarity,
        skin=Skin(rng.uniform(0.08, 0.4), rng.uniform(0, 0.12), rng.uniform(1.0, 2.2)),
        motion=motion,
        sensor=sensor,
        blemishes=_blemishes(rng, kind, rest),
        frames=frames,
        lamp_drift=float(_drift(rng, kind)),
        ball_radius_mm=float(rng.uniform(2.2, 6.0)),
        mirrored=bool(rng.random() < 0.12),
    )
    if kind != "scattering":
        return finger
    own = np.random.default_rng([seed, index, 5])
    return replace(finger, spread_mm=0.0, scattering=_scattering(own, scatter, absorb, rest, finger.lamps))


def _scattering(
    rng: np.random.Generator, scatter: float, absorb: float, rest: RestShape, lamps: Lamps
) -> ScatteringLayer:
    """Sight from the camera and light from the lamps, at rest, at places along the face and across it."""
    along, across = np.linspace(0, rest.length_mm, 6), np.linspace(-0.5, 0.5, 3) * rest.width_mm
    s, w = (values.ravel() for values in np.meshgrid(along, across, indexing="ij"))
    face = Face(rest, Pose())
    point, normal = face.point(s, w), face.normal_at(s)
    frames = np.stack([face.tangent_at(s), face.across_at(s), normal], axis=1)
    light = np.zeros((len(s), 3))
    for place, strength in zip(lamps.places_mm, lamps.strengths):
        way = point - place
        length = np.linalg.norm(way, axis=1, keepdims=True)
        light += strength * np.maximum(np.sum(way * normal, axis=1, keepdims=True), 0) / length**4 * way
    sights, lights = (
        np.einsum("nij,nj->ni", frames, way / np.linalg.norm(way, axis=1, keepdims=True)) for way in (point, light)
    )
    lights[:, 2] = np.maximum(lights[:, 2], 0.1)
    sights, lights = (way.reshape(len(along), len(across), 3) for way in (sights, lights))
    return ScatteringLayer(rng, scatter, absorb, rest.layer_mm, along, across, sights, lights)


def _drift(rng: np.random.Generator, kind: str) -> float:
    if kind == "drift":
        return rng.uniform(0.02, 0.05)
    return rng.uniform(0.005, 0.015) if rng.random() < 0.1 else rng.uniform(0, 0.003)


def _blemishes(rng: np.random.Generator, kind: str, rest: RestShape) -> tuple[Blemish, ...]:
    count = int(rng.integers(1, 4)) if rng.random() < 0.1 else 0
    if kind == "blemished":
        count = int(rng.integers(7, 19))
    found = []
    for _ in range(count):
        scratch = rng.random() < 0.4
        found.append(
            Blemish(
                rng.uniform(2, rest.length_mm - 2),
                rng.uniform(-0.47, 0.47) * rest.width_mm,
                rng.uniform(0.8, 3.5) if scratch else rng.uniform(0.12, 0.5),
                rng.uniform(0.05, 0.12) if scratch else rng.uniform(0.1, 0.4),
                rng.uniform(0, np.pi),
                rng.uniform(-0.15, -0.04) if rng.random() < 0.75 else rng.uniform(0.03, 0.1),
            )
        )
    return tuple(found)
