"""The renderer itself, held against answers known from elsewhere."""

from __future__ import annotations

import tempfile
import unittest
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np

from camera import Camera, Port
from contact import GRID_MM, Body, Dent, Skin, blurred, cubic_weights
from dataset import make_finger
from face import Face, Pose, RestShape
from finger import CLASSES, draw_finger
from layer import Layer, walk
from meshes import capsule
from mirror import mirrored_camera
from pencils import CELL_MM, Pencil
from render import Renderer

REST = RestShape((-20.0, 30.0), 70.0, 0.5, 0.002, 1e-5, 0.001, 1.0, 1.0, 1.3, 0.5, 20.0, 1.5)
POSE = Pose(4.0, 1.0, 2.0, 8.0)
LENSES = (
    Camera("pinhole", 640, 480, (400.0, 401.0), (320.3, 239.1)),
    Camera("brown", 640, 480, (400.0, 401.0), (320.3, 239.1), (-0.12, 0.02, 3e-4, -5e-4, 0.0)),
    Camera("fisheye", 640, 480, (400.0, 401.0), (320.3, 239.1), (0.02, -0.008, 0.002, 0.0)),
)


class MeshTest(unittest.TestCase):
    def test_a_capsule_is_closed_and_has_its_volume(self) -> None:
        corners = capsule(2.0, 3.0)
        volume = np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])).sum() / 6
        self.assertAlmostEqual(volume / (np.pi * 4 * 6 + 4 / 3 * np.pi * 8), 1, places=2)
        # Of a closed surface the triangles' areas, as vectors, add up to nothing.
        areas = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        np.testing.assert_allclose(areas.sum(axis=0), 0, atol=1e-9)


class LensTest(unittest.TestCase):
    def test_projection_is_that_of_opencv(self) -> None:
        points = np.random.default_rng(1).uniform([-20, -15, 30], [30, 15, 90], (50, 3))
        for lens in LENSES:
            matrix = np.array([[lens.f_px[0], 0, lens.centre_px[0]], [0, lens.f_px[1], lens.centre_px[1]], [0, 0, 1]])
            none = np.zeros(3)
            if lens.model == "fisheye":
                told, _ = cv2.fisheye.projectPoints(points[:, None], none, none, matrix, np.array(lens.distortion))
            else:
                told, _ = cv2.projectPoints(points, none, none, matrix, np.array(lens.distortion or (0.0,) * 5))
            np.testing.assert_allclose(lens.project(points), told[:, 0], atol=1e-6)

    def test_a_lens_that_folds_is_known(self) -> None:
        self.assertFalse(any(lens.folds() for lens in LENSES))
        self.assertTrue(replace(LENSES[1], distortion=(-0.5, 0.0, 0.0, 0.0, 0.0)).folds())

    def test_lines_of_sight_come_back_to_their_pixels(self) -> None:
        port = replace(LENSES[0], port=Port(3.0, 2.0, 1.5, 1.41))
        pixels = np.random.default_rng(2).uniform(0, 470, (40, 2))
        for lens in (*LENSES, port):
            origins, lines = lens.sight_lines(pixels)
            np.testing.assert_allclose(lens.project(origins + 55 * lines), pixels, atol=1e-5)

    def test_port_makes_things_look_nearer_by_the_index(self) -> None:
        port = replace(LENSES[0], port=Port(0.0, 0.0, 1.5, 1.41))
        seen = (port.project(np.array([0.0, 0.1, 50.0])) - port.centre_px)[1] / port.f_px[1]
        self.assertAlmostEqual(0.1 / seen, 50 / 1.41, places=3)


