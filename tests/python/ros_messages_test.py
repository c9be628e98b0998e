"""The ROS 2 messages, against their definitions as ROS' common_interfaces have them; no ROS is needed."""
import math, struct, sys, time, types, unittest

import numpy as np

import fingers

sys.path.insert(0, str(fingers.TOP / "packaging/ros2/alltact_ros"))
from alltact_ros import messages

DEFINITIONS = {
    "Time": "int32 sec\nuint32 nanosec",
    "Header": "Time stamp\nstring frame_id",
    "Image": "Header header\nuint32 height\nuint32 width\nstring encoding\nuint8 is_bigendian\nuint32 step\nuint8[] data",
    "RegionOfInterest": "uint32 x_offset\nuint32 y_offset\nuint32 height\nuint32 width\nbool do_rectify",
    "CameraInfo": "Header header\nuint32 height\nuint32 width\nstring distortion_model\nfloat64[] d\nfloat64[9] k\nfloat64[9] r\n"
                  "float64[12] p\nuint32 binning_x\nuint32 binning_y\nRegionOfInterest roi",
    "PointField": "string name\nuint32 offset\nuint8 datatype\nuint32 count",
    "PointCloud2": "Header header\nuint32 height\nuint32 width\nPointField[] fields\nbool is_bigendian\nuint32 point_step\n"
                   "uint32 row_step\nuint8[] data\nbool is_dense",
    "Vector3": "float64 x\nfloat64 y\nfloat64 z",
    "Wrench": "Vector3 force\nVector3 torque",
    "WrenchStamped": "Header header\nWrench wrench",
    "KeyValue": "string key\nstring value",
    "DiagnosticStatus": "byte level\nstring name\nstring message\nstring hardware_id\nKeyValue[] values",
    "DiagnosticArray": "Header header\nDiagnosticStatus[] status",
}
RANGES = {"uint8": (0, 2**8 - 1), "uint32": (0, 2**32 - 1), "int32": (-2**31, 2**31 - 1)}
MSG = types.SimpleNamespace()


def fits(kind: str, value) -> bool:
    """As rclpy's generated classes assert it when a field is set."""
    if kind.endswith("]"):
        one, _, size = kind[:-1].partition("[")
        if one == "uint8":
            return isinstance(value, (bytes, bytearray)) or all(fits(one, part) for part in value)
        return isinstance(value, list) and (not size or len(value) == int(size)) and all(fits(one, part) for part in value)
    if kind in RANGES:
        return type(value) is int and RANGES[kind][0] <= value <= RANGES[kind][1]
    if kind == "byte":
        return isinstance(value, bytes) and len(value) == 1
    return type(value) is {"string": str, "bool": bool, "float64": float}.get(kind, getattr(MSG, kind, None))


def zero_of(kind: str):
    if kind.endswith("]"):
        one, _, size = kind[:-1].partition("[")
        return [zero_of(one) for _ in range(int(size or 0))]
    zeros = {"string": "", "bool": False, "float64": 0.0, "byte": b"\0"}
    return zeros[kind] if kind in zeros else 0 if kind in RANGES else getattr(MSG, kind)()


def made(name: str, definition: str) -> type:
    fields = {field: kind for kind, field in (line.split() for line in definition.splitlines())}

    def __init__(self):
        for field, kind in fields.items():
            setattr(self, field, zero_of(kind))

    def __setattr__(self, field, value):
        assert field in fields, f"{name} has no {field}"
        assert fits(fields[field], value), f"{name}.{field} is no {fields[field]}: {value!r}"
        object.__setattr__(self, field, value)
    return type(name, (), {"__init__": __init__, "__setattr__": __setattr__})


for each, text in DEFINITIONS.items():
    setattr(MSG, each, made(each, text))
HEAD = messages.header(MSG, 1_700_000_000_123_456_789, "left_optical")
PINHOLE = {"model": "pinhole", "size_px": [4, 2], "fx_px": 523.9, "fy_px": 524, "cx_px": 1.5, "cy_px": 0.5, "distortion": [],
           "orientation": "none"}


