"""The documents: their links, the paths, commands and options that they name, and what is generated from another source."""
import functools, importlib.machinery, importlib.util, re, subprocess, sys, unittest
from pathlib import Path

TOP = Path(__file__).resolve().parent.parent.parent
METAINFO = TOP / "packaging/desktop/alltact-studio.metainfo.xml.in"
MAX_README_BYTES, MAX_WORDS = 10_000, 20
PLAIN = [TOP / name for name in ("README.md", "CONTRIBUTING.md", "core/finger/README.md", "resources/help/manual.md",
                                 "tests/bench/README.md")]
BUILT = ("build/", "demo/")


def text_of(file):
    return file.read_text(encoding="utf-8")


def documents():
    return [file for file in sorted(TOP.rglob("*.md"))
            if not any(part.startswith(".") or part in ("build", "demo") for part in file.relative_to(TOP).parts)]


def without_code(text):
    text = re.sub(r"^(?: *)```.*?^(?: *)```", "", text, flags=re.S | re.M)
    return re.sub(r"`[^`\n]*`", "", text)


def prose_of(text):
    """Paragraphs and items as plain words: without code blocks, tables, headings and images."""
    text = re.sub(r"^ *```.*?^ *```", "", text, flags=re.S | re.M)
    text = re.sub(r"^(?: {4,}.*| *\|.*|#.*|!\[.*)$", "", text, flags=re.M)
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", text)
    return re.sub(r"^ *(?:-|[0-9]+\.) +", "\n\n", text, flags=re.M)


def sentences_of(text):
    for paragraph in re.split(r"\n\s*\n", prose_of(text)):
        yield from (part for part in re.split(r"(?<=[.!?])[*]*\s+", paragraph.strip()) if re.search(r"\w", part))


def manual():
    sys.dont_write_bytecode = True
    loader = importlib.machinery.SourceFileLoader("manual", str(TOP / "packaging/manual"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("manual", loader))
    loader.exec_module(module)
    return module


@functools.cache
def sources():
    """All that names an option: commands, settings, scripts."""
    files = [file for folder in ("app", "core", "calibration") for file in (TOP / folder).rglob("*.cpp")]
    files += [file for folder in ("packaging", "tests") for file in (TOP / folder).rglob("*")
              if file.is_file() and file.suffix in ("", ".py", ".sh") and "__pycache__" not in file.parts]
    return "\n".join(file.read_text(encoding="utf-8", errors="replace") for file in files)


class Readme(unittest.TestCase):
    def test_is_short(self):
        self.assertLessEqual((TOP / "README.md").stat().st_size, MAX_README_BYTES)

    def test_sentences_are_short_on_average(self):
        lengths = [len(sentence.split()) for sentence in sentences_of(text_of(TOP / "README.md"))]
        self.assertGreater(len(lengths), 30)
        self.assertLessEqual(sum(lengths) / len(lengths), MAX_WORDS)

    def test_sentences_are_counted(self):
        text = "# Not me\n\nOne two. Three *four*\nfive!\n\n    no code here\n\n- Six [seven](x.md).\n- Eight.\n\n| no | table |\n"
        self.assertEqual([len(sentence.split()) for sentence in sentences_of(text)], [2, 3, 2, 1])


class Links(unittest.TestCase):
    def test_lead_to_files_and_headings_that_exist(self):
        self.assertGreater(len(documents()), 25)
        headings = manual().slug
        for document in documents():
            for target in re.findall(r"\]\(([^)\s]+)\)", without_code(text_of(document))):
                if re.match(r"[a-z]+:", target):
                    continue
                with self.subTest(document=str(document.relative_to(TOP)), target=target):
                    file, _, anchor = target.partition("#")
                    to = (document.parent / file).resolve() if file else document
                    self.assertTrue(to.exists())
                    if anchor:
                        self.assertIn(anchor, [headings(found) for found in re.findall(r"^#+ (.*)$", text_of(to), flags=re.M)])

    def test_paths_in_code_exist(self):
        form = re.compile(r"(?<![\w./-])((?:core|calibration|widgets|app|tests|packaging|resources|translations)/[\w./*-]*)")
        found = 0
        for document in PLAIN:
            for path in form.findall(text_of(document)):
                path = path.rstrip(".")
                found += 1
                with self.subTest(document=str(document.relative_to(TOP)), path=path):
                    self.assertTrue(list(TOP.glob(path.rstrip("/"))))
        self.assertGreater(found, 60)


class Manual(unittest.TestCase):
    def test_is_one_file_whose_links_stay_within(self):
        module = manual()
        try:
            text = module.document()  # raises where an anchor is missing
        except ModuleNotFoundError:
            self.skipTest("python3-markdown is not installed")
        for page in module.PAGES:
            title = re.search(r"^# (.*)$", text_of(page), flags=re.M)[1]
            self.assertIn(f">{title}</h1>", text)
        self.assertNotIn('src="data:image/png;base64,"', text)
        self.assertNotRegex(text, r'(?:href|src)="(?!#|data:|https?:)')

    def test_has_every_command(self):
        names = re.findall(r'CommandName\{"(\w+)"', text_of(TOP / "app/console/command_names.h"))
        self.assertGreater(len(names), 15)
        table = re.search(r"## The commands\n\n(.*?)\n\n", text_of(TOP / "resources/help/manual.md"), flags=re.S)[1]
        for name in names:
            self.assertIn(f"`{name}`", table)

    def test_examples_name_commands_and_options_that_exist(self):
        names = re.findall(r'CommandName\{"(\w+)"', text_of(TOP / "app/console/command_names.h"))
        options = set()
        for document in PLAIN:
            text = text_of(document)
            for name in re.findall(r"^ +alltact ([a-z]\S*)", text, flags=re.M):
                self.assertIn(name, names)
            for line in text.splitlines():
                if re.search(r"cmake|gtest|benchmark|ffmpeg|ffprobe|sbatch", line):
                    continue  # options of other programs
                options.update(re.findall(r"(?<![\w-])--([a-z][a-z-]+)", line))
        self.assertGreater(len(options), 50)
        for option in sorted(options):
            with self.subTest(option=option):
                self.assertRegex(sources(), rf'--{option}(?![\w-])|"{option}"')


class Changelog(unittest.TestCase):
    def test_is_that_of_the_releases(self):
        made = subprocess.run([TOP / "packaging/debian/changelog-of-releases", METAINFO, "--markdown"], capture_output=True, text=True,
                              check=True).stdout
        self.assertEqual(text_of(TOP / "CHANGELOG.md"), made, "run packaging/debian/changelog-of-releases METAINFO --markdown >CHANGELOG.md")


if __name__ == "__main__":
    unittest.main()