class FaceTest(unittest.TestCase):
    def test_has_its_width_and_an_even_layer(self) -> None:
        face = Face(REST, POSE)
        s = np.linspace(1, 69, 30)
        across = face.point(s, np.full(30, 10.0)) - face.point(s, np.full(30, -10.0))
        np.testing.assert_allclose(np.linalg.norm(across, axis=1), 20.0, rtol=1e-6)
        np.testing.assert_allclose(np.sum(face.normal_at(s) * across, axis=1), 0, atol=1e-6)
        step = np.linalg.norm(face.point(s + 0.5, np.zeros(30)) - face.point(s, np.zeros(30)), axis=1)
        np.testing.assert_allclose(step, 0.5, rtol=2e-3)  # a sway lengthens it a little
        self.assertGreater(face.normal_at(s)[:, 2].min(), 0)

    def test_bending_moves_the_tip_as_far_as_told(self) -> None:
        straight = replace(REST, curvature_per_mm=0.0, curvature_slope_per_mm2=0.0, wave_per_mm=0.0)
        tips = [Face(straight, Pose(bend)).point(np.array(70.0), np.array(0.0)) for bend in (0.0, 1.0)]
        self.assertAlmostEqual(float(np.linalg.norm(tips[1] - tips[0])), 1.0, delta=0.01)

    def test_lines_meet_it_where_its_points_are(self) -> None:
        face = Face(REST, POSE)
        s, w = np.meshgrid(np.linspace(2, 68, 12), np.linspace(-9, 9, 7))
        for outward in (0.0, 1.5):
            points = face.point(s, w, outward)
            found_s, found_w = face.meet(np.zeros_like(points), points / points[..., 2:], outward)
            np.testing.assert_allclose(found_s, s, atol=2e-3)
            np.testing.assert_allclose(found_w, w, atol=2e-3)


class LayerTest(unittest.TestCase):
    def test_every_photon_is_somewhere(self) -> None:
        photons = walk(np.random.default_rng(3), 1.0, 0.05, 0.3, 0.8, 40_000)
        back = photons.weight.sum()
        self.assertAlmostEqual((back + photons.absorbed + photons.behind) / 40_000, 1.0, places=2)

    def test_half_space_reflects_as_chandrasekhar_says(self) -> None:
        # Isotropic scattering of albedo 0.9, light at right angles: 1 - H(1) sqrt(1 - albedo), H by iteration.
        albedo = 0.9
        mu, weight = np.polynomial.legendre.leggauss(64)
        mu, weight = 0.5 * (mu + 1), 0.5 * weight
        h = np.ones(64)
        for _ in range(300):
            h = 1 / (np.sqrt(1 - albedo) + 0.5 * albedo * ((mu / (mu + mu[:, None])) * (h * weight)).sum(axis=1))
        at_one = 1 / (np.sqrt(1 - albedo) + 0.5 * albedo * (mu / (mu + 1) * h * weight).sum())
        wanted = 1 - at_one * np.sqrt(1 - albedo)
        photons = walk(np.random.default_rng(4), 0.9, 0.1, 0.0, 1.0, 200_000, bottom_mm=200.0)
        self.assertAlmostEqual(photons.reflected(200.0), wanted, delta=0.004)

    def test_thin_layer_scatters_once(self) -> None:
        # To first order a layer of optical thickness x sends back albedo x / 2 times the mean of its ways out.
        thin = 0.02
        photons = walk(np.random.default_rng(5), 1.0, 0.0, 0.0, 1.0, 1_000_000, bottom_mm=thin)
        depth = (np.arange(400) + 0.5) / 400 * thin
        mu = (np.arange(1, 4001) - 0.5) / 4000
        once = np.mean(np.exp(-depth)[:, None] * np.exp(-depth[:, None] / mu)) * 0.5 * thin
        self.assertAlmostEqual(photons.reflected(thin) / once, 1.0, delta=0.06)

    def test_brightness_rises_and_is_one_at_rest(self) -> None:
        layer = Layer(walk(np.random.default_rng(6), 1.0, 0.02, 0.5, 0.8), 1.5)
        bright = layer.relative(np.linspace(0, 1.9, 50))
        self.assertTrue(np.all(np.diff(bright) > 0))
        self.assertAlmostEqual(float(layer.relative(np.array(1.5))), 1.0, places=6)
        self.assertLess(layer.misfit, 0.01)


