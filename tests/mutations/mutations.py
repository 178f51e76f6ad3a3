# SPDX-License-Identifier: LGPL-3.0-or-later
"""Breaks the library in many places, one at a time, and tells which breaks no test finds.

All is done in a copy of the project in build/mutations. A line in results.txt for each mutant keeps
what became of it, so that a run that was ended goes on where it was. Compiling is quicker with
CMAKE_CXX_COMPILER_LAUNCHER=ccache and CMAKE_C_COMPILER_LAUNCHER=ccache in the environment.
"""

import argparse
import collections
import dataclasses
import fcntl
import fnmatch
import hashlib
import json
import os
import pathlib
import re
import resource
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Iterable

from mutants import Mutant, all_mutants

PROJECT = pathlib.Path(__file__).resolve().parents[2]
FOLDER = PROJECT / "build" / "mutations"
TREE = FOLDER / "tree"
BUILD = FOLDER / "build"
RESULTS = FOLDER / "results.txt"
EQUIVALENT = pathlib.Path(__file__).with_name("equivalent.txt")

ROOMS = ("exact", "sum", "search", "rounding")
MORE_ROOMS = ("superset", "contact", "scene")
COPIED = (
    *("CMakeLists.txt", "bench", "bindings", "capi", "cpp", "pkgconfig", "tests"),
    ":(exclude)tests/mutations",  # else baselines would be taken anew for one more reason
)
TESTS = r"^(hard\.digest|core\.|capi\.|fuzz\.)"
CMAKE = (
    *("-G", "Ninja", "-DCMAKE_BUILD_TYPE=RelWithDebInfo"),
    *("-DCMAKE_CXX_FLAGS_RELWITHDEBINFO=-O1", "-DCMAKE_C_FLAGS_RELWITHDEBINFO=-O1"),
    *("-DGCV_UNITY=OFF", "-DGCV_HARDENING=OFF", "-DGCV_BUILD_EXAMPLES=OFF"),
    *("-DGCV_BINDINGS_TESTS=OFF", "-DGCV_PACKAGE_TESTS=OFF"),
)
MEMORY = 4 << 30
LONGEST_BUILD = 3600.0

FOUND = "found by "
TOO_LONG = " (time limit)"
SURVIVED = "survived"
NO_CODE = "does not compile"
SAME = "the same code"
KNOWN = "equivalent"

Counts = collections.Counter[str]


@dataclasses.dataclass(frozen=True)
class Test:
    name: str
    command: tuple[str, ...]
    environment: tuple[tuple[str, str], ...]

    @property
    def target(self) -> str:
        return str(pathlib.Path(self.command[0]).relative_to(BUILD))


@dataclasses.dataclass(frozen=True)
class Run:
    status: int
    seconds: float  # of the processor


def copy_tree() -> None:
    """Makes the copy equal to the project, and leaves files alone that are so."""
    listed = subprocess.run(
        ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard", *COPIED],
        cwd=PROJECT, check=True, capture_output=True, text=True,
    )  # fmt: skip
    names = {name for name in listed.stdout.split("\0") if (PROJECT / name).is_file() and name}
    for old in [file for file in TREE.rglob("*") if file.is_file()]:
        if str(old.relative_to(TREE)) not in names:
            old.unlink()
    for name in names:
        source, copy = PROJECT / name, TREE / name
        if not copy.exists() or copy.read_bytes() != source.read_bytes():
            copy.parent.mkdir(parents=True, exist_ok=True)
            copy.write_bytes(source.read_bytes())
            copy.chmod(source.stat().st_mode)


def digest(files: list[pathlib.Path]) -> str:
    return hashlib.sha256(b"".join(file.read_bytes() for file in sorted(files))).hexdigest()


def build(targets: list[str], jobs: int) -> bool:
    with (FOLDER / "build.log").open("w") as log:
        try:
            return (
                subprocess.run(
                    ["ninja", "-C", BUILD, "-j", str(jobs), *targets],
                    stdout=log, stderr=log, timeout=LONGEST_BUILD, check=False,
                ).returncode
                == 0
            )  # fmt: skip
        except subprocess.TimeoutExpired:
            return False


def programs(pattern: str) -> list[str]:
    """The targets of these tests. ctest shows no commands of programs that are not there yet."""
    added = re.compile(r'^add_test\(\[=\[(.*?)\]=\] "(.*?)"', re.MULTILINE)
    found = set()
    for file in BUILD.rglob("CTestTestfile.cmake"):
        for name, program in added.findall(file.read_text()):
            if program.startswith(f"{BUILD}/") and re.search(pattern, name):
                found.add(str(pathlib.Path(program).relative_to(BUILD)))
    return sorted(found)


