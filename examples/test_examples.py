# SPDX-License-Identifier: LGPL-3.0-or-later
"""Tests of the examples. GCV_EXAMPLES is the folder of the built programs."""

import os
import re
import subprocess
import sys
import tempfile
import unittest
from fractions import Fraction
from pathlib import Path
from xml.etree import ElementTree

from test_cases import HERE, SVG, Bindings, TestInFolder
from test_nesting import Nesting  # noqa: F401, run from here

PROGRAMS = Path(os.environ["GCV_EXAMPLES"])
POLYGONS = HERE / "polygons"

# Every shipped polygon is in one of the pairs that belong together.
PAIRS = [
    ("comb", "hairpin"),
    ("fork_large", "fork_small"),
    ("lock", "key", "--no-fit", "0,0"),
    ("room", "robot", "--no-fit", "0,0"),
    ("coast", "islet"),
    ("shirt_front", "sleeve", "--no-fit", "195,400"),
]


# What the examples find of the wall, in C and in Python.
WALL = """\
block 10 is 0.25 deep in block 9, and is moved by (0.243902, 0.054878)
block 11 falls by 3.775, on block 8
20 pairs of blocks have contacts: 10 touch, 6 are apart by rounding, 4 overlap by rounding
71 contacts within 0.01; without a slope 10 of them are lost
19 pairs have contacts at both ends of a face; without a slope 11 keep both
"""


def run(program, *arguments):
    return subprocess.run([PROGRAMS / program, *map(str, arguments)], text=True,
                          capture_output=True, check=False, timeout=300)


def polygon(name):
    return POLYGONS / f"{name}.wkt"


def points(text):
    return [tuple(map(float, pair.split())) for pair in text.split(",")]


def rings(text):
    """The rings of the one polygon in what region writes, their last vertices left out."""
    polygons, fits = text.splitlines()
    assert fits.startswith("GEOMETRYCOLLECTION")
    match = re.fullmatch(r"MULTIPOLYGON \(\(\((.*)\)\)\)", polygons)
    closed = list(map(points, match[1].split("), (")))
    assert all(ring[0] == ring[-1] for ring in closed)
    return [ring[:-1] for ring in closed]


class Programs(unittest.TestCase):
    """The short examples check themselves."""

    def test_caller_buffer(self):
        done = run("caller_buffer")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("square + triangle: 7 vertices", done.stdout)
        self.assertEqual(done.stdout.count("do not fit"), 2)

    def test_error_handling(self):
        done = run("error_handling")
        self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)
        self.assertNotIn("GCV_OK", done.stdout)
        for line in done.stdout.splitlines():
            if "GCV_ERR" in line:
                self.assertRegex(line, r"GCV_ERR_\w+: .+")

    def test_no_fit_polygon(self):
        done = run("no_fit_polygon")
        self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)
        self.assertIn("on the sheet: 5 2\n", done.stdout)


    def test_contact(self):
        with tempfile.TemporaryDirectory() as folder:
            picture = Path(folder) / "contact.svg"
            done = run("contact", picture)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertEqual(done.stdout, f"{WALL}picture: {picture}\n")
            drawn = [path.get("class") for path in ElementTree.parse(picture).iter(f"{SVG}path")]
            self.assertEqual([drawn.count(style) for style in ("block", "pushed", "hanging")],
                             [10, 1, 1])
            # 16 of the contacts are of two vertices, and have no normal of an edge.
            circles = list(ElementTree.parse(picture).iter(f"{SVG}circle"))
            self.assertEqual((len(circles), drawn.count("normal")), (71, 55))