class PencilTest(unittest.TestCase):
    @staticmethod
    def direction(cosine: float) -> np.ndarray:
        return np.array([np.sqrt(1 - cosine**2), 0.0, cosine])

    def test_half_space_looks_as_chandrasekhar_says(self) -> None:
        # Isotropic scattering of albedo w, light at cosine l, seen at s: w l / (l + s) H(l) H(s), H by iteration.
        albedo = 0.9
        mu, weight = np.polynomial.legendre.leggauss(64)
        mu, weight = 0.5 * (mu + 1), 0.5 * weight
        h = np.ones(64)
        for _ in range(300):
            h = 1 / (np.sqrt(1 - albedo) + 0.5 * albedo * ((mu / (mu + mu[:, None])) * (h * weight)).sum(axis=1))
        at = lambda m: 1 / (np.sqrt(1 - albedo) + 0.5 * albedo * (mu / (mu + m) * h * weight).sum())  # noqa: E731
        for sight, light in ((1.0, 1.0), (0.5, 0.9), (0.9, 0.4)):
            pencil = Pencil.walk(
                np.random.default_rng(7), albedo, 1 - albedo, self.direction(sight), self.direction(light), 200.0, 60_000
            )
            wanted = albedo * light / (light + sight) * at(light) * at(sight)
            self.assertAlmostEqual(pencil.even(200.0) / wanted, 1.0, delta=0.03)

    def test_thin_layer_scatters_once(self) -> None:
        # All that comes back was scattered once: a sum over the depth of that.
        sight, thick = self.direction(0.6), 0.01
        pencil = Pencil.walk(np.random.default_rng(8), 1.0, 0.0, sight, self.direction(0.8), thick, 60_000)
        slant = 1 / 0.6 + 1 / 0.8
        once = (1 - np.exp(-thick * slant)) / slant / 0.6
        self.assertAlmostEqual(pencil.even(thick) / once, 1.0, delta=0.06)

    def test_a_small_dent_is_seen_where_sight_meets_it_and_around(self) -> None:
        thick, sight = 1.5, self.direction(0.8)
        pencil = Pencil.walk(np.random.default_rng(9), 0.8, 0.01, sight, self.direction(0.9), 2.0, 3000)
        layer = np.full((121, 121), thick)
        np.testing.assert_allclose(pencil.relative(layer, thick), 1, rtol=1e-4)
        layer[58:63, 58:63] -= 0.3
        lost = 1 - pencil.relative(layer, thick)
        row, column = np.unravel_index(np.argmax(lost), lost.shape)
        aside = (thick - 0.3) * 0.75 / CELL_MM  # tangent of the sight's angle
        self.assertAlmostEqual(float(row), 60, delta=3)
        self.assertAlmostEqual(float(column), 60 - aside, delta=4)
        far = np.hypot(*(np.indices(lost.shape) - np.array([row, column])[:, None, None])) * CELL_MM
        skirt = float(lost[far > 0.5].sum() / lost.sum())
        self.assertTrue(0.25 < skirt < 0.75, skirt)

    def test_a_shallow_wide_dent_is_as_dark_as_it_must_be(self) -> None:
        # A thin layer scatters once: a sum over the depth of that.
        sight, thick, scatter = self.direction(0.7), 1.5, 0.01
        pencil = Pencil.walk(np.random.default_rng(10), scatter, 0.0, sight, self.direction(0.9), 2.0, 96_000)
        slant = scatter * (1 / 0.7 + 1 / 0.9)
        shown = 1 - pencil.relative(np.full((16, 16), 0.9 * thick), thick)
        wanted = np.exp(-slant * 0.9 * thick) - np.exp(-slant * thick)
        self.assertAlmostEqual(float(shown.mean()) * (1 - np.exp(-slant * thick)) / wanted, 1.0, delta=0.02)

    def test_light_is_lost_beside_the_face(self) -> None:
        pencil = Pencil.walk(
            np.random.default_rng(9), 1.0, 0.01, self.direction(1.0), self.direction(0.9), 2.0, 3000
        )
        layer = np.full((80, 5), 1.5)
        layer[:20] = 0
        across = pencil.relative(layer, 1.5).mean(axis=1)
        self.assertAlmostEqual(float(across[:20].max()), 0.0, places=6)
        self.assertTrue(0.4 < across[20] < 0.8, across[20])
        self.assertGreater(float(across[60]), 0.98)