class Messages(unittest.TestCase):
    def test_the_stand_ins_refuse_what_ros_refuses(self):
        for name, field, wrong in (("Image", "height", -1), ("Image", "step", 2**32), ("Image", "encoding", b"mono8"),
                                   ("CameraInfo", "k", [0.0] * 8), ("CameraInfo", "d", [1]), ("Header", "stamp", 3),
                                   ("DiagnosticStatus", "level", 1), ("PointCloud2", "is_dense", 1), ("Image", "colour", "red")):
            with self.assertRaises(AssertionError):
                setattr(getattr(MSG, name)(), field, wrong)

    def test_header(self):
        self.assertEqual((HEAD.stamp.sec, HEAD.stamp.nanosec, HEAD.frame_id), (1_700_000_000, 123_456_789, "left_optical"))

    def test_image(self):
        picture = np.arange(8, dtype=np.uint8).reshape(2, 4)
        image = messages.image(MSG, HEAD, picture)
        self.assertEqual((image.height, image.width, image.encoding, image.step, image.is_bigendian), (2, 4, "mono8", 4, 0))
        self.assertEqual(bytes(image.data), bytes(range(8)))
        self.assertIs(image.header, HEAD)

    def test_camera_info(self):
        info = messages.camera_info(MSG, HEAD, PINHOLE)
        self.assertEqual((info.width, info.height, info.distortion_model), (4, 2, "plumb_bob"))
        self.assertEqual(info.d, [0.0] * 5)
        # A point at (0.1, -0.2, 1) m by the projection matrix, as sensor_msgs/CameraInfo says: (u w, v w, w) = P (x, y, z, 1).
        u, v, w = np.reshape(info.p, (3, 4)) @ [0.1, -0.2, 1, 1]
        self.assertAlmostEqual(u / w, 523.9 * 0.1 + 1.5)
        self.assertAlmostEqual(v / w, 524 * -0.2 + 0.5)
        self.assertEqual(np.reshape(info.k, (3, 3)).tolist(), np.reshape(info.p, (3, 4))[:, :3].tolist())
        self.assertEqual(np.reshape(info.r, (3, 3)).tolist(), np.eye(3).tolist())
        brown = messages.camera_info(MSG, HEAD, PINHOLE | {"model": "brown", "distortion": [0.1, -0.02]})
        self.assertEqual((brown.distortion_model, brown.d), ("plumb_bob", [0.1, -0.02, 0.0, 0.0, 0.0]))
        rational = messages.camera_info(MSG, HEAD, PINHOLE | {"model": "brown", "distortion": [0.1, 0, 0, 0, 0, 0.2]})
        self.assertEqual((rational.distortion_model, rational.d), ("rational_polynomial", [0.1, 0.0, 0.0, 0.0, 0.0, 0.2, 0.0, 0.0]))
        fisheye = messages.camera_info(MSG, HEAD, PINHOLE | {"model": "fisheye", "distortion": [0.1, 0.2, 0.3, 0.4]})
        self.assertEqual((fisheye.distortion_model, fisheye.d), ("equidistant", [0.1, 0.2, 0.3, 0.4]))

    def test_a_camera_without_a_matrix_has_no_camera_info(self):
        self.assertIsNone(messages.camera_info(MSG, HEAD, {"model": "orthographic", "size_px": [4, 2], "mm_per_px": 0.05}))
        self.assertIsNone(messages.camera_info(MSG, HEAD, PINHOLE | {"port": {"gap_mm": 1}}))

    def test_point_cloud(self):
        points = np.arange(18, dtype=np.float32).reshape(2, 3, 3)
        depth = np.array([[0.5, np.nan, 0], [1, 2, 3]], np.float32)
        points[0, 1] = np.nan
        cloud = messages.point_cloud(MSG, HEAD, points, depth)
        self.assertEqual((cloud.height, cloud.width, cloud.point_step, cloud.row_step), (2, 3, 16, 48))
        self.assertEqual(len(cloud.data), cloud.row_step * cloud.height)
        self.assertEqual([(f.name, f.offset, f.datatype, f.count) for f in cloud.fields],
                         [("x", 0, 7, 1), ("y", 4, 7, 1), ("z", 8, 7, 1), ("press_depth", 12, 7, 1)])
        self.assertFalse(cloud.is_dense or cloud.is_bigendian)
        for v in range(2):
            for u in range(3):
                there = struct.unpack_from("<4f", cloud.data, v * cloud.row_step + u * cloud.point_step)
                np.testing.assert_allclose(there, [*points[v, u] / 1000, depth[v, u] / 1000], rtol=1e-6)

    def test_wrench(self):
        wrench = messages.wrench(MSG, HEAD, {"fx_n": 1, "fy_n": -0.25}).wrench
        self.assertEqual((wrench.force.x, wrench.force.y), (1.0, -0.25))
        self.assertTrue(all(math.isnan(value) for value in (wrench.force.z, wrench.torque.x, wrench.torque.y, wrench.torque.z)))

    def test_diagnostics(self):
        array = messages.diagnostics(MSG, HEAD, "left-07", messages.WARN, "a sentence", {"frames lost": 3})
        status = array.status[0]
        self.assertEqual((status.level, status.name, status.message, status.hardware_id), (b"\1", "alltact: left-07", "a sentence", "left-07"))
        self.assertEqual([(pair.key, pair.value) for pair in status.values], [("frames lost", "3")])

    def test_state(self):
        self.assertEqual(messages.state_of({"times_ms": {}}), (messages.OK, "measuring"))
        self.assertEqual(messages.state_of({"times_ms": {}, "problems": ["a.", "b."]}), (messages.WARN, "a. b."))
        self.assertEqual(messages.state_of({"problems": ["the camera was unplugged."]})[0], messages.ERROR)

    def test_stamps_are_the_kernels(self):
        told = {"time_ns": 5_000}
        self.assertEqual(messages.stamp_ns(told, "monotonic", now_ns=1_000_000, monotonic_ns=7_000), 998_000)
        self.assertEqual(messages.stamp_ns(told, "source", 1_000_000, 7_000), 1_000_000)
        self.assertEqual(messages.stamp_ns({"time_ns": 0}, "monotonic", 1_000_000, 7_000), 1_000_000)


