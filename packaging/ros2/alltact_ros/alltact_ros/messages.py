"""ROS 2 messages from what `alltact serve` sends; knows no ROS: `msg` holds the messages' classes by their names.

Lengths become metres and stay in the camera's frame, which is ROS' optical frame (x right, y down, z forward). What was not
measured is NaN, never zero.
"""
import math

import numpy as np

OK, WARN, ERROR, STALE = (bytes([level]) for level in range(4))  # diagnostic_msgs/DiagnosticStatus
FLOAT32 = 7  # sensor_msgs/PointField
COUNTS = {"pinhole": (5,), "brown": (5, 8, 12), "fisheye": (4,)}  # of coefficients, as OpenCV permits


def header(msg, stamp_ns: int, frame_id: str):
    made = msg.Header()
    made.stamp.sec, made.stamp.nanosec = divmod(stamp_ns, 1_000_000_000)
    made.frame_id = frame_id
    return made


def image(msg, head, picture: np.ndarray):
    """sensor_msgs/Image, mono8. picture: uint8 [v, u]."""
    made = msg.Image()
    made.header = head
    made.height, made.width = picture.shape
    made.encoding, made.is_bigendian, made.step = "mono8", 0, picture.shape[1]
    made.data = picture.tobytes()
    return made


def camera_info(msg, head, camera: dict):
    """sensor_msgs/CameraInfo of the finger message's camera; None where a camera matrix cannot say what the camera does."""
    if camera["model"] not in COUNTS or "port" in camera:
        return None
    terms = next(count for count in COUNTS[camera["model"]] if count >= len(camera["distortion"]))
    fx, fy, cx, cy = (float(camera[key]) for key in ("fx_px", "fy_px", "cx_px", "cy_px"))
    made = msg.CameraInfo()
    made.header = head
    made.width, made.height = camera["size_px"]
    made.distortion_model = {4: "equidistant", 5: "plumb_bob"}.get(terms, "rational_polynomial")
    made.d = [float(term) for term in camera["distortion"]] + [0.0] * (terms - len(camera["distortion"]))
    made.k = [fx, 0.0, cx, 0.0, fy, cy, 0.0, 0.0, 1.0]
    made.r = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]
    made.p = [fx, 0.0, cx, 0.0, 0.0, fy, cy, 0.0, 0.0, 0.0, 1.0, 0.0]
    return made


def point_cloud(msg, head, points_mm: np.ndarray, depth_mm: np.ndarray):
    """sensor_msgs/PointCloud2, a point for each pixel: x, y, z of the pressed face and press_depth, m; NaN where there is none.
    points_mm: float32 [v, u, (x, y, z)]; depth_mm: float32 [v, u]."""
    rows, columns = depth_mm.shape
    values = np.empty((rows, columns, 4), "<f4")
    values[..., :3], values[..., 3] = points_mm, depth_mm
    values *= np.float32(0.001)
    made = msg.PointCloud2()
    made.header = head
    made.height, made.width = rows, columns
    for place, name in enumerate(("x", "y", "z", "press_depth")):
        field = msg.PointField()
        field.name, field.offset, field.datatype, field.count = name, 4 * place, FLOAT32, 1
        made.fields.append(field)
    made.is_bigendian, made.is_dense = False, False
    made.point_step, made.row_step = 16, 16 * columns
    made.data = values.tobytes()
    return made


def wrench(msg, head, force: dict):
    """geometry_msgs/WrenchStamped, N, in the axes that the finger's force model was trained in; what it does not tell is NaN."""
    made = msg.WrenchStamped()
    made.header = head
    for axis in "xyz":
        setattr(made.wrench.force, axis, float(force.get(f"f{axis}_n", math.nan)))
        setattr(made.wrench.torque, axis, math.nan)
    return made


def diagnostics(msg, head, finger: str, level: bytes, sentence: str, values: dict):
    """diagnostic_msgs/DiagnosticArray with one status."""
    status = msg.DiagnosticStatus()
    status.level, status.name, status.message, status.hardware_id = level, f"alltact: {finger}", sentence, finger
    for key, value in values.items():
        pair = msg.KeyValue()
        pair.key, pair.value = key, str(value)
        status.values.append(pair)
    made = msg.DiagnosticArray()
    made.header = head
    made.status.append(status)
    return made


def state_of(told: dict) -> tuple[bytes, str]:
    """Level and sentence of what a frame or problem message tells."""
    problems = told.get("problems", [])
    if not problems:
        return OK, "measuring"
    return (WARN if "times_ms" in told else ERROR), " ".join(problems)


def stamp_ns(told: dict, clock: str, now_ns: int, monotonic_ns: int) -> int:
    """When a frame was taken by the wall clock that says now_ns; now, where the server does not know."""
    if clock != "monotonic" or told["time_ns"] == 0:
        return now_ns
    return now_ns - (monotonic_ns - told["time_ns"])