def all_tests(pattern: str) -> list[Test]:
    """Programs of the build that ctest runs."""
    shown = subprocess.run(
        ["ctest", "--test-dir", BUILD, "--show-only=json-v1"],
        check=True, capture_output=True, text=True,
    )  # fmt: skip
    tests = []
    for test in json.loads(shown.stdout)["tests"]:
        command = test.get("command", [])
        properties = {entry["name"]: entry["value"] for entry in test["properties"]}
        if not command or not command[0].startswith(f"{BUILD}/") or "DISABLED" in properties:
            continue
        if re.search(pattern, test["name"]):
            variables = properties.get("ENVIRONMENT", [])
            pairs = tuple((name, value) for name, _, value in (v.partition("=") for v in variables))
            tests.append(Test(test["name"], tuple(command), pairs))
    return tests


def run(test: Test, limit: float) -> Run:
    """Runs a test for so many seconds of the processor, and for many more by the clock.

    In a group of processes of its own, but no session: that would lose the niceness.
    """

    def set_limits() -> None:
        os.setpgid(0, 0)
        seconds = int(limit) + 1
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1))
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    process = subprocess.Popen(
        test.command, cwd=BUILD, env={**os.environ, **dict(test.environment)},
        stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
        preexec_fn=set_limits,
    )  # fmt: skip
    try:
        status = process.wait(600 + 100 * limit)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()
        status = -signal.SIGXCPU
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return Run(status, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)


def baseline(tests: list[Test]) -> dict[str, Run]:
    """What each test does without a change, kept for as long as the sources are the same."""
    kept = FOLDER / "baseline.json"
    sources = digest([file for file in TREE.rglob("*") if file.is_file()])
    known: dict[str, Run] = {}
    if kept.exists():
        stored = json.loads(kept.read_text())
        if stored["sources"] == sources:
            known = {name: Run(*values) for name, values in stored["runs"].items()}
    for test in tests:
        if test.name not in known:
            known[test.name] = run(test, 3600)
            if known[test.name].status not in (0, 77):
                sys.exit(f"{test.name} fails without a change")
            runs = {name: dataclasses.astuple(one) for name, one in known.items()}
            kept.write_text(json.dumps({"sources": sources, "runs": runs}))
    return known


def ordered(tests: list[Test], known: dict[str, Run], found: Counts, file: str) -> list[Test]:
    """That of the file, then those that have found most for their time, with a second to link."""
    stem = pathlib.Path(file).stem

    def key(test: Test) -> tuple[bool, float]:
        own = test.name.split(".")[1].removesuffix("_test") == stem
        return not own, (known[test.name].seconds + 1) / (found[test.name] + 1)

    return sorted(tests, key=key)


def finders(outcomes: Iterable[str]) -> Counts:
    """How many mutants each test has found."""
    return Counts(
        what[len(FOUND) :].removesuffix(TOO_LONG) for what in outcomes if what.startswith(FOUND)
    )


def outcome(tests: list[Test], known: dict[str, Run], code: str, jobs: int) -> str:
    """What becomes of a mutant whose file has been written."""
    if not build(["gcv"], jobs):
        return NO_CODE
    if library_code() == code:
        return SAME
    for k, test in enumerate(tests):
        if k & (k - 1) == 0 and not build([one.target for one in tests[k : 2 * k + 1]], jobs):
            return NO_CODE  # k is 0 or a power of two: more and more are built at once
        limit = 5 * known[test.name].seconds + 5
        now = run(test, limit)
        if now.status in (-signal.SIGINT, -signal.SIGTERM):
            sys.exit(f"{test.name} was ended by someone else")
        if now.status != known[test.name].status:
            too_long = now.status in (-signal.SIGXCPU, -signal.SIGKILL)
            return FOUND + test.name + (TOO_LONG if too_long else "")
    return SURVIVED


def library_code() -> str:
    return digest([(BUILD / "capi" / "libgcv.so").resolve()])


def read_equivalents() -> set[tuple[str, ...]]:
    """Each is the file, and the lines that the difference takes away and adds."""
    if not EQUIVALENT.exists():
        return set()
    blocks = EQUIVALENT.read_text().split("\n\n")
    found = set()
    for block in blocks:
        lines = [line for line in block.splitlines() if line and line[0] != "#"]
        if lines:
            change = [line for line in lines[1:] if line[0] in "-+"]
            code = {line.strip() for line in (PROJECT / lines[0]).read_text().splitlines()}
            for line in change:
                if line[0] == "-" and line[1:].strip() not in code:
                    sys.exit(f"{EQUIVALENT.name} names a line that is not in {lines[0]}: {line}")
            found.add((lines[0], *change))
    return found


def read_results() -> dict[str, tuple[str, float]]:
    """By place and change: the last outcome, and how long it took by the clock."""
    results = {}
    if RESULTS.exists():
        for line in RESULTS.read_text().splitlines():
            _, place, change, what, seconds = line.split("\t")
            results[f"{place}\t{change}"] = (what, float(seconds))
    return results


def key_of(mutant: Mutant) -> str:
    return f"{mutant.place}\t{mutant.change}"