class ContactTest(unittest.TestCase):
    FACE = Face(REST, Pose())
    STIFF = Skin(0.05, 0.0, 1.0)

    def test_ball_inside_is_the_ball(self) -> None:
        dent = Dent(self.FACE, self.STIFF, Body("ball", 35.0, 2.0, 0.6, (4.0,)))
        side = dent.side
        middle = side.middle
        self.assertAlmostEqual(float(dent.depth_at(middle[0], middle[1])), 0.6, places=2)
        x, y = middle[0] + 0.4, middle[1] - 0.3
        ball = dent.ball_mm
        z = ball[2] - np.sqrt(16 - (x - ball[0]) ** 2 - (y - ball[1]) ** 2)
        self.assertAlmostEqual(float(side.lookup(side.z, x, y) - dent.depth_at(x, y)), float(z), places=3)

    def test_skin_is_never_inside_of_the_body_and_leaves_it_before_the_rim(self) -> None:
        body = Body("cylinder", 35.0, 0.0, 0.6, (2.0, 3.0), 0.3)
        touching = []
        for lift in (0.05, 0.3):
            dent = Dent(self.FACE, Skin(lift, 0.0, 1.0), body)
            touching.append((dent.depth > 0.05).sum())
        self.assertGreater(touching[1], 1.1 * touching[0])

    def test_lift_off_dies_away_as_its_length_says(self) -> None:
        # Beside a long edge the membrane's depth falls by e each lift_off_mm.
        dent = Dent(self.FACE, Skin(0.5, 0.0, 1.0), Body("step", 35.0, 0.0, 0.5, (12.0, 6.0, 0.1)))
        column = dent.depth[:, dent.depth.shape[1] // 2]
        row = int(np.flatnonzero(column > 0.3)[-1])
        steps = round(0.5 / GRID_MM)
        self.assertAlmostEqual(float(column[row + steps] / column[row]), np.exp(-1), delta=0.03)

    def test_thickness_along_the_normal(self) -> None:
        dent = Dent(self.FACE, self.STIFF, Body("plate", 35.0, 0.0, 0.5, (8.0, 8.0, 1.0)))
        thick = float(dent.thickness_at(np.array(35.0), np.array(0.0)))
        incline = float(self.FACE.normal_at(np.array(35.0))[2])
        self.assertAlmostEqual(thick, 1.5 - 0.5 * incline, delta=0.01)

    def test_nothing_far_away(self) -> None:
        dent = Dent(self.FACE, self.STIFF, Body("ball", 35.0, 0.0, 0.6, (4.0,)))
        self.assertAlmostEqual(float(dent.thickness_at(np.array(42.5), np.array(4.0))), 1.5, delta=2e-3)


class SmallToolsTest(unittest.TestCase):
    def test_blur_keeps_sums_and_widens(self) -> None:
        spot = np.zeros((41, 41))
        spot[20, 20] = 1.0
        wide = blurred(spot, 2.0, 1.0)
        place = np.arange(41) - 20
        self.assertAlmostEqual(wide.sum(), 1.0, places=6)
        self.assertAlmostEqual(float((wide.sum(axis=1) * place**2).sum()), 4.0, delta=0.1)
        self.assertAlmostEqual(float((wide.sum(axis=0) * place**2).sum()), 1.0, delta=0.05)

    def test_cubics_are_exact_for_cubics(self) -> None:
        knots = np.array([0, 6, 12, 18, 24, 29])
        place = np.arange(30.0)
        law = lambda x: 0.01 * x**3 - x + 2  # noqa: E731
        np.testing.assert_allclose(cubic_weights(30, knots) @ law(knots), law(place), atol=1e-9)


class PictureTest(unittest.TestCase):
    def test_same_numbers_same_picture(self) -> None:
        pictures = []
        for _ in range(2):
            finger = draw_finger(9, 0, "small-picture")
            light, _ = Renderer(finger).light(Pose(1.0))
            pictures.append(finger.sensor.expose(light, np.random.default_rng(1)))
        np.testing.assert_array_equal(*pictures)

    def test_truth_lies_where_the_picture_is_dark(self) -> None:
        finger = draw_finger(9, 0, "small-picture")
        body = Body("ball", 0.5 * finger.rest.length_mm, 0.0, 0.5, (4.0,))
        renderer = Renderer(finger)
        free, _ = renderer.light(Pose())
        light, truth = renderer.light(Pose(), bodies=(body,), with_truth=True)
        assert truth is not None
        change = 1 - light / free
        self.assertLess(np.abs(change[np.nan_to_num(truth.border_mm) <= 0]).max(), 0.01)
        # Along its normal the darkest pixel looks at the place that is pressed, along z another one does.
        v, u = np.unravel_index(np.argmax(change), change.shape)
        origins, lines = finger.camera.sight_lines(np.array([[[u, v]]], float))
        s, w = Face(finger.rest, Pose()).meet(origins, lines)
        self.assertAlmostEqual(float(s[0, 0]), body.s_mm, delta=0.8)
        self.assertAlmostEqual(float(w[0, 0]), body.w_mm, delta=0.3)
        pressed = np.nan_to_num(truth.depth_mm) > 0.2
        self.assertAlmostEqual((change > change.max() * 0.4).sum() / pressed.sum(), 1.0, delta=0.5)
        self.assertEqual(len(truth.regions), 1)

    def test_depth_comes_back_from_a_picture_without_noise(self) -> None:
        # Brightness to thickness by the layer's own law, and from there along the normal to the pressed face.
        finger = replace(draw_finger(9, 0, "small-picture"), spread_mm=1e-4)
        pose, face = Pose(1.0, 0.5, 0.3, 2.0), Face(finger.rest, Pose(1.0, 0.5, 0.3, 2.0))
        body = Body("ball", 0.5 * finger.rest.length_mm, 1.0, 0.6 * finger.rest.layer_mm, (4.0,))
        renderer = Renderer(finger)
        share = renderer.light(pose, bodies=(body,))[0] / renderer.light(pose)[0]
        v, u = np.mgrid[: share.shape[0], : share.shape[1]]
        s, w = face.meet(*finger.camera.sight_lines(np.stack([u, v], axis=-1).astype(float)))
        near = (np.hypot(s - body.s_mm, w - body.w_mm) < 3) & (share < 0.99)
        thick = np.linspace(0.05, 1.0, 4000) * finger.rest.layer_mm
        found = np.interp(share[near], finger.layer.relative(thick), thick)
        place = face.point(s[near], w[near]) + found[:, None] * face.normal_at(s[near])
        dent = Dent(face, finger.skin, body)
        depth = dent.side.lookup(dent.side.z, place[:, 0], place[:, 1]) - place[:, 2]
        self.assertGreater(depth.max(), 0.55 * finger.rest.layer_mm)
        np.testing.assert_allclose(depth, dent.depth_at(place[:, 0], place[:, 1]), atol=2e-3)

    def test_mirrored_finger_is_the_same_finger(self) -> None:
        finger = draw_finger(9, 0, "small-picture")
        camera = mirrored_camera(replace(finger.camera, model="brown", distortion=(-0.1, 0.01, 3e-4, 5e-4, 0.0)))
        plain = replace(finger.camera, model="brown", distortion=(-0.1, 0.01, 3e-4, 5e-4, 0.0))
        points = np.array([[5.0, 3.0, 40.0], [-7.0, -2.0, 50.0]])
        there, here = camera.project(points * [-1, 1, 1]), plain.project(points)
        np.testing.assert_allclose(there, [finger.camera.width_px - 1, 0] + here * [-1, 1], atol=1e-9)

    def test_every_class_can_be_drawn(self) -> None:
        for kind in CLASSES:
            finger = draw_finger(3, 1, kind, photons=3000)
            self.assertEqual(finger.kind, kind)
            self.assertEqual(len(finger.dots) == 0, kind == "no-dots")


class DatasetTest(unittest.TestCase):
    def test_a_kept_finger_is_not_rendered_again(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            made = make_finger(Path(folder), 9, 0, "short-recording")
            before = (made / "recording" / "frame_0003.png").stat().st_mtime_ns
            self.assertEqual(make_finger(Path(folder), 9, 0, "short-recording"), made)
            self.assertEqual((made / "recording" / "frame_0003.png").stat().st_mtime_ns, before)
            self.assertEqual(len(list((made / "presses").iterdir())), 6)


if __name__ == "__main__":
    unittest.main()