class Pairs(TestInFolder):
    """region on the shipped polygons."""

    def test_every_polygon_is_in_a_pair(self):
        self.assertEqual(sorted(name for pair in PAIRS for name in pair[:2]),
                         sorted(path.stem for path in POLYGONS.glob("*.wkt")))

    def check_picture(self, path, edges, segments=0, points=0):
        """Well-formed, and drawing as many edges of rings and as many fits as there are."""
        root = ElementTree.parse(path).getroot()
        self.assertEqual(root.tag, f"{SVG}svg")
        box = [float(number) for number in root.get("viewBox").split()]
        drawn = 0
        for drawing in root.iter(f"{SVG}path"):
            numbers = [float(n) for n in re.findall(r"-?\d+\.\d+", drawing.get("d"))]
            self.assertTrue(all(0 <= x <= box[2] for x in numbers[0::2]))
            self.assertTrue(all(0 <= y <= box[3] for y in numbers[1::2]))
            if "edge kind" in drawing.get("class"):
                drawn += drawing.get("d").count("L")
        self.assertEqual(drawn, edges)
        # One segment more: that of the legend.
        for tag, style, count in ("path", "segment", segments + 1), ("circle", "point", points):
            drawings = root.iter(SVG + tag)
            self.assertEqual(sum(d.get("class") == style for d in drawings), count)

    def test_pairs(self):
        for a, b, *options in PAIRS:
            with self.subTest(a=a, b=b):
                picture = self.folder / f"{a}.svg"
                done = run("region", polygon(a), polygon(b), *options, "--svg", picture)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                fits = [done.stdout.count(word) for word in ("LINESTRING", "POINT")]
                self.check_picture(picture, sum(map(len, rings(done.stdout))), *fits)

    def test_key_goes_into_the_lock(self):
        """The slit of 2^-40, the pocket behind it, and a slit from there down."""
        done = run("region", polygon("lock"), polygon("key"), "--no-fit", "0,0")
        (ring,) = rings(done.stdout)
        clearance = 2.0 ** -40
        for slit in ((14, 0), (14, clearance)), ((66, -5), (66 + clearance, -5)):
            self.assertLessEqual(set(slit), set(ring))
        self.assertLessEqual({(58, -3), (68, -3)}, set(ring))

    def test_robot_in_the_room(self):
        """The store room and the light well, the way into the dock, the place in the lift."""
        done = run("region", polygon("room"), polygon("robot"), "--no-fit", "0,0")
        self.assertEqual(done.stdout.splitlines()[1],
                         "GEOMETRYCOLLECTION (LINESTRING (75 300, 155 300), POINT (110 795))")
        _, store_room, light_well = rings(done.stdout)
        self.assertLessEqual({(775, 515), (775, 835), (1135, 835), (1135, 515)}, set(store_room))
        self.assertEqual(light_well, [(1095, 105), (1095, 275), (1135, 275), (1135, 105)])

    def test_pictures_of_any_size_and_place(self):
        for number in ("1e-320", "1e-30", "1e30", "4e307"):
            with self.subTest(number=number):
                a = self.write("a.wkt", f"POLYGON ((0 0, {number} 0, 0 {number}))")
                b = self.write("b.wkt", f"POLYGON ((0 0, -{number} 0, 0 -{number}))")
                picture = self.folder / "any.svg"
                done = run("region", a, b, "--svg", picture)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                self.check_picture(picture, 6)