def summary(mutants: list[Mutant], results: dict[str, tuple[str, float]]) -> str:
    """The page of results in Markdown."""
    done = [(k, m, results[key_of(m)]) for k, m in enumerate(mutants, 1) if key_of(m) in results]
    kinds = ("found", SURVIVED, KNOWN, SAME, NO_CODE)

    def kind(what: str) -> str:
        return "found" if what.startswith(FOUND) else what

    def row(title: str, part: list[str]) -> str:
        counts = collections.Counter(kind(what) for what in part)
        counted = counts["found"] + counts[SURVIVED]
        score = f"{100 * counts['found'] / counted:.1f} %" if counted else ""
        cells = [title, str(len(part)), *(str(counts[one]) for one in kinds), score]
        return f"| {' | '.join(cells)} |"

    rooms: dict[str, list[str]] = collections.defaultdict(list)
    for _, mutant, (what, _) in done:
        rooms[mutant.file.split("/")[1]].append(what)
    lines = ["# Mutations", "", f"| room | mutants | {' | '.join(kinds)} | score |"]
    lines += ["| --- |" + " --- |" * (len(kinds) + 2)]
    lines += [row(room, rooms[room]) for room in sorted(rooms)]
    lines += [row("all", [what for _, _, (what, _) in done]), ""]
    found = finders(what for _, _, (what, _) in done)
    lines += ["| found by | mutants |", "| --- | --- |"]
    lines += [f"| {name} | {count} |" for name, count in found.most_common()]
    lines += ["", "Survivors:", ""]
    for k, mutant, (what, _) in done:
        if what == SURVIVED:
            lines.append(f"- [{k}](diffs/{k}.diff): {mutant.place}, `{mutant.change}`")
    return "\n".join(lines) + "\n"


def options_of_command_line() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="tests/mutations/run",
        description="Breaks the library in many places, one at a time, and tells which breaks "
        "no test finds. All is kept in build/mutations: results.txt, index.md, and a difference "
        "for each survivor. A second run goes on where the first one was ended.",
    )
    parser.add_argument("count", type=int, nargs="?", help="how many mutants; all without it")
    parser.add_argument("--seed", type=int, default=1, help="of their order; 1 without it")
    parser.add_argument(
        "--all-rooms", action="store_true", help=f"break {', '.join(MORE_ROOMS)} too"
    )
    parser.add_argument("--files", default="*", metavar="PATTERN", help="such as cpp/sum/*.cpp")
    parser.add_argument("--tests", default=TESTS, metavar="REGEX", help=f"{TESTS} without it")
    parser.add_argument("--again", action="store_true", help="run survivors again")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, help="of a build")
    parser.add_argument("--list", action="store_true", help="print the mutants alone")
    return parser.parse_args()


def main() -> None:
    options = options_of_command_line()
    rooms = ROOMS + (MORE_ROOMS if options.all_rooms else ())
    mutants = [
        mutant
        for mutant in all_mutants(PROJECT, rooms, options.seed)
        if fnmatch.fnmatch(mutant.file, options.files)
    ][: options.count]
    equivalents = read_equivalents()
    if options.list:
        for k, mutant in enumerate(mutants, 1):
            print(k, mutant.place, mutant.change, sep="\t")
        return
    signal.signal(signal.SIGTERM, lambda *_: sys.exit("ended"))
    TREE.mkdir(parents=True, exist_ok=True)
    lock = (FOLDER / "lock").open("w")
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        sys.exit(f"another run is at work in {FOLDER}")
    copy_tree()
    subprocess.run(
        ["cmake", "-S", TREE, "-B", BUILD, *CMAKE], check=True, stdout=subprocess.DEVNULL
    )
    if not build(["gcv", *programs(options.tests)], options.jobs):
        sys.exit(f"the project does not compile: {FOLDER / 'build.log'}")
    tests = all_tests(options.tests)
    if not tests:
        sys.exit(f"no test is called {options.tests}")
    known = baseline(tests)
    code = library_code()
    results = read_results()
    shutil.rmtree(FOLDER / "diffs", ignore_errors=True)
    (FOLDER / "diffs").mkdir()
    for k, mutant in enumerate(mutants, 1):
        copy = TREE / mutant.file
        text = copy.read_text()
        before = results.get(key_of(mutant))
        is_known = (mutant.file, *mutant.changed_lines(text)) in equivalents
        is_old = before is not None and (
            before[0] != KNOWN if is_known else before[0] == SURVIVED and options.again
        )
        if before is None or is_old:
            begin = time.monotonic()
            what = KNOWN
            if not is_known:
                copy.write_text(mutant.applied(text))
                try:
                    found = finders(what for what, _ in results.values())
                    order = ordered(tests, known, found, mutant.file)
                    what = outcome(order, known, code, options.jobs)
                finally:
                    copy.write_text(text)
            before = (what, time.monotonic() - begin)
            results[key_of(mutant)] = before
            with RESULTS.open("a") as file:
                print(k, key_of(mutant), what, f"{before[1]:.0f}", sep="\t", file=file)
            print(f"{k}/{len(mutants)} {mutant.place} {mutant.change}: {what}", flush=True)
        if before[0] == SURVIVED:
            (FOLDER / "diffs" / f"{k}.diff").write_text(mutant.difference(text))
        (FOLDER / "index.md").write_text(summary(mutants[:k], results))
    print((FOLDER / "index.md").read_text(), end="")


if __name__ == "__main__":
    main()
