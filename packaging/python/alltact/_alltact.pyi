from collections.abc import Callable, Iterator, Mapping, Sequence
from os import PathLike
from pathlib import Path
from types import TracebackType
from typing import Any, Literal, TypedDict

import numpy as np
from numpy.typing import NDArray

Path_ = str | PathLike[str]
Grey = NDArray[np.uint8]
Float = NDArray[np.float32]

__version__: str

class Marker(TypedDict):
    u: float
    v: float
    seen: bool

class Region(TypedDict, total=False):
    place_mm: list[float]
    place_on_face_mm: list[float]
    deepest_mm: float
    deepest_sd_mm: float
    limits: list[str]
    area_mm2: float
    volume_mm3: float
    angle_deg: float
    angle_sd_deg: float
    axis: list[float]
    normal: list[float]
    place_covariance_mm2: list[float]
    polygon_mm: list[list[float]]

class Push(TypedDict, total=False):
    touched: bool
    offset_px: list[float]
    direction: list[float]
    sd_deg: float
    face: Literal["contact", "back", "upper", "lower"]

class Contact(TypedDict, total=False):
    face: Literal["contact", "back", "upper", "lower"]
    direction: list[float]
    direction_sd_deg: float
    along_mm: float
    along_sd_mm: float
    across_mm: float
    across_sd_mm: float
    depth_mm: float
    depth_sd_mm: float
    limits: list[str]
    no_place: str
    new: bool
    held_s: float
    slipping: bool

class Force(TypedDict, total=False):
    fx_n: float
    fy_n: float
    fz_n: float
    sd_n: list[float]
    half_95_n: list[float]
    in_range: bool

class Told(TypedDict, total=False):
    """A line of results.jsonl: `alltact serve --schema` says what each key means."""
    frame: str
    index: int
    time_ns: int
    reduced_by: int
    size_px: list[int]
    face: dict[str, list[float]]
    markers: list[Marker]
    marker_method: str
    reference: dict[str, Any]
    contact: Push
    finger_contact: Contact
    validity: dict[str, float]
    regions: list[Region]
    force: Force
    times_ms: dict[str, float]
    problems: list[str]

class Error(Exception):
    """What went wrong, in a sentence that says what to try."""
    what: str
    where: str
    advice: str

class Frame:
    """One grey picture, immutable."""
    def __init__(self, grey: Grey, *, time_ns: int | None = None, name: str = "frame", sequence: int = 0) -> None:
        """Over the array's own memory: leave that as it is for as long as the frame is in use."""
    @property
    def grey(self) -> Grey:
        """uint8 [v, u], as the source gave it: not yet turned as camera["orientation"] says."""
    @property
    def name(self) -> str: ...
    @property
    def origin(self) -> str:
        """The path or device that it came from."""
    @property
    def sequence(self) -> int:
        """Counts from 0 in the source's order; gaps are lost frames."""
    @property
    def time_ns(self) -> int | None:
        """When it was taken, ns: a camera's by the monotonic clock, a video's by its own; None where the source has none."""
    @property
    def controls(self) -> str | None:
        """What camera and light were set to: "Camera=...; Gain=3"."""

class Source:
    """Frames one after the other, as an iterator. After an Error the next one may be had."""
    @property
    def is_live(self) -> bool: ...
    @property
    def is_continuous(self) -> bool:
        """Frames follow each other in time."""
    @property
    def frames_per_s(self) -> float: ...
    @property
    def count(self) -> int | None: ...
    def __iter__(self) -> Source: ...
    def __next__(self) -> Frame: ...

def open_source(inputs: Path_ | Sequence[Path_], *, live: bool = False, seed: int = 1) -> Source:
    """A camera (a name that `alltact devices` tells, or /dev/video0), a video, a scene (.yaml), pictures, or a folder of them.
    live: as it was recorded, or as a camera gives it; else as fast as it is asked for. seed: of a scene."""

