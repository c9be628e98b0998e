from os import PathLike
from typing import Any

from ._alltact import (Calibration as Calibration, Error as Error, Finger as Finger, Frame as Frame,
                       Reconstruction as Reconstruction, Recording as Recording, Result as Result, Scene as Scene,
                       Source as Source, Stream as Stream, Told as Told, __version__ as __version__, calibrate as calibrate,
                       depth_tiff as depth_tiff, load as load, open_source as open_source, presets as presets,
                       read_depth as read_depth, to_depth16 as to_depth16)

def read_results(path: str | PathLike[str]) -> list[Told]:
    """The frames of a results.jsonl, or of the folder that holds it."""

def read_study(path: str | PathLike[str]) -> dict[str, Any]:
    """What `alltact study -o DIR` found: DIR/study.json."""