class Results(TestInFolder):
    """What region writes, and where to."""

    RING = [(0, 0), (3, 0), (3, 2), (2, 3), (0, 3)]

    def setUp(self):
        super().setUp()
        self.frame = self.write("frame.wkt", "POLYGON ((0 0, 9 0, 9 4, 0 4), "
                                             "(1 1, 3 1, 3 3, 1 3), (4 1, 8 1, 8 3, 4 3))")

    def test_wkt(self):
        done = run("region", self.square, self.triangle)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(rings(done.stdout), [self.RING])

    def test_exact_fits(self):
        """The square has one place in the first hole, and a way in the second."""
        picture = self.folder / "fits.svg"
        done = run("region", self.frame, self.square, "--no-fit", "0,0", "--svg", picture)
        self.assertEqual(rings(done.stdout), [[(-2, -2), (9, -2), (9, 4), (-2, 4)]])
        self.assertEqual(done.stdout.splitlines()[1],
                         "GEOMETRYCOLLECTION (LINESTRING (4 1, 6 1), POINT (1 1))")
        drawn = {}
        for path in ElementTree.parse(picture).iter(f"{SVG}path"):
            drawn.setdefault(path.get("class"), []).append(path.get("d"))
        self.assertRegex(drawn["segment"][0], r"^M[\d.]+ ([\d.]+)L[\d.]+ \1$")
        self.assertEqual([path.count("Z") for path in drawn["a"]], [3])
        self.assertEqual(len(drawn["faint-b"]), 2)

    def test_wkt_file(self):
        path = self.folder / "sum.wkt"
        done = run("region", self.square, self.triangle, "--wkt", path)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))
        self.assertEqual(rings(path.read_text()), [self.RING])

    def test_no_fit(self):
        done = run("region", self.square, self.triangle, "--no-fit", "0,-1e0")
        self.assertEqual(rings(done.stdout), [[(-1, -1), (0, -2), (2, -2), (2, 1), (-1, 1)]])

    def test_exact(self):
        done = run("region", self.square, self.triangle, "--exact")
        lines = done.stdout.splitlines()[2:]
        self.assertEqual([tuple(map(Fraction, line.split())) for line in lines], self.RING)
        self.assertEqual(lines[1], "3/1 0/1")
        fits = run("region", self.frame, self.square, "--no-fit", "0,0", "--exact").stdout
        self.assertEqual(fits.splitlines()[-3:], ["4/1 1/1", "6/1 1/1", "1/1 1/1"])

    def test_stats(self):
        done = run("region", self.square, self.triangle, "--stats")
        self.assertEqual(done.returncode, 0)
        self.assertEqual(rings(done.stdout), [self.RING])
        self.assertIn("region      5 vertices, area 8.5, error bound 0\n", done.stderr)
        self.assertIn("inside      0 holes, 0 segments, 0 points\n", done.stderr)
        self.assertRegex(done.stderr, r"time +\d+\.\d{3} ms\n")
        self.assertRegex(done.stderr, r"walk +[1-9]\d* steps, \d+ candidate edges\n")

    def test_help(self):
        done = run("region", "--help")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        for option in ("--no-fit", "--wkt", "--svg", "--exact", "--stats", "--help"):
            self.assertIn(option, done.stdout)


class Failures(TestInFolder):
    """Exit code 1 and one line for what failed; 2 for wrong usage."""

    def assert_failure(self, done, *parts):
        self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1), done.stderr)
        for part in parts:
            self.assertIn(str(part), done.stderr)

    def test_usage(self):
        a, b = self.square, self.triangle
        for arguments in ([], [a], [a, b, a], [a, b, "--unknown"], [a, b, "--svg"], [a, b, "--wkt"],
                          [a, b, "--no-fit"], [a, b, "--no-fit", "1"], [a, b, "--no-fit", "1,"],
                          [a, b, "--no-fit", "1,2,3"], [a, b, "--no-fit", "x,y"]):
            with self.subTest(arguments=arguments):
                done = run("region", *arguments)
                self.assertEqual((done.returncode, done.stdout), (2, ""))
                self.assertIn("usage: region", done.stderr)
        for arguments in [], [a, b]:
            done = run("contact", *arguments)
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertIn("usage: contact", done.stderr)

    def test_files_that_cannot_be_read(self):
        for path in (self.folder / "missing.wkt", self.folder):
            self.assert_failure(run("region", self.square, path), path)

    def test_polygons_that_are_none(self):
        for text, status in (("nonsense", "GCV_ERR_PARSE"), ("", "GCV_ERR_PARSE"),
                             ("\0\1\2\377", "GCV_ERR_PARSE"),
                             ("POLYGON ((0 0, 2 2, 2 0, 0 2))", "GCV_ERR_NOT_SIMPLE"),
                             ("POLYGON ((0 0, 1 1, 2 2))", "GCV_ERR_DEGENERATE")):
            with self.subTest(text=text):
                bad = self.write("bad.wkt", text)
                self.assert_failure(run("region", self.square, bad), bad, f"{status}: ")
                self.assert_failure(run("region", bad, self.square), bad, f"{status}: ")

    def test_sums_that_fail(self):
        huge = self.write("huge.wkt", "POLYGON ((1e308 0, 1.7e308 0, 1e308 1e308))")
        self.assert_failure(run("region", huge, huge), huge, "GCV_ERR_RANGE: ")
        self.assert_failure(run("region", huge, self.square, "--no-fit", "nan,0"),
                            huge, self.square, "GCV_ERR_NOT_FINITE: ")

    def test_files_that_cannot_be_written(self):
        nowhere = self.folder / "no" / "file"
        for option in ("--wkt", "--svg"):
            done = run("region", self.square, self.triangle, option, nowhere)
            self.assert_failure(done, nowhere)

    @unittest.skipUnless(Path("/dev/full").exists(), "no /dev/full here")
    def test_full_disk(self):
        pair = polygon("coast"), polygon("islet")
        for option in ("--wkt", "--svg"):
            self.assert_failure(run("region", *pair, option, "/dev/full"), "/dev/full")
        self.assert_failure(run("contact", "/dev/full"), "/dev/full")
        with open("/dev/full", "w", encoding="ascii") as full:
            done = subprocess.run([PROGRAMS / "region", *pair], stdout=full, text=True,
                                  stderr=subprocess.PIPE, check=False, timeout=300)
        self.assert_failure(done, "standard output")


