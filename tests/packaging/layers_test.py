"""The folder tree is the architecture: libraries include only what they link, and nothing leads back to itself."""

import pathlib
import re
import unittest

TOP = pathlib.Path(__file__).resolve().parents[2]
FLOORS = ("core", "calibration", "widgets", "app")
TOP_HOLDS = {*FLOORS, "resources", "translations", "tests", "packaging", "README.md", "CONTRIBUTING.md", "CHANGELOG.md",
             "LICENSE", "CMakeLists.txt", "CMakePresets.json", "build", "demo", "compile_commands.json"}
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*[<"]([^">]+)[">]', re.M)
TYPE = re.compile(r"^(?:class|struct|enum class|enum)(?: \[\[nodiscard\]\])? (\w+)(?: final)?(?: : [^;]*)? \{", re.M)


def sources_below(folder):
    return [file for file in (TOP / folder).rglob("*") if file.suffix in (".h", ".cpp")]


class Library:
    def __init__(self, folder, name, arguments):
        lists = {}
        words = None
        for word in re.sub(r"#.*", "", arguments).split():
            if word in ("SHARED", "FOLDERS", "SOURCES", "PUBLIC", "PRIVATE", "PCH", "PCH_OF"):
                words = lists.setdefault(word, [])
            else:
                words.append(word)
        self.name = name
        self.folders = [folder / each for each in lists.get("FOLDERS", ["."])]
        links = lists["PUBLIC"] + lists.get("PRIVATE", [])
        self.links = [link.removeprefix("alltact::") for link in links if link.startswith("alltact::")]


def read_libraries():
    """Name -> Library, and name -> libraries of a group (alltact::core)."""
    libraries, groups = {}, {}
    for file in ("core", "calibration", "widgets/scene3d", "widgets", "app/studio"):
        text = re.sub(r"#.*", "", (TOP / file / "CMakeLists.txt").read_text())
        for name, arguments in re.findall(r"alltact_library\(\s*(\w+)([^)]*)\)", text):
            libraries[name] = Library(TOP / file, name, arguments)
        for words in re.findall(r"alltact_libraries\(([^)]*)\)", text):
            group, *members = words.split()
            groups[group] = members
    return libraries, groups


def find_cycle(edges):
    """A list of nodes in a circle, or None. edges: node -> nodes."""
    state, path = {}, []

    def visit(node):
        state[node] = "open"
        path.append(node)
        for other in edges.get(node, ()):
            if state.get(other) == "open":
                return path[path.index(other):] + [other]
            if other not in state and (cycle := visit(other)):
                return cycle
        path.pop()
        state[node] = "closed"
        return None

    for node in edges:
        if node not in state and (cycle := visit(node)):
            return cycle
    return None


class Layers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.libraries, cls.groups = read_libraries()
        cls.owners = {folder: library.name for library in cls.libraries.values() for folder in library.folders}
        cls.files = {}  # path below the top -> its includes
        for folder in FLOORS:
            for file in sources_below(folder):
                cls.files[str(file.relative_to(TOP))] = INCLUDE.findall(file.read_text())

    def reached(self, name):
        """Every library that `name` links, itself included."""
        found, waiting = set(), [name]
        while waiting:
            name = waiting.pop()
            if name in self.groups:
                waiting += self.groups[name]
            elif name not in found:
                found.add(name)
                waiting += self.libraries[name].links
        return found

    def library_of(self, path):
        """The library whose folder holds the file most closely; None for programs."""
        if path.endswith("main.cpp"):
            return None
        for folder in (TOP / path).parents:
            if folder in self.owners:
                return self.owners[folder]
        return None

    def test_every_source_of_the_core_and_of_calibration_is_in_a_library(self):
        self.assertGreater(len(self.libraries), 20)
        for path in self.files:
            if path.startswith(("core/", "calibration/", "widgets/")):
                self.assertIsNotNone(self.library_of(path), path)

    def test_a_library_includes_only_headers_of_libraries_that_it_links(self):
        wrong = []
        for path, includes in self.files.items():
            name = self.library_of(path)
            if name is None:
                continue
            reached = self.reached(name)
            for include in includes:
                if include not in self.files:
                    continue
                other = self.library_of(include)
                if other not in reached:
                    wrong.append(f"{path} of {name} includes {include} of {other}")
        self.assertEqual(wrong, [])

    def test_every_link_is_used(self):
        for name, library in self.libraries.items():
            if name in ("studio", "widgets", "scene3d"):
                continue  # they link groups
            direct = set()
            for path, includes in self.files.items():
                if self.library_of(path) == name:
                    direct |= {self.library_of(each) for each in includes if each in self.files}
            for link in library.links:
                self.assertTrue(self.reached(link) & direct, f"{name} links {link} and includes nothing of it")

    def test_no_library_links_itself_by_way_of_others(self):
        edges = {name: library.links for name, library in self.libraries.items()}
        edges.update(self.groups)
        self.assertIsNone(find_cycle(edges))

    def test_no_header_includes_itself_by_way_of_others(self):
        edges = {path: [each for each in includes if each in self.files]
                 for path, includes in self.files.items() if path.endswith(".h")}
        self.assertIsNone(find_cycle(edges))

    def test_no_folder_includes_itself_by_way_of_others(self):
        edges = {}
        for path, includes in self.files.items():
            folder = str(pathlib.PurePath(path).parent)
            others = {str(pathlib.PurePath(each).parent) for each in includes if each in self.files}
            edges.setdefault(folder, set()).update(others - {folder})
        self.assertGreater(len(edges), 30)
        self.assertIsNone(find_cycle(edges))

    def test_the_core_and_calibration_know_no_window(self):
        for path, includes in self.files.items():
            for include in includes:
                self.assertNotRegex(include, r"^opencv2/(highgui|opencv)", path)
                # The program's own check of its numerics shares its truth with the tests.
                self.assertTrue(not include.startswith("tests/") or
                                (include.startswith("tests/hard_cases/") and path.startswith("app/commands/")), path)
                if path.startswith(("core/", "calibration/")):
                    self.assertNotRegex(include, r"^(Q[A-Z]|Qt|vtk)", path)
                if path.startswith("core/"):
                    self.assertFalse(include.startswith("ceres"), path)

    def test_no_name_stands_for_two_types(self):
        places = {}
        for folder in (*FLOORS, "tests"):
            for file in sources_below(folder):
                text = re.sub(r"^namespace \{$.*?^\}  // namespace$", "", file.read_text(), flags=re.M | re.S)
                for name in TYPE.findall(text):
                    places.setdefault(name, []).append(str(file.relative_to(TOP)))
        self.assertGreater(len(places), 300)
        self.assertEqual({name: files for name, files in places.items() if len(files) > 1}, {})

    def test_the_top_holds_only_these(self):
        self.assertEqual({each.name for each in TOP.iterdir() if each.name[0] != "."} - TOP_HOLDS, set())

    def test_measuring_links_neither_simulator_nor_devices(self):
        self.assertFalse(self.reached("sensing") & {"simulation", "devices", "stream", "gripper"})
        self.assertFalse(self.reached("fingers") & {"simulation", "devices"})

    def test_a_cycle_is_found(self):
        self.assertIsNone(find_cycle({"a": ["b", "c"], "b": ["c"], "c": []}))
        self.assertEqual(find_cycle({"a": ["b"], "b": ["c"], "c": ["b"]}), ["b", "c", "b"])


if __name__ == "__main__":
    unittest.main()
