# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The program gcv: wrong usage, failures, and standard streams that are not there."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from program import PEG, failure, folder, output, run_program, run_shell

__all__ = ["folder"]
AT_POSITIONS = ("relation", "a.wkt", "b.wkt", "--positions", "-")


@pytest.mark.parametrize(
    ("command", "reason"),
    [
        ("", "COMMAND"),
        ("smu a.wkt b.wkt", "smu"),
        ("a.wkt", "usage"),
        ("sum a.wkt b.wkt --rounding up", "up"),
        ("sum a.wkt b.wkt --tol 1", "--tol"),
        ("sum a.wkt b.wkt --tolerance nan", "'nan' is not a finite number"),
        ("sum a.wkt b.wkt --leave-out holes", "--leave-out takes --region"),
        ("sum a.wkt b.wkt --flatten 0", "'0' is not above 0"),
        ("sum - -", "standard input"),
        ("cast a.wkt b.wkt", "--motion"),
        ("relation a.wkt b.wkt --at 0 0 --positions table.txt", "not allowed"),
        ("relation a.wkt b.wkt --at 0 x", "'x' is not a finite number"),
        ("free a.wkt b.wkt --container a.wkt --best 1 0 --window 0 0 1 1", "--window"),
        ("free a.wkt b.wkt --container a.wkt --best 1 0 --format wkt", "--format wkt"),
        ("free a.wkt b.wkt --container a.wkt --format json", "--format json"),
        ("completion tcsh", "tcsh"),
        ("sum a.wkt b.wkt --tolerance -1", "--tolerance: '-1' is below 0"),
        ("sum a.wkt b.wkt --tolerance 1_0", "--tolerance: '1_0' is not a finite number"),
        ("sum a.wkt b.wkt --threads -2", "--threads: '-2' is not a whole number"),
        ("sum a.wkt b.wkt --threads 1_0", "--threads: '1_0' is not a whole number"),
        ("sum a.wkt b.wkt --pick-a -1", "--pick-a: '-1' is not a whole number"),
        ("sum a.wkt b.wkt --svg -", "--svg - takes -o FILE"),
        ("sum a.wkt b.wkt --svg c.svg -o ./c.svg", "--svg and -o name the same file"),
        ("relation a.wkt b.wkt --at -inf 0", "'-inf' is not a finite number"),
        ("contacts a.wkt b.wkt --distance -1", "--distance: '-1' is below 0"),
        ("contacts a.wkt b.wkt --slope -1", "--slope: '-1' is below 0"),
        ("scene-pairs a.wkt --distance -1", "--distance: '-1' is below 0"),
        ("scene-contacts a.wkt --slope -1", "--slope: '-1' is below 0"),
        ("scene-pairs - --container -", "standard input"),
        ("offset a.wkt --distance 0 --tolerance 1", "--distance: '0' is no offset"),
        ("offset a.wkt --distance 1 --tolerance 0", "--tolerance: '0' is not above 0"),
        ("free a.wkt b.wkt", "--container or --window is needed"),
        ("free a.wkt b.wkt --best 1 0", "--best takes --container"),
        ("free a.wkt b.wkt --best 1 0 --svg c.svg", "--best takes no --svg: there is no region"),
        ("free a.wkt b.wkt --container a.wkt --best 0 0", "--best 0 0 is no direction"),
        ("free a.wkt b.wkt --container a.wkt --best 1 0 --rounding outward", "--rounding"),
        ("free a.wkt b.wkt --window 5 5 1 1", "--window takes XMIN YMIN XMAX YMAX"),
        ("free a.wkt b.wkt --window 0 0 1 0", "--window takes XMIN YMIN XMAX YMAX"),
        ("simplify a.wkt --tolerance 0 --nosuch", "usage: gcv simplify "),
        (
            "simplify a.wkt --tolerance 0 --nosuch",
            "gcv simplify: error: unrecognized arguments: --nosuch",
        ),
        ("sum a.wkt b.wkt --svg a.PNG", "'a.PNG' has the name of another image than SVG\n"),
    ],
)
def test_wrong_usage(folder: Path, command: str, reason: str) -> None:
    assert reason in failure(run_program(folder, *command.split()), 2)


@pytest.mark.parametrize(
    ("command", "reason"),
    [
        ("-V", "gcv: error: unrecognized arguments: -V\n"),
        ("-1 b.wkt", "gcv: error: unrecognized arguments: -1\n"),
        ("--verison", "gcv: error: unrecognized arguments: --verison; did you mean --version?\n"),
        (
            "--treads=2 a.wkt b.wkt",
            "gcv: error: unrecognized arguments: --treads=2; did you mean --threads?\n",
        ),
        (
            "nfp a.wkt b.wkt --regoin --nosuch",
            "gcv nfp: error: unrecognized arguments: --regoin --nosuch; did you mean --region?\n",
        ),
        ("summ a.wkt b.wkt", "gcv: error: there is no command 'summ'; did you mean sum?\n"),
        ("innerfit a.wkt b.wkt", "'innerfit'; did you mean inner-fit?\n"),
        ("xyz", "gcv: error: there is no command 'xyz'; choose from sum, nfp, inner-fit, "),
        ("a.wkt --regoin", "gcv sum: error: "),
        ("-o out.wkt a.wkt", "gcv sum: error: "),
        ("-oout.wkt a.wkt", "gcv sum: error: "),
        ("--threads=2 a.wkt", "gcv sum: error: "),
        ("- -", "gcv sum: error: "),
        ("-- a.wkt", "gcv sum: error: "),
    ],
)
def test_words_that_are_misspelt(folder: Path, command: str, reason: str) -> None:
    assert reason in failure(run_program(folder, *command.split()), 2)


