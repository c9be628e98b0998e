"""Measures with fingers that AllTact calibrated, as the command line does: pictures in, millimetres out.

    import alltact
    finger = alltact.load("left-07")
    result = finger.measure(picture)          # uint8 [v, u], as the camera gives it
    result.depth, result.points               # mm per pixel along z; x, y, z in the camera's frame

    for result in finger.stream("/dev/video0"):             # the newest frame, live
        print(result.contact, result.force)
    for result in finger.reconstruct("recording.mkv"):      # every frame, the same bytes as `alltact reconstruct`
        ...

Lengths are in mm, forces in N, times in ns of the clock that stamped the picture. The camera's frame: x along u, y along v, z
away from the camera; the centre of the top-left pixel is (0, 0). Arrays are [v, u], share their memory with what made them and
are read-only: copy() one to change it. Where nothing was measured, depth, points and depth_sd are NaN. What goes wrong is an
alltact.Error whose sentence says what to try. Measuring lets other threads of Python run.
"""
import json as _json
import pathlib as _pathlib

from ._alltact import (Calibration, Error, Finger, Frame, Reconstruction, Recording, Result, Scene, Source, Stream,
                       __version__, calibrate, depth_tiff, load, open_source, presets, read_depth, to_depth16)

__all__ = ["Calibration", "Error", "Finger", "Frame", "Reconstruction", "Recording", "Result", "Scene", "Source", "Stream",
           "calibrate", "depth_tiff", "load", "open_source", "presets", "read_depth", "read_results", "read_study", "to_depth16"]

Error.__module__ = "alltact"


def _read(path, parse):
    try:
        return parse(_pathlib.Path(path).read_text(encoding="utf-8"))
    except (OSError, ValueError) as problem:
        raise Error(f"{path}: {problem}.") from problem


def read_results(path):
    """The frames of a results.jsonl, or of the folder that holds it: a list with a dict for each, keys with their units."""
    path = _pathlib.Path(path)
    return _read(path / "results.jsonl" if path.is_dir() else path, lambda text: [_json.loads(line) for line in text.splitlines()])


def read_study(path):
    """What `alltact study -o DIR` found: DIR/study.json as a dict, errors in mm, times in ms."""
    path = _pathlib.Path(path)
    return _read(path / "study.json" if path.is_dir() else path, _json.loads)