class Recording:
    """Any frame of a video, or of a folder of pictures, by its number."""
    def __init__(self, path: Path_) -> None: ...
    def __len__(self) -> int: ...
    def __getitem__(self, number: int) -> Frame: ...
    @property
    def times_ns(self) -> NDArray[np.int64] | None:
        """[frame]: when each was taken, ns; None for pictures."""
    @property
    def frames_per_s(self) -> float: ...
    @property
    def is_continuous(self) -> bool: ...

class Result:
    """What a frame told. What could not be had is None, or an empty list; problems say why."""
    @property
    def frame(self) -> Frame | None:
        """None: it could not be read."""
    @property
    def line(self) -> str:
        """As it stands in results.jsonl."""
    @property
    def told(self) -> Told:
        """The line as a dict; the properties below that are dicts are parts of it."""
    @property
    def grey(self) -> Grey | None:
        """uint8 [v, u]: the picture that was measured, turned and reduced; the size of all below."""
    @property
    def depth(self) -> Float | None:
        """float32 [v, u], mm: how deep the face is pressed in along z, < 0 where skin bulges; NaN where nothing was
        measured."""
    @property
    def depth_sd(self) -> Float | None:
        """float32 [v, u], mm: one standard deviation of depth, from all causes. Made when it is asked for."""
    @property
    def limits(self) -> Grey | None:
        """uint8 [v, u], bits: 1 at the layer's thickness (depth is at least that), 2 bulging by that (at most), 4 darker than
        calibrated, 8 steep (a pixel sideways changes the depth by more than depth_sd), 16 doubtful light. Made when it is
        asked for."""
    @property
    def points(self) -> Float | None:
        """float32 [v, u, (x, y, z)], mm, camera frame: the pressed face. Made when it is asked for."""
    @property
    def flags(self) -> Grey | None:
        """uint8 [v, u]: 0 measured, 1 off the face, 2 too dark, 3 saturated, 4 darker than calibrated, 5 beyond the layer,
        6 not in the recording, 7 end hidden, 8 bulging by the layer's thickness."""
    @property
    def markers(self) -> NDArray[np.float64] | None:
        """float64 [marker, (u, v)], px."""
    @property
    def markers_seen(self) -> NDArray[np.bool_] | None:
        """bool [marker]; else estimated from the others."""
    @property
    def contact(self) -> Contact | None:
        """What touches the finger now."""
    @property
    def push(self) -> Push | None:
        """By the markers' way from rest."""
    @property
    def regions(self) -> list[Region]:
        """What presses into the face, the largest first."""
    @property
    def force(self) -> Force | None: ...
    @property
    def problems(self) -> list[str]: ...
    @property
    def times_ms(self) -> dict[str, float]:
        """By step, and "total"."""
    @property
    def finger_revision(self) -> int: ...

class Reconstruction:
    """Every frame of a source, in order. One that cannot be read or measured comes with its problems."""
    def __iter__(self) -> Reconstruction: ...
    def __next__(self) -> Result: ...

class Stream:
    """The newest frame again and again. A finger that is calibrated anew meanwhile is followed."""
    def __iter__(self) -> Stream: ...
    def __next__(self) -> Result: ...
    @property
    def skipped(self) -> int:
        """Frames that a newer one replaced."""
    def close(self) -> None: ...
    def __enter__(self) -> Stream: ...
    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None: ...

