"""Words that the sources avoid, because the field has better ones, and files that comments name. A failure names file and line."""
import pathlib
import re
import unittest

TOP = pathlib.Path(__file__).resolve().parents[2]
FOLDERS = ("core", "calibration", "widgets", "app", "packaging")

INSTEAD = {
    "told tells tell": "estimated, measured, computed (by the program); given, specified (by a person); report, show",
    "said says saying": "given, stated; report",
    "kept keeps": "cached (may be lost), saved (in a file), stored, retained",
    "lay lays laid": "warp, remap, register to",
    "way ways": "displacement, path, direction, method",
    "news": "update, updates",
    "patience": "timeout",
    "believed": "inlier_fraction, is_inlier, robust_weight",
    "looker desk": "analyser, collection",
    "dresser wear wears": "appearance, apply",
    "odd": "outlier",
    "ours theirs": "estimated, reference",
    "beside": "lateral_offset, adjacent, next to",
    "dent dented": "indentation, indented",
    "picture pictures": "image (a buffer, a file), frame (of a stream), plot",
    "place places placed": "position, pose, pixel, page",
    "sure surely": "certain, with a level",
    "touched": "in contact, has_contact",
    "wanted": "requested, required, expected",
    "whole": "full, entire, complete, integer",
    "usual": "typical, default, median",
}
BETTER = {word: better for words, better in INSTEAD.items() for word in words.split()}
# Names of others: Qt, libav, the standard library.
FOREIGN = {"PicturesLocation", "ToolButtonTextBesideIcon", "avio_tell", "in_place", "in_place_index"}

STRING = re.compile(r'R"(\w*)\((?:.|\n)*?\)\1"|"(?:\\.|[^"\\\n])*"')
IDENTIFIER = re.compile(r"[A-Za-z_]\w*")
PART = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+")


def words_of(text):
    """(line, word) of each word of the list in names and comments; strings are for users and files."""
    code = STRING.sub(lambda string: '"' + "\n" * string.group().count("\n") + '"', text)
    for number, line in enumerate(code.split("\n"), 1):
        for name in IDENTIFIER.findall(line):
            if name in FOREIGN:
                continue
            for part in PART.findall(name):
                if part.lower() in BETTER:
                    yield number, part.lower()


class Words(unittest.TestCase):
    def test_the_sources_use_the_words_of_the_field(self):
        found = []
        for folder in FOLDERS:
            for path in sorted((TOP / folder).rglob("*")):
                if path.suffix in (".h", ".cpp"):
                    for line, word in words_of(path.read_text()):
                        found.append(f"{path.relative_to(TOP)}:{line}: '{word}'; better: {BETTER[word]}")
        self.assertEqual(found, [], "\n" + "\n".join(found))

    def test_comments_name_files_that_exist(self):
        sources = [path for folder in (*FOLDERS, "tests") for path in sorted((TOP / folder).rglob("*"))]
        names = {path.name for path in sources}
        lost = [f"{path.relative_to(TOP)}:{number}: there is no {name}"
                for path in sources if path.suffix in (".h", ".cpp")
                for number, line in enumerate(path.read_text().split("\n"), 1)
                if not line.startswith("#include")
                for comment in re.findall(r"//.*", line)
                for name in re.findall(r"\b[a-z0-9_]+\.(?:h|cpp)\b", comment) if name not in names]
        self.assertEqual(lost, [], "\n" + "\n".join(lost))

    def test_names_comments_and_strings_are_told_apart(self):
        text = 'int kept_rows; // lay\nsay("told", R"x(whole\nsure)x"); foo_sureness PlacedFace in_place'
        self.assertEqual(list(words_of(text)), [(1, "kept"), (1, "lay"), (3, "placed")])


if __name__ == "__main__":
    unittest.main()