class Contacts(Bindings):
    def test_the_same_as_in_c(self):
        pictures = [self.folder / f"{language}.svg" for language in ("python", "c")]
        done = self.succeed(sys.executable, HERE / "contacts.py", "--svg", pictures[0])
        self.assertEqual(done.stdout, f"{WALL}picture: {pictures[0]}\n")
        self.succeed(PROGRAMS / "contact", pictures[1])
        self.assertEqual(pictures[0].read_text(), pictures[1].read_text())


class NfpDask(Bindings):
    def check(self, *arguments):
        done = self.succeed(sys.executable, HERE / "nfp_dask.py", "--check", *arguments)
        self.assertIn("100%", done.stderr)
        same, summary = done.stdout.splitlines()
        self.assertEqual(same, "the same to the bit as in one process")
        return summary

    def test_parts_of_nesting(self):
        self.assertEqual(self.check("--workers", 2),
                         "144 no-fit polygons of 12 parts, 55346.211 in area together")

    def test_parts_in_a_folder_on_a_cluster_that_runs(self):
        from dask.distributed import LocalCluster

        with LocalCluster(n_workers=1, processes=False, protocol="tcp",
                          dashboard_address=None) as cluster:
            self.assertEqual(self.check("--scheduler", cluster.scheduler_address, self.folder),
                             "4 no-fit polygons of 2 parts, 36.000 in area together")


class MotionPlanning(Bindings):
    def plan(self, *arguments):
        done = self.succeed(os.environ["CARGO"], "run", "--locked", "--example", "motion_planning",
                            "--features", "num-rational", "--", *arguments)
        return done.stdout.splitlines()

    def count(self, picture, *styles):
        return [len(self.rings(picture, style)) for style in styles]

    def test_path(self):
        picture = self.folder / "motion_planning.svg"
        *legs, last = self.plan(picture)
        self.assertEqual([leg.split(": ")[1] for leg in legs],
                         [f"{free} of the way is free"
                          for free in ("1", "1", "1", "13/18", "506/969", "1", "29/48")])
        self.assertEqual(last, f"picture: {picture}")
        self.assertEqual(self.count(picture, "room", "hole", "fit", "obstacle", "robot"),
                         [3, 1, 1, 4, 8])
        self.assertIn([(11, 17), (14, 20), (16, 19), (16, 11), (20, 11), (20, 24), (11, 24)],
                      self.rings(picture, "obstacle"))
        self.assertEqual(self.rings(picture, "fit"), [[(17, 9), (22, 9)]])

    def test_maze(self):
        picture = self.folder / "maze.svg"
        time, parts, last = self.plan("--maze", picture)
        self.assertRegex(time, r"^10000 pieces of wall, free region in \d+\.\d{3} s$")
        self.assertEqual(parts, "633 polygons, 37999 vertices, 1090 fits")
        self.assertEqual(last, f"picture: {picture}")
        self.assertEqual(self.count(picture, "room", "fit", "obstacle"), [633, 1090, 10000])


class Polygons(TestInFolder):
    def test_generator_writes_the_shipped_files(self):
        folder = self.folder / "generated"
        folder.mkdir()
        subprocess.run([sys.executable, "-B", POLYGONS / "generate.py", folder], check=True)
        shipped = {path.name: path.read_bytes() for path in POLYGONS.glob("*.wkt")}
        self.assertEqual({path.name: path.read_bytes() for path in folder.iterdir()}, shipped)


if __name__ == "__main__":
    unittest.main()