class Finger:
    """A finger as it was when it was loaded."""
    @property
    def folder(self) -> Path: ...
    @property
    def name(self) -> str: ...
    @property
    def revision(self) -> int: ...
    @property
    def is_calibrated(self) -> bool: ...
    @property
    def has_reference(self) -> bool: ...
    @property
    def marker_count(self) -> int: ...
    @property
    def camera(self) -> dict[str, Any]:
        """Of the pictures that are measured: model, size_px, fx_px, fy_px (mm_per_px), cx_px, cy_px, distortion, orientation."""
    @property
    def face(self) -> dict[str, Any]:
        """kind, width_mm or plane_z_mm, layer_mm."""
    @property
    def provenance(self) -> dict[str, str]: ...
    @property
    def settings(self) -> dict[str, str]:
        """What it measures with."""
    @property
    def warnings(self) -> list[str]: ...
    def measure(self, picture: Grey | Frame, *, time_ns: int | None = None, name: str = "") -> Result:
        """picture: uint8 [v, u] with pixels side by side, as the camera gives it; not copied. Pictures follow each other, unless
        forget() was called. time_ns: when it was taken, for how long a contact has lasted. Error: not of the camera's size."""
    def forget(self) -> None:
        """The next picture is not the neighbour of the last one in time."""
    def reconstruct(self, source: Source | Path_ | Sequence[Path_]) -> Reconstruction:
        """Every frame, to the bit as `alltact reconstruct` measures it."""
    def stream(self, source: Source | Path_ | Sequence[Path_]) -> Stream:
        """The newest frame, at the source's own pace."""

def load(folder: Path_, preset: str = "", **settings: object) -> Finger:
    """A finger's folder. preset: fast, balanced, finest, calibrated. settings: those of `alltact reconstruct --help` with '_' in
    place of '-', smoothing_px=1.5."""

class Calibration:
    """A calibration that is saved with its finger."""
    @property
    def verdict(self) -> str: ...
    @property
    def grade(self) -> Literal["good", "usable", "unproven", "unfit"]: ...
    @property
    def expected_error_mm(self) -> float:
        """Of the next press, mean absolute, inside its contact."""
    @property
    def residual_mm(self) -> float: ...
    @property
    def presses(self) -> list[dict[str, Any]]:
        """name, radius_mm, centre_mm and centre_sd_mm (camera frame), depth_mm, residual_mm, held_out_mm."""
    @property
    def left_out(self) -> list[str]: ...
    @property
    def remarks(self) -> list[str]: ...
    @property
    def warnings(self) -> list[str]: ...

def calibrate(folder: Path_, presses: Path_ | Sequence[Path_] | Sequence[Frame], ball_radius_mm: float, *,
              reference: Path_ | None = None, bursts: bool = False, operator: str = "", date: str = "",
              say: Mapping[str, Sequence[str]] = {}, progress: Callable[[float, str], object] | None = None,
              **settings: object) -> Calibration:
    """Learns depth from presses of a ball and saves it with the finger. reference: of a flat sensor, its untouched picture. say: of
    single presses as the command line says it, {"depth": ["press_2=1.2+-0.01"], "exclude": ["press_3=glove"]}. progress: is told
    what is being done and the fraction of it that is done. settings: those of `alltact calibrate --help`."""

def presets(folder: Path_) -> dict[str, dict[str, Any]]:
    """What a study kept with the finger: by name frame_ms, median_mm, p95_mm (of depth), settings."""

class Scene:
    """A simulated finger."""
    def __init__(self, path: Path_, *, seed: int = 1) -> None: ...
    @property
    def name(self) -> str: ...
    @property
    def why(self) -> str: ...
    @property
    def effects(self) -> list[str]: ...
    @property
    def frames_per_s(self) -> float: ...
    @property
    def camera(self) -> dict[str, Any]: ...
    def __len__(self) -> int: ...
    def render(self, frame: int, *, threads: int = 1) -> NDArray[Any]:
        """[v, u]: uint8 where the scene names quantisation, else float32 grey levels."""
    def truth(self, frame: int) -> dict[str, Any]:
        """What is so: depth_mm, view_z_mm, untouched_z_mm as float32 [v, u], NaN off the face; markers, balls, contacts, pose."""

def depth_tiff(depth: Float) -> bytes:
    """The file NAME.depth.tiff of `alltact reconstruct`. depth: float32 [v, u], mm."""

def to_depth16(depth: Float) -> NDArray[np.uint16]:
    """uint16 [v, u]: depth_mm = 0.001 (value - 10000), 0: none."""

def read_depth(folder: Path_, frame: str) -> Float:
    """float32 [v, u], mm: of a frame among the results of `alltact reconstruct`, from NAME.depth.tiff or NAME.depth16.png."""
