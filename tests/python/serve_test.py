"""alltact serve, heard by the clients that come with it, beside what `alltact reconstruct` writes of the same frames."""
import contextlib, json, os, re, shutil, signal, socket, subprocess, sys, tempfile, time, unittest
from pathlib import Path

import cv2
import numpy as np

import fingers

sys.path.insert(0, str(fingers.TOP / "packaging/clients"))
import alltact_client

CPP_CLIENT = os.environ.get("ALLTACT_CPP_CLIENT", "")
FRAMES = 600  # of the scene: more than any test hears


@contextlib.contextmanager
def serving(finger: Path, source, *options):
    """Runs the server; gives its socket and its process."""
    with tempfile.TemporaryDirectory(prefix="a") as folder:
        path = Path(folder, "own/f.sock")
        process = subprocess.Popen([fingers.PROGRAM, "serve", str(finger), str(source), "--socket", str(path), *options], text=True,
                                   stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        try:
            end = time.monotonic() + 60
            while not path.exists() and process.poll() is None and time.monotonic() < end:
                time.sleep(0.01)
            yield path, process
        finally:
            if process.poll() is None:
                process.kill()
            process.communicate()


def stop(process) -> tuple[str, str]:
    process.send_signal(signal.SIGINT)
    said = process.communicate(timeout=60)
    return said


def frames_of(path: Path, count: int, *parts: str) -> tuple[dict, list]:
    """What the finger is, and so many frames."""
    finger, frames = None, []
    for kind, told, arrays in alltact_client.messages(str(path), *parts):
        if kind == "finger":
            finger = told
        elif kind == "frame":
            frames.append((told, arrays))
        if len(frames) == count:
            return finger, frames
    raise AssertionError("it ended before")


def without_times(told: dict) -> dict:
    return {key: value for key, value in told.items()
            if key not in ("times_ms", "index", "sequence", "time_ns", "lost", "finger_revision", "finger_contact", "depth16")}


class Serve(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.finger, cls.scene = fingers.flat_finger(), fingers.flat_scene(FRAMES)

    def reconstructed(self, frames: int) -> Path:
        """What the command line makes of the scene's first frames, some more than so many."""
        frames = -(-frames // 50) * 50
        out = fingers.FOLDER / f"served-{frames}"
        if not out.exists():
            fingers.alltact("simulate", self.scene, "-o", out / "in", "--frames", frames)
            fingers.alltact("reconstruct", self.finger, out / "in", "-o", out, "--format", "depth,depth16,flags,points")
        return out

    def test_what_arrives_is_what_reconstruct_writes(self):
        with serving(self.finger, self.scene) as (path, process):
            finger, frames = frames_of(path, 12, "picture", "depth16", "depth", "flags", "points")
            out, errors = stop(process)
        self.assertEqual(process.returncode, 0, errors)
        self.assertIn("to programs of this user on this computer only", out)
        self.assertFalse(path.exists())
        self.assertEqual(finger["parts"]["depth16"]["zero_at"], 10000)
        self.assertEqual(finger["size_px"], [480, 360])
        last = frames[-1][0]["sequence"]
        self.assertLess(last, FRAMES)
        truth = self.reconstructed(last + 1)
        lines = [json.loads(line) for line in (truth / "results.jsonl").read_text().splitlines()]
        for told, arrays in frames:
            name = told["frame"]
            self.assertEqual(name, f"frame_{told['sequence']:05}")
            for part, file in (("picture", f"in/{name}.png"), ("depth16", f"{name}.depth16.png"), ("flags", f"{name}.flags.png"),
                               ("points", f"{name}.points.tiff"), ("depth", f"{name}.depth.tiff")):
                np.testing.assert_array_equal(arrays[part], cv2.imread(str(truth / file), cv2.IMREAD_UNCHANGED), f"{name} {part}")
            self.assertEqual(without_times(told), without_times(lines[told["sequence"]]))
        first = frames[0][0]
        for count, (told, _) in enumerate(frames):  # whatever this client was too slow for is counted
            self.assertEqual(told["index"] - first["index"], count + told["lost"] - first["lost"])

    def test_a_bending_finger_arrives_as_it_is_reconstructed(self):
        finger, scene = fingers.fin_ray(), fingers.touched_scene(FRAMES, frames_per_s=8)
        with serving(finger, scene) as (path, process):
            _, frames = frames_of(path, 10, "depth16", "depth", "flags")
            stop(process)
        # Markers are followed from frame to frame: the same bits come where the server, too, has measured every frame.
        frames = [(told, arrays) for told, arrays in frames if told["index"] == told["sequence"]]
        self.assertGreater(len(frames), 4)
        out = fingers.FOLDER / "bent"
        fingers.alltact("simulate", scene, "-o", out / "in", "--frames", frames[-1][0]["sequence"] + 1, "--threads", 2)
        fingers.alltact("reconstruct", finger, out / "in", "-o", out, "--format", "depth,depth16,flags")
        for told, arrays in frames:
            for part, file in (("depth", "depth.tiff"), ("depth16", "depth16.png"), ("flags", "flags.png")):
                written = cv2.imread(str(out / f"{told['frame']}.{file}"), cv2.IMREAD_UNCHANGED)
                np.testing.assert_array_equal(arrays[part], written, f"{told['frame']} {part}")

    def test_the_schema_tells_every_key_that_arrives(self):
        schema = json.loads(fingers.alltact("serve", "--schema", "--json"))
        keys = {message: set(paths) for message, paths in schema["json"].items()}

        def paths_of(told, before=""):
            for key, value in told.items():
                if isinstance(value, dict):
                    yield from paths_of(value, f"{before}{key}.")
                elif isinstance(value, list) and value and isinstance(value[0], dict):
                    for entry in value:
                        yield from paths_of(entry, f"{before}{key}[].")
                else:
                    yield before + key + ("[]" if key == "problems" else "")
        with serving(fingers.fin_ray(), fingers.touched_scene(FRAMES)) as (path, process):
            finger, frames = frames_of(path, 20)
            stop(process)
        for key in set(finger) - {"sequence", "time_ns", "lost"}:
            self.assertIn(key, keys["finger"])
        for told, _ in frames:
            self.assertLessEqual(set(paths_of(told)) - {"sequence", "lost"}, keys["frame"])
        text = fingers.alltact("serve", "--schema")
        for key in keys["frame"]:
            self.assertIn(f"\n  {key} ", text)
        self.assertIn("alltact-stream/1", text)
        self.assertLessEqual(max(map(len, text.splitlines())), 100)

    @unittest.skipUnless(CPP_CLIENT, "the C++ client was not built")
    def test_the_client_in_cpp(self):
        with serving(self.finger, self.scene) as (path, process):
            client = subprocess.Popen([CPP_CLIENT, str(path)], stdout=subprocess.PIPE, text=True)
            deepest, first = {}, client.stdout.readline()
            while len(deepest) < 5:
                number, micrometres, lost = map(int, re.match(r"frame (\d+): (-?\d+) um, (\d+) frames lost", client.stdout.readline()).groups())
                deepest[number] = micrometres
            stop(process)
            rest, _ = client.communicate(timeout=60)
        self.assertEqual(json.loads(first)["format"], "alltact-stream/1")
        self.assertIn("stopped by hand", rest)
        self.assertEqual(client.returncode, 0)
        truth = self.reconstructed(max(deepest) + 1)
        for number, micrometres in deepest.items():
            depth16 = cv2.imread(str(truth / f"frame_{number:05}.depth16.png"), cv2.IMREAD_UNCHANGED)
            self.assertEqual(micrometres, int(depth16.max()) - 10000)
        self.assertGreater(max(deepest.values()), 200)

    def test_the_client_in_python_as_a_program(self):
        with serving(self.finger, self.scene) as (path, process):
            client = subprocess.Popen([sys.executable, "-W", "error", fingers.TOP / "packaging/clients/alltact_client.py", str(path), "depth16"],
                                      stdout=subprocess.PIPE, text=True)
            lines = [json.loads(client.stdout.readline()) for _ in range(3)]
            stop(process)
            rest, _ = client.communicate(timeout=60)
        self.assertEqual([line["type"] for line in lines], ["finger", "frame", "frame"])
        self.assertEqual(lines[1]["arrays"], {"depth16": [360, 480]})
        self.assertEqual(json.loads(rest.splitlines()[-1])["type"], "end")

    def test_the_client_is_thirty_lines(self):
        source = (fingers.TOP / "packaging/clients/alltact_client.py").read_text()
        code = [line for line in source.splitlines() if line.strip() and not line.strip().startswith(('"""', "#"))]
        self.assertLessEqual(len(code), 30)

    def test_one_that_does_not_read_holds_up_neither_server_nor_others(self):
        with serving(self.finger, self.scene) as (path, process):
            stuck = socket.socket(socket.AF_UNIX)
            stuck.connect(str(path))
            stuck.sendall(b"alltact-stream/1 picture depth points flags depth16\n")
            _, frames = frames_of(path, 40, "depth16")
            self.assertEqual([told["lost"] for told, _ in frames], [0] * 40)
            stuck.close()
            _, frames = frames_of(path, 3, "depth16")
            out, errors = stop(process)
        self.assertEqual(process.returncode, 0, errors)
        self.assertGreater(int(re.search(r"too slow for (\d+) frames", out)[1]), 20)

    def test_a_finger_that_is_calibrated_anew_is_followed(self):
        with tempfile.TemporaryDirectory() as folder:
            shutil.copytree(self.finger, Path(folder, "f"))
            with serving(Path(folder, "f"), self.scene) as (path, process):
                heard, revisions, dates = alltact_client.messages(str(path)), [], []
                for kind, told, _ in heard:
                    if kind == "finger":
                        dates.append(told["calibration_date"])
                        revisions.append(told["finger_revision"])
                        if len(revisions) == 1:
                            fingers.calibrate(Path(folder, "f"), fingers.flat_presses()[:3], fingers.BALL_MM,
                                              reference=fingers.flat_reference())
                    elif kind == "frame":
                        self.assertEqual(told["finger_revision"], revisions[-1])
                        if len(revisions) > 1:
                            break
                # What cannot be measured with is told, and what was there before goes on.
                (Path(folder, "f/finger.yaml")).write_text("format: alltact-finger/1\nname: broken\n")
                for kind, told, _ in heard:
                    if kind == "problem":
                        break
                self.assertIn("finger.yaml", told["problems"][0])
                kind, told, _ = next(heard)
                self.assertEqual((kind, told["finger_revision"]), ("frame", revisions[-1]))
                _, errors = stop(process)
        self.assertGreater(revisions[-1], revisions[0])
        self.assertIn("The finger has changed", errors)
        self.assertEqual(process.returncode, 0)

    def test_it_ends_with_its_source(self):
        with tempfile.TemporaryDirectory() as folder:
            for number, file in enumerate(fingers.flat_presses() * 8):
                shutil.copy(file, Path(folder, f"p{number:02}.png"))
            with serving(self.finger, folder, "--json") as (path, process):
                heard = list(alltact_client.messages(str(path), "depth16"))
                out, _ = process.communicate(timeout=60)
        self.assertEqual(heard[-1][0], "end")
        self.assertEqual(heard[-1][1]["reason"], "the source ended.")
        told = json.loads(out)
        self.assertEqual(told["frames"] + told["skipped"], 32)
        self.assertEqual(told["clients"], 1)

    def test_two_servers_are_told_apart_and_a_killed_one_is_replaced(self):
        with serving(self.finger, self.scene) as (path, first):
            frames_of(path, 1)
            second = subprocess.run([fingers.PROGRAM, "serve", self.finger, self.scene, "--socket", path], capture_output=True, text=True)
            self.assertEqual(second.returncode, 1)
            self.assertIn("another program already serves here", second.stderr)
            self.assertIn(f"process {first.pid}", second.stderr)
            first.kill()
            first.wait()
            self.assertTrue(path.exists())
            third = subprocess.Popen([fingers.PROGRAM, "serve", self.finger, self.scene, "--socket", path], text=True,
                                     stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            while "Serving" not in (line := third.stdout.readline()):
                self.assertTrue(line, third.poll())
            frames_of(path, 1)
            third.terminate()  # as a service manager ends it
            third.communicate(timeout=60)
            self.assertEqual(third.returncode, 0)
            self.assertFalse(path.exists())

    def test_what_cannot_be_served_is_said(self):
        with tempfile.TemporaryDirectory() as folder:
            shutil.copytree(self.finger, Path(folder, "f"))
            text = Path(folder, "f/finger.yaml").read_text()
            Path(folder, "f/finger.yaml").write_text(re.sub(r"(?ms)^mapping:.*?(?=^\S)", "", text))
            for arguments, words in (((Path(folder, "f"), self.scene), "not calibrated yet"),
                                     ((self.finger, Path(folder, "nowhere.mkv")), "no such file"),
                                     ((Path(folder, "g"), self.scene), "finger.yaml")):
                run = subprocess.run([fingers.PROGRAM, "serve", *arguments, "--socket", Path(folder, "own/s")], capture_output=True, text=True)
                self.assertEqual(run.returncode, 1)
                self.assertIn(words, run.stderr)
            os.chmod(folder, 0o777)
            run = subprocess.run([fingers.PROGRAM, "serve", self.finger, self.scene, "--socket", Path(folder, "s")], capture_output=True, text=True)
            self.assertIn("others may write in this folder", run.stderr)


if __name__ == "__main__":
    unittest.main()
