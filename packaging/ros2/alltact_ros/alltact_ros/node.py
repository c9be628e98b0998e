"""ros2 run alltact_ros finger --ros-args -p socket:=/run/user/1000/alltact/left-07.sock -p frame_id:=left_finger_optical

Without `socket` the first finger that is served by this user. Publishes, below its own name: image, camera_info, points, wrench; and /diagnostics. Parts that nobody subscribes to are asked for
all the same: they cost the server, not the network.
"""
import glob
import os
import threading
import time
import types

import rclpy
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus, KeyValue
from geometry_msgs.msg import WrenchStamped
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import CameraInfo, Image, PointCloud2, PointField
from std_msgs.msg import Header

from . import messages
from .alltact_client import messages as received

MSG = types.SimpleNamespace(**{kind.__name__: kind for kind in (CameraInfo, DiagnosticArray, DiagnosticStatus, Header, Image, KeyValue,
                                                                PointCloud2, PointField, WrenchStamped)})
BETWEEN_TRIES_S, BETWEEN_DIAGNOSTICS_S = 1.0, 1.0


class Finger(Node):
    def __init__(self):
        super().__init__("finger")
        served = sorted(glob.glob(os.path.join(os.environ.get("XDG_RUNTIME_DIR", ""), "alltact", "*.sock")))
        self.path = self.declare_parameter("socket", served[0] if served else "").value
        self.frame_id = self.declare_parameter("frame_id", "finger_optical").value
        self.image = self.create_publisher(Image, "~/image", qos_profile_sensor_data)
        self.camera_info = self.create_publisher(CameraInfo, "~/camera_info", qos_profile_sensor_data)
        self.points = self.create_publisher(PointCloud2, "~/points", qos_profile_sensor_data)
        self.wrench = self.create_publisher(WrenchStamped, "~/wrench", qos_profile_sensor_data)
        self.diagnostics = self.create_publisher(DiagnosticArray, "/diagnostics", 10)
        self.finger, self.frames, self.said_at = {"finger": os.path.basename(self.path)}, 0, 0.0
        threading.Thread(target=self.follow, daemon=True).start()

    def follow(self):
        while rclpy.ok():
            try:
                for kind, told, arrays in received(self.path, "picture", "depth", "points"):
                    self.take(kind, told, arrays)
            except (OSError, EOFError) as problem:
                self.say(messages.ERROR, f"{self.path}: {problem}", {})
            time.sleep(BETWEEN_TRIES_S)

    def take(self, kind, told, arrays):
        if kind == "finger":
            self.finger = told
        elif kind == "frame":
            self.publish(told, arrays)
        else:
            self.say(messages.ERROR, told.get("reason") or told.get("error") or messages.state_of(told)[1], {})

    def publish(self, told, arrays):
        self.frames += 1
        stamp = messages.stamp_ns(told, self.finger["clock"], self.get_clock().now().nanoseconds, time.monotonic_ns())
        head = messages.header(MSG, stamp, self.frame_id)
        if "picture" in arrays:
            self.image.publish(messages.image(MSG, head, arrays["picture"]))
        if camera := messages.camera_info(MSG, head, self.finger["camera"]):
            self.camera_info.publish(camera)
        if "points" in arrays:
            self.points.publish(messages.point_cloud(MSG, head, arrays["points"], arrays["depth"]))
        if "force" in told:
            self.wrench.publish(messages.wrench(MSG, head, told["force"]))
        level, sentence = messages.state_of(told)
        if level != messages.OK or time.monotonic() - self.said_at > BETWEEN_DIAGNOSTICS_S:
            self.say(level, sentence, {"frames": self.frames, "frames lost": told["lost"], "calibrated": self.finger.get("calibration_date", "?"),
                                       "ms a frame": told.get("times_ms", {}).get("total", "?")})

    def say(self, level, sentence, values):
        self.said_at = time.monotonic()
        head = messages.header(MSG, self.get_clock().now().nanoseconds, self.frame_id)
        self.diagnostics.publish(messages.diagnostics(MSG, head, self.finger["finger"], level, sentence, values))


def main():
    rclpy.init()
    try:
        rclpy.spin(Finger())
    except KeyboardInterrupt:
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