class FakeNode:
    """What the node asks of rclpy; keeps what is published, by topic."""

    def __init__(self, name):
        self.published = {}

    def declare_parameter(self, name, usual):
        return types.SimpleNamespace(value=self.parameters.get(name, usual))

    def create_publisher(self, kind, topic, qos):
        all_of_it = self.published.setdefault(topic, [])

        def publish(message):
            assert type(message) is kind, topic
            all_of_it.append(message)
        return types.SimpleNamespace(publish=publish)

    def get_clock(self):
        return types.SimpleNamespace(now=lambda: types.SimpleNamespace(nanoseconds=1_700_000_000_000_000_000))


def node_without_ros():
    """The node's module, with stand-ins for everything that it imports of ROS."""
    fakes = {"rclpy": dict(ok=lambda: FakeNode.is_running), "rclpy.node": dict(Node=FakeNode), "rclpy.qos": dict(qos_profile_sensor_data=10)}
    for module, names in (("sensor_msgs", "CameraInfo Image PointCloud2 PointField"), ("geometry_msgs", "WrenchStamped"),
                          ("diagnostic_msgs", "DiagnosticArray DiagnosticStatus KeyValue"), ("std_msgs", "Header")):
        fakes |= {module: {}, f"{module}.msg": {name: getattr(MSG, name) for name in names.split()}}
    for name, content in fakes.items():
        sys.modules[name] = types.ModuleType(name)
        vars(sys.modules[name]).update(content)
    from alltact_ros import node
    return node


class WithAServer(unittest.TestCase):
    def test_the_node_publishes_what_is_served_and_says_when_it_ends(self):
        import serve_test
        node = node_without_ros()
        with serve_test.serving(fingers.fin_ray(), fingers.touched_scene(serve_test.FRAMES)) as (path, process):
            FakeNode.parameters, FakeNode.is_running = {"socket": str(path), "frame_id": "left"}, True
            finger = node.Finger()
            end = time.monotonic() + 60
            while len(finger.published["~/points"]) < 3 and time.monotonic() < end:
                time.sleep(0.01)
            serve_test.stop(process)
            states = finger.published["/diagnostics"]
            while not any(state.status[0].level == messages.ERROR for state in states) and time.monotonic() < end:
                time.sleep(0.01)
            FakeNode.is_running = False
        for topic in ("~/image", "~/camera_info", "~/points"):
            self.assertGreaterEqual(len(finger.published[topic]), 3, topic)
            self.assertEqual(finger.published[topic][0].header.frame_id, "left")
        self.assertEqual(finger.published["~/wrench"], [])  # it has no force model
        self.assertEqual(states[0].status[0].name, "alltact: left-07")
        self.assertIn("stopped by hand", " ".join(state.status[0].message for state in states))

    def test_what_is_served_becomes_messages(self):
        import serve_test
        with serve_test.serving(fingers.fin_ray(), fingers.touched_scene(serve_test.FRAMES)) as (path, process):
            finger, frames = serve_test.frames_of(path, 2, "picture", "depth", "points")
            serve_test.stop(process)
        told, arrays = frames[-1]
        info = messages.camera_info(MSG, HEAD, finger["camera"])
        image = messages.image(MSG, HEAD, arrays["picture"])
        cloud = messages.point_cloud(MSG, HEAD, arrays["points"], arrays["depth"])
        self.assertEqual({(part.width, part.height) for part in (info, image, cloud)}, {(480, 270)})
        # Whatever the cloud holds lies where the camera sees it.
        values = np.frombuffer(cloud.data, "<f4").reshape(270, 480, 4)
        v, u = np.argwhere(np.isfinite(values[..., 3]))[1000]
        x, y, z, _ = values[v, u].astype(float)
        seen = np.reshape(info.p, (3, 4)) @ [x, y, z, 1]
        self.assertLess(abs(seen[0] / seen[2] - u), 30)  # the outer side of the layer, beside the ray
        self.assertLess(abs(seen[1] / seen[2] - v), 30)
        self.assertTrue(0.01 < z < 0.2)

    def test_the_package_brings_the_client(self):
        from alltact_ros import alltact_client
        self.assertTrue(callable(alltact_client.messages))


if __name__ == "__main__":
    unittest.main()
