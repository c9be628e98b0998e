"""alltact for Python, held against the command line."""
import ast, gc, json, os, shutil, subprocess, sys, tempfile, threading, time, unittest
from pathlib import Path

import cv2
import numpy as np

import alltact
import fingers

SLOW = os.environ.get("ALLTACT_SLOW") not in (None, "", "0")
STUB = fingers.TOP / "packaging/python/alltact/_alltact.pyi"


def address(array: np.ndarray) -> int:
    return array.__array_interface__["data"][0]


def without_times(told: dict) -> dict:
    return {key: value for key, value in told.items() if key not in ("times_ms", "depth16")}


class SameBytes(unittest.TestCase):
    """A recording measured by Python and by `alltact reconstruct` on two cores."""

    def test_a_bending_finger(self):
        frames, finger = 1000 if SLOW else 60, fingers.fin_ray()
        with tempfile.TemporaryDirectory() as folder:
            folder = Path(folder)
            fingers.alltact("simulate", fingers.touched_scene(frames), "-o", folder / "in", "--video", "--threads", 2)
            fingers.alltact("reconstruct", finger, folder / "in/frames.mkv", "-o", folder / "out", "--threads", 2, "--format",
                            "depth,depth16,flags,depth_sd")
            lines = alltact.read_results(folder / "out")
            self.assertEqual(len(lines), frames)
            count = touched = 0
            for result in alltact.load(finger).reconstruct(folder / "in/frames.mkv"):
                name = result.frame.name
                self.assertEqual(alltact.depth_tiff(result.depth), (folder / f"out/{name}.depth.tiff").read_bytes(), name)
                self.assertEqual(alltact.depth_tiff(result.depth_sd), (folder / f"out/{name}.depth_sd.tiff").read_bytes(), name)
                depth16 = cv2.imread(str(folder / f"out/{name}.depth16.png"), cv2.IMREAD_UNCHANGED)
                np.testing.assert_array_equal(alltact.to_depth16(result.depth), depth16)
                np.testing.assert_array_equal(result.flags, cv2.imread(str(folder / f"out/{name}.flags.png"), cv2.IMREAD_UNCHANGED))
                self.assertEqual(without_times(result.told), without_times(lines[count]))
                touched += result.contact is not None
                count += 1
            self.assertEqual(count, frames)
            self.assertGreater(touched, frames // 2)

    def test_pictures_that_do_not_follow_each_other(self):
        finger, out = fingers.flat_finger(), fingers.FOLDER / "flat_out"
        fingers.alltact("reconstruct", finger, *fingers.flat_presses(), "-o", out, "--format", "depth,points")
        one = alltact.load(finger)
        for file, result in zip(fingers.flat_presses(), one.reconstruct(fingers.flat_presses()), strict=True):
            self.assertEqual(alltact.depth_tiff(result.depth), (out / f"{file.stem}.depth.tiff").read_bytes())
            points = cv2.imread(str(out / f"{file.stem}.points.tiff"), cv2.IMREAD_UNCHANGED)
            np.testing.assert_array_equal(result.points, points)
            # A camera's loop: arrays, one after the other.
            again = one.measure(cv2.imread(str(file), cv2.IMREAD_GRAYSCALE), name=file.stem)
            np.testing.assert_array_equal(again.depth, result.depth)
            np.testing.assert_array_equal(alltact.read_depth(out, file.stem), result.depth)


class Arrays(unittest.TestCase):
    """Memory is shared, and lives as long as anybody looks at it."""

    def setUp(self):
        self.finger = alltact.load(fingers.flat_finger())
        self.picture = cv2.imread(str(fingers.flat_presses()[0]), cv2.IMREAD_GRAYSCALE)

    def test_a_picture_is_not_copied(self):
        frame = alltact.Frame(self.picture)
        self.assertEqual(address(frame.grey), address(self.picture))
        result = self.finger.measure(self.picture)
        self.assertEqual(address(result.grey), address(self.picture))
        self.assertEqual(address(result.frame.grey), address(self.picture))
        wide = np.zeros((360, 500), np.uint8)  # rows of a larger picture lie apart
        wide[:, 10:490] = self.picture
        part = self.finger.measure(wide[:, 10:490])
        self.assertEqual(address(part.grey), address(wide) + 10)
        np.testing.assert_array_equal(part.depth, result.depth)

    def test_results_are_not_copied(self):
        result = self.finger.measure(self.picture)
        for name, dtype, shape in (("depth", np.float32, (360, 480)), ("flags", np.uint8, (360, 480)),
                                   ("points", np.float32, (360, 480, 3)), ("depth_sd", np.float32, (360, 480))):
            array = getattr(result, name)
            self.assertEqual((array.dtype, array.shape), (dtype, shape), name)
            self.assertEqual(address(array), address(getattr(result, name)), name)
            self.assertFalse(array.flags.writeable, name)
            with self.assertRaises(ValueError):
                array[0, 0] = 0

    def test_arrays_outlive_what_made_them(self):
        result = self.finger.measure(self.picture)
        kept = {name: getattr(result, name) for name in ("depth", "flags", "points", "depth_sd", "grey")}
        copies = {name: array.copy() for name, array in kept.items()}
        frame = alltact.Recording(fingers.FOLDER / "flat_press")[1].grey
        frame_copy = frame.copy()
        del result, self.finger
        gc.collect()
        rubbish = [np.random.default_rng(1).random((360, 480), np.float32) for _ in range(20)]
        for name, array in kept.items():
            np.testing.assert_array_equal(array, copies[name], name)
        np.testing.assert_array_equal(frame, frame_copy)
        del rubbish

    def test_the_frame_is_held_as_long_as_its_result_and_no_longer(self):
        before = sys.getrefcount(self.picture)
        result = self.finger.measure(self.picture)
        self.assertGreater(sys.getrefcount(self.picture), before)
        grey = result.grey
        del result
        self.finger.forget()
        self.assertGreater(sys.getrefcount(self.picture), before)
        del grey
        self.assertEqual(sys.getrefcount(self.picture), before)

    def test_results_do_not_pile_up(self):
        def resident_mb():
            return int(Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 1e6
        for _ in range(20):
            self.finger.measure(self.picture).points
        before = resident_mb()
        for _ in range(50):
            self.finger.measure(self.picture).points
        self.assertLess(resident_mb() - before, 20)  # one result has 3.5 MB

    def test_a_buffer_that_is_used_again_is_no_camera_that_stands_still(self):
        buffer = self.picture.copy()
        self.finger.measure(buffer)
        buffer[:] = cv2.imread(str(fingers.flat_presses()[1]), cv2.IMREAD_GRAYSCALE)
        self.assertEqual(self.finger.measure(buffer).problems, [])

    def test_what_is_averaged_is_kept_apart(self):
        mean = alltact.load(fingers.flat_finger(), average_frames=2)
        buffer = self.picture.copy()
        mean.measure(buffer)
        other = cv2.imread(str(fingers.flat_presses()[1]), cv2.IMREAD_GRAYSCALE)
        buffer[:] = other
        expected = np.rint((self.picture.astype(float) + other) / 2)
        self.assertLessEqual(np.abs(mean.measure(buffer).grey - expected).max(), 1)


class WhatAFrameTells(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.finger = alltact.load(fingers.fin_ray())
        cls.scene = alltact.Scene(fingers.touched_scene(60))
        cls.picture = cls.scene.render(12)
        cls.result = cls.finger.measure(cls.picture, time_ns=5_000_000_000, name="twelve")

    def test_depth_is_what_is_so(self):
        truth = self.scene.truth(12)
        pressed = (truth["depth_mm"] > 0.1) & np.isfinite(self.result.depth)
        self.assertGreater(pressed.sum(), 200)
        self.assertLess(np.abs(self.result.depth - truth["depth_mm"])[pressed].mean(), 0.05)

    def test_points_lie_where_the_face_is(self):
        truth = self.scene.truth(12)
        z = truth["untouched_z_mm"] - truth["depth_mm"]
        both = np.isfinite(z) & np.isfinite(self.result.points[..., 2])
        self.assertGreater(both.mean(), 0.2)
        self.assertLess(np.median(np.abs(self.result.points[..., 2] - z)[both]), 0.3)

    def test_markers_are_where_the_scene_put_them(self):
        truth = np.array([[dot["u"], dot["v"]] for dot in self.scene.truth(12)["markers"]])
        self.assertEqual(self.result.markers.shape, (12, 2))
        self.assertLess(np.abs(self.result.markers - truth)[self.result.markers_seen].max(), 0.5)

    def test_the_rest_has_the_names_of_the_results_file(self):
        self.assertEqual(json.loads(self.result.line), self.result.told)
        self.assertEqual(self.result.told["frame"], "twelve")
        self.assertEqual(self.result.told["time_ns"], 5_000_000_000)
        self.assertIs(self.result.regions, self.result.told["regions"])
        self.assertEqual(self.result.contact["face"], "contact")
        self.assertGreater(self.result.regions[0]["deepest_mm"], 0.1)
        self.assertIsNone(self.result.force)
        self.assertEqual(self.result.problems, [])
        self.assertGreater(self.result.times_ms["total"], 0)

    def test_what_it_is(self):
        self.assertEqual((self.finger.name, self.finger.marker_count), ("left-07", 12))
        self.assertTrue(self.finger.is_calibrated and self.finger.has_reference)
        self.assertEqual(self.finger.camera["fx_px"], 261.95)
        self.assertEqual(self.finger.face, {"kind": "fin_ray", "width_mm": 24.0, "layer_mm": 1.5})
        self.assertEqual(self.finger.provenance["ball_radius_mm"], "4")
        half = alltact.load(self.finger.folder, resolution="half")
        self.assertEqual(half.settings["resolution"], "half")
        self.assertEqual(half.camera["size_px"], [240, 135])
        self.assertEqual(half.measure(self.picture).depth.shape, (135, 240))

    def test_python_runs_beside(self):
        # Between whiles a thread that held the interpreter would let this one run for 5 ms at most.
        recording, state = alltact.Recording(fingers.FOLDER / "bending/frames.mkv"), {}

        def work():
            with tempfile.TemporaryDirectory() as folder:
                shutil.copytree(fingers.flat_finger(), Path(folder, "f"))
                state["begun"] = True
                alltact.calibrate(Path(folder, "f"), fingers.flat_presses(), fingers.BALL_MM, reference=fingers.flat_reference())
                state["done"] = True
        thread = threading.Thread(target=work)
        thread.start()
        beside = 0
        while "done" not in state and thread.is_alive():
            beside += "begun" in state and "done" not in state
            recording[0]
        thread.join()
        self.assertIn("done", state)
        self.assertGreater(beside, 20)


class Sources(unittest.TestCase):
    def test_a_recording(self):
        fingers.fin_ray()
        recording = alltact.Recording(fingers.FOLDER / "bending/frames.mkv")
        self.assertEqual(len(recording), fingers.BENDING)
        self.assertEqual(recording.times_ns.dtype, np.int64)
        self.assertTrue((np.diff(recording.times_ns) > 0).all())
        self.assertEqual(recording[-1].name, f"frame_{fingers.BENDING - 1:05}")
        self.assertEqual(recording[7].time_ns, recording.times_ns[7])
        with self.assertRaises(IndexError):
            recording[fingers.BENDING]
        rendered = alltact.Scene(fingers.scene("demo_reference", camera=fingers.SMALL, frames=f"frames: {fingers.BENDING}")).render(7)
        np.testing.assert_array_equal(recording[7].grey, rendered)
        self.assertEqual(sum(1 for _ in recording), fingers.BENDING)

    def test_pictures_have_no_times(self):
        fingers.flat_finger()
        recording = alltact.Recording(fingers.FOLDER / "flat_press")
        self.assertEqual(len(recording), 4)
        self.assertIsNone(recording.times_ns)
        self.assertIsNone(recording[0].time_ns)
        np.testing.assert_array_equal(recording[2].grey, cv2.imread(str(fingers.flat_presses()[2]), cv2.IMREAD_GRAYSCALE))

    def test_a_source_is_an_iterator(self):
        source = alltact.open_source(fingers.flat_scene(5))
        self.assertEqual((source.count, source.is_live, source.is_continuous), (5, False, True))
        frames = list(source)
        self.assertEqual([frame.sequence for frame in frames], [0, 1, 2, 3, 4])
        np.testing.assert_array_equal(frames[3].grey, alltact.Scene(fingers.flat_scene(5)).render(3))

    def test_a_damaged_picture_is_told_and_the_next_one_comes(self):
        with tempfile.TemporaryDirectory() as folder:
            for number, file in enumerate(fingers.flat_presses()):
                shutil.copy(file, Path(folder, f"p{number}.png"))
            Path(folder, "p1.png").write_bytes(b"no picture")
            source = alltact.open_source(folder)
            self.assertEqual(next(source).name, "p0")
            with self.assertRaisesRegex(alltact.Error, "p1.png"):
                next(source)
            self.assertEqual(next(source).name, "p2")
            results = list(alltact.load(fingers.flat_finger()).reconstruct(folder))
            self.assertEqual([result.depth is None for result in results], [False, True, False, False])
            self.assertIn("p1.png", results[1].problems[0])
            self.assertIsNone(results[1].frame)

    def test_a_stream_gives_the_newest(self):
        finger = alltact.load(fingers.flat_finger())
        with finger.stream(fingers.flat_scene()) as stream:
            sequence = [next(stream).frame.sequence for _ in range(4)]
        self.assertEqual(sequence, sorted(set(sequence)))
        self.assertGreaterEqual(sequence[-1] + 1, 4 + stream.skipped - 1)
        with self.assertRaises(StopIteration):
            next(stream)

    def test_a_stream_follows_the_finger(self):
        with tempfile.TemporaryDirectory() as folder:
            shutil.copytree(fingers.flat_finger(), Path(folder, "f"))
            with alltact.load(Path(folder, "f")).stream(fingers.flat_scene()) as stream:
                first = next(stream).finger_revision
                alltact.calibrate(Path(folder, "f"), fingers.flat_presses()[:3], fingers.BALL_MM, reference=fingers.flat_reference())
                end = time.monotonic() + 60
                while (now := next(stream).finger_revision) == first and time.monotonic() < end:
                    pass
                self.assertGreater(now, first)

    def test_what_a_stream_reads_is_its_own(self):
        finger, source = alltact.load(fingers.flat_finger()), alltact.open_source(fingers.flat_scene(), live=True)
        with finger.stream(source):
            with self.assertRaisesRegex(alltact.Error, "something else reads this source"):
                next(source)


class Calibrating(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = Path(self.temporary.name, "f")
        shutil.copytree(fingers.flat_finger(), self.folder)

    def tearDown(self):
        self.temporary.cleanup()

    def test_it_makes_the_command_lines_finger(self):
        told = []
        done = alltact.calibrate(self.folder, fingers.flat_presses(), fingers.BALL_MM, reference=fingers.flat_reference(),
                                 date="2026-01-31T12:00:00Z", operator="Ada", progress=lambda done, what: told.append(done))
        self.assertEqual(done.grade, "unproven")  # all presses lie in few places
        self.assertLess(done.expected_error_mm, 0.15)
        self.assertEqual([press["name"] for press in done.presses], [file.stem for file in fingers.flat_presses()])
        self.assertTrue(all(0 <= fraction <= 1 for fraction in told))
        self.assertEqual(told[-1], 1)
        other = Path(self.temporary.name, "g")
        shutil.copytree(fingers.flat_finger(), other)
        fingers.alltact("calibrate", other, *fingers.flat_presses(), "--reference", fingers.flat_reference(), "--ball-radius-mm", 4,
                        "--date", "2026-01-31T12:00:00Z", "--operator", "Ada")
        mapping = [Path(folder, "finger.yaml").read_text().replace("name: f\n", "name: flat\n").replace("name: g\n", "name: flat\n")
                   for folder in (self.folder, other)]
        self.assertEqual(*mapping)

    def test_presses_may_be_frames_and_something_be_said_of_them(self):
        frames = [alltact.Frame(cv2.imread(str(file), cv2.IMREAD_GRAYSCALE), name=file.stem) for file in fingers.flat_presses()]
        done = alltact.calibrate(self.folder, frames, fingers.BALL_MM, reference=fingers.flat_reference(),
                                 say={"exclude": ["frame_00003=slipped"]}, family="moebius")
        self.assertEqual(len(done.presses), 3)
        self.assertIn("slipped", " ".join(done.left_out))
        self.assertIn("kind: moebius", (self.folder / "finger.yaml").read_text())

    def test_an_exception_on_the_way_stops_it_and_nothing_is_changed(self):
        before = (self.folder / "finger.yaml").read_bytes()

        def stop(done, what):
            raise KeyboardInterrupt
        with self.assertRaises(KeyboardInterrupt):
            alltact.calibrate(self.folder, fingers.flat_presses(), fingers.BALL_MM, reference=fingers.flat_reference(), progress=stop)
        self.assertEqual((self.folder / "finger.yaml").read_bytes(), before)

    def test_a_study_is_read(self):
        (self.folder / "study.json").write_text('{"studies": [{"rows": 3}]}')
        self.assertEqual(alltact.read_study(self.folder)["studies"][0]["rows"], 3)
        self.assertEqual(alltact.presets(self.folder), {})
        with self.assertRaises(alltact.Error):
            alltact.read_study(self.folder / "nowhere")


class Errors(unittest.TestCase):
    def test_each_is_a_sentence_that_says_what_to_try(self):
        with self.assertRaises(alltact.Error) as raised:
            alltact.load("/nowhere/left-07")
        self.assertEqual(type(raised.exception), alltact.Error)
        self.assertIn("/nowhere/left-07", raised.exception.where)
        self.assertTrue(raised.exception.advice)
        self.assertIn("Try: " + raised.exception.advice, str(raised.exception))

    def test_what_is_no_grey_picture(self):
        finger = alltact.load(fingers.flat_finger())
        grey = np.full((360, 480), 90, np.uint8)
        for wrong in (grey.astype(np.float32), np.dstack([grey] * 3), grey[:, ::2], grey[:, ::-1], grey[:0], [[1, 2]], None, "picture.png"):
            with self.assertRaises(alltact.Error):
                finger.measure(wrong)
        with self.assertRaisesRegex(alltact.Error, "480"):
            finger.measure(np.ascontiguousarray(grey[:, :100]))

    def test_settings(self):
        with self.assertRaisesRegex(alltact.Error, "'smooting_px', but 'smoothing_px'"):
            alltact.load(fingers.flat_finger(), smooting_px=1)
        with self.assertRaisesRegex(alltact.Error, "99"):
            alltact.load(fingers.flat_finger(), smoothing_px=99)
        with self.assertRaises(alltact.Error):
            alltact.load(fingers.flat_finger(), preset="fastest")
        with self.assertRaisesRegex(alltact.Error, "'exclud', but 'exclude'"):
            alltact.calibrate(fingers.flat_finger(), fingers.flat_presses(), 4.0, say={"exclud": ["a"]})

    def test_files(self):
        for call in (lambda: alltact.open_source("/nowhere.mkv"), lambda: alltact.Recording("/nowhere"), lambda: alltact.Scene("/nowhere.yaml"),
                     lambda: alltact.read_depth("/nowhere", "x"), lambda: alltact.read_results("/nowhere.jsonl"),
                     lambda: alltact.depth_tiff(np.zeros((2, 2)))):
            self.assertRaises(alltact.Error, call)


class Stub(unittest.TestCase):
    """The stub tells what is there, and nothing else."""

    def test_names_and_docstrings(self):
        from alltact import _alltact
        types = {node.name for node in ast.parse(STUB.read_text()).body if isinstance(node, ast.ClassDef)
                 and any(getattr(base, "id", "") == "TypedDict" for base in node.bases)}
        said = {node.name: node for node in ast.parse(STUB.read_text()).body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
        self.assertEqual(set(said) - types, {name for name in dir(_alltact) if not name.startswith("_")})
        for name in set(said) - types:
            there = getattr(_alltact, name)
            self.assertEqual(there.__doc__ and there.__doc__.strip() or None, ast.get_docstring(said[name]), name)
            if isinstance(said[name], ast.ClassDef) and name != "Error":
                members = {node.name: node for node in said[name].body if isinstance(node, ast.FunctionDef)}
                public = {member for member in vars(there) if not member.startswith("_")}
                self.assertEqual({member for member in members if not member.startswith("_")}, public, name)
                for member in public:
                    self.assertEqual((getattr(there, member).__doc__ or "").strip() or None, ast.get_docstring(members[member]), f"{name}.{member}")

    def test_the_package_gives_what_it_says(self):
        for name in alltact.__all__:
            self.assertTrue(hasattr(alltact, name), name)
        stub = (fingers.TOP / "packaging/python/alltact/__init__.pyi").read_text()
        self.assertTrue(all(name in stub for name in alltact.__all__))
        version = subprocess.run([fingers.PROGRAM, "--version"], capture_output=True, text=True).stdout
        self.assertEqual(version, f"alltact {alltact.__version__}\n")


if __name__ == "__main__":
    unittest.main()