@pytest.mark.parametrize(
    ("command", "reason"),
    [
        ("sum a.wkt none.wkt", "gcv: none.wkt: No such file or directory"),
        ("sum a.wkt .", "gcv: .: Is a directory"),
        ("sum a.wkt b.wkt --svg no/where.svg", "gcv: no/where.svg: No such file"),
        ("sum a.wkt b.wkt -o no/where.wkt", "gcv: no/where.wkt: No such file"),
        ("sum a.wkt two.wkt --pick-b 2", "two.wkt: there is no polygon 2 in this file of 2"),
        ("free a.wkt b.wkt --container two.wkt", "two.wkt: a container is one polygon"),
        ("scene-pairs a.wkt --container two.wkt", "two.wkt: a container is one polygon"),
        ("scene-contacts none.wkt", "gcv: none.wkt: No such file or directory"),
        ("relation a.wkt b.wkt --positions a.wkt", "a.wkt: line 1: 'POLYGON"),
        ("relation two.wkt b.wkt --at 1e308 1e999", "'1e999' is not"),
    ],
)
def test_failures(folder: Path, command: str, reason: str) -> None:
    status = 2 if "1e999" in command else 1
    assert reason in failure(run_program(folder, *command.split()), status)


def test_failures_say_where(folder: Path) -> None:
    run = run_program(folder, "sum", "a.wkt", "bow tie.wkt")
    assert failure(run, 1).startswith("gcv: bow tie.wkt: polygon: edges 0 and 2")
    large = "POLYGON ((0 0, 1e308 0, 0 1e308))"
    run = run_program(folder, "sum", "-", "-", text="")
    assert run.returncode == 2
    (folder / "large.wkt").write_text(f"{PEG}\n{large}")
    run = run_program(folder, "sum", "large.wkt", "-", text=large)
    assert "large.wkt: polygon 1 and standard input: polygon: " in failure(run, 1)
    two = f"{PEG}\n{PEG}"
    run = run_program(folder, "sum", "a.wkt", "-", "--pick-b", "2", text=two)
    assert failure(run, 1) == "gcv: standard input: there is no polygon 2 in this file of 2\n"
    run = run_program(folder, "free", "a.wkt", "b.wkt", "--container", "-", text=two)
    assert failure(run, 1).startswith("gcv: standard input: a container is one polygon")
    run = run_program(folder, "distance", "large.wkt", "b.wkt", "--at", "-1.7e308", "-1.7e308")
    assert "large.wkt: polygon 0 and b.wkt: polygon: " in failure(run, 1)


def test_missing_files(folder: Path) -> None:
    for words in (["none.wkt", "b.wkt"], ["sum", "b.wkt", "none.wkt"]):
        run = run_program(folder, *words)
        assert failure(run, 1) == "gcv: none.wkt: No such file or directory\n"
    for words in (["a.wkt", ""], ["a.wkt", "b.wkt", "-o", ""], ["a.wkt", "b.wkt", "--svg", ""]):
        run = run_program(folder, "sum", *words)
        assert failure(run, 1) == "gcv: '': No such file or directory\n"


def test_closed_streams(folder: Path) -> None:
    run = run_shell(folder, "(gcv sum a.wkt b.wkt >&-); echo $?")
    assert run.stdout == "gcv: standard output: Bad file descriptor\n1\n"
    for arguments in ("a.wkt -", "a.wkt b.wkt --positions -"):
        run = run_shell(folder, f"gcv relation {arguments} <&-; echo $?")
        assert run.stdout == "gcv: standard input: Bad file descriptor\n1\n"


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="there is no /dev/full")
@pytest.mark.parametrize("words", ["--help", "--version", "sum --help", "sum a.wkt b.wkt"])
def test_a_full_disc(folder: Path, words: str) -> None:
    run = run_shell(folder, f"(gcv {words} >/dev/full); echo $?")
    assert run.stdout == "gcv: standard output: No space left on device\n1\n"


def test_standard_output_as_a_file(folder: Path) -> None:
    expected = output(folder, "sum a.wkt b.wkt")
    assert output(folder, "sum a.wkt b.wkt -o -") == expected
    assert output(folder, "sum a.wkt b.wkt --svg - -o sum.wkt").startswith("<svg")
    assert (folder / "sum.wkt").read_text() == expected
    assert not (folder / "-").exists()


@pytest.mark.parametrize("line", ["1,2", "1 2", " 1 , 2 # x", "+1\t2.e0", "1,\t.2e1"])
def test_positions_that_are_pairs(folder: Path, line: str) -> None:
    run = run_program(folder, *AT_POSITIONS, "--format", "json", text=line)
    assert '"at": [1.0, 2.0]' in run.stdout


@pytest.mark.parametrize(
    "line", ["1,,2", ", 1 2", "1 2,", "1_0 2", "1 2 3", "1", "nan 1", "1e999 1"]
)
def test_positions_that_are_none(folder: Path, line: str) -> None:
    run = run_program(folder, *AT_POSITIONS, text=f"0 0\n{line}")
    assert failure(run, 1) == (f"gcv: standard input: line 2: '{line}' is not a pair of numbers\n")
