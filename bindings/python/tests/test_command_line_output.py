# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The program gcv: that all of its output gets where it is to go, and what happens if not."""

from __future__ import annotations

import io
import os
import stat
import subprocess
import sys
import time
from pathlib import Path

import pytest
from program import PEG, folder, output, run_program, run_shell

from gcv._command_line import main

__all__ = ["folder"]
MANY = 20000
ASK = "relation a.wkt b.wkt --positions many.txt"
ANSWERS = "overlapping\n" * MANY
SUM = "POLYGON ((0 0, 9 0, 9 6, 8 7, 3.3333333333333335 2.3333333333333335, 1 7, 0 8, 0 0))\n"


@pytest.fixture
def many(folder: Path) -> Path:
    (folder / "many.txt").write_text("0 0\n" * MANY)
    return folder


@pytest.mark.parametrize("buffering", ["PYTHONUNBUFFERED=", "PYTHONUNBUFFERED=1"])
def test_output_that_is_cut_short_is_a_failure(many: Path, buffering: str) -> None:
    run = run_shell(many, f"(ulimit -f 100; {buffering} gcv {ASK} > out.txt; echo $?)")
    assert run.stdout == "gcv: standard output: File too large\n1\n"


@pytest.mark.parametrize("unbuffered", ["", "1"])
def test_output_that_does_not_block_is_whole(many: Path, unbuffered: str) -> None:
    reading, writing = os.pipe()
    os.set_blocking(writing, False)
    program = subprocess.Popen(
        [sys.executable, "-m", "gcv", *ASK.split()],
        cwd=many,
        env={**os.environ, "PYTHONUNBUFFERED": unbuffered},
        stdout=writing,
        stderr=subprocess.PIPE,
        text=True,
    )
    os.close(writing)
    time.sleep(0.5)
    with open(reading) as opened:
        assert opened.read() == ANSWERS
    _, errors = program.communicate()
    assert (errors, program.returncode) == ("", 0)


def test_output_within_python(
    folder: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(folder)
    assert main(["sum", "a.wkt", "b.wkt"]) == 0
    assert capsys.readouterr() == (SUM, "")
    for stream in (io.StringIO(), io.TextIOWrapper(io.BytesIO())):
        monkeypatch.setattr(sys, "stdout", stream)
        assert main(["sum", "a.wkt", "b.wkt"]) == 0
        stream.seek(0)
        assert stream.read() == SUM


def test_output_within_python_to_a_descriptor(
    folder: Path, capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(folder)
    print("before")
    assert main(["sum", "a.wkt", "b.wkt"]) == 0
    print("after")
    assert capfd.readouterr() == (f"before\n{SUM}after\n", "")


def test_a_file_keeps_what_it_has_where_the_disc_is_full(many: Path) -> None:
    for option in ("-o", "--svg"):
        (many / "old.txt").write_text("old")
        command = "sum many.wkt b.wkt" if option == "--svg" else ASK
        points = ", ".join(f"{k} {k * k}" for k in range(5000))
        (many / "many.wkt").write_text(f"POLYGON (({points}))")
        files = sorted(many.iterdir())
        run = run_shell(many, f"ulimit -f 100; gcv {command} {option} old.txt; echo $?")
        assert run.stdout == "gcv: old.txt: File too large\n1\n"
        assert (many / "old.txt").read_text() == "old"
        assert sorted(many.iterdir()) == files


def test_a_file_is_replaced(folder: Path) -> None:
    names = {path.name for path in folder.iterdir()}
    (folder / "old.wkt").write_text("old" * 1000)
    assert output(folder, "sum a.wkt b.wkt -o old.wkt") == ""
    assert (folder / "old.wkt").read_text() == SUM
    assert output(folder, "sum a.wkt b.wkt -o a.wkt") == ""
    assert (folder / "a.wkt").read_text() == SUM
    assert {path.name for path in folder.iterdir()} == {*names, "old.wkt"}


def test_permissions_are_kept(folder: Path) -> None:
    run_shell(folder, "umask 027; gcv sum a.wkt b.wkt -o new.wkt")
    assert stat.S_IMODE((folder / "new.wkt").stat().st_mode) == 0o640
    (folder / "old.wkt").write_text("old")
    for mode in (0o600, 0o664, 0o755):
        (folder / "old.wkt").chmod(mode)
        output(folder, "sum a.wkt b.wkt -o old.wkt")
        assert stat.S_IMODE((folder / "old.wkt").stat().st_mode) == mode


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="root may write to all")
def test_files_that_may_not_be_written_to(folder: Path) -> None:
    (folder / "old.wkt").write_text("old")
    (folder / "old.wkt").chmod(0o444)
    run = run_program(folder, *["sum", "a.wkt", "b.wkt", "-o", "old.wkt"])
    assert (run.stderr, run.returncode) == ("gcv: old.wkt: Permission denied\n", 1)
    assert (folder / "old.wkt").read_text() == "old"
    (folder / "old.wkt").chmod(0o644)
    folder.chmod(0o555)
    try:
        assert output(folder, "sum a.wkt b.wkt -o old.wkt") == ""
    finally:
        folder.chmod(0o755)
    assert (folder / "old.wkt").read_text() == SUM


def test_links_stay(folder: Path) -> None:
    (folder / "sub").mkdir()
    for target in ("sub/old.wkt", "sub/none.wkt"):
        (folder / "sub" / "old.wkt").write_text("old")
        (folder / "link").symlink_to("between")
        (folder / "between").symlink_to(target)
        output(folder, "sum a.wkt b.wkt -o link")
        assert (folder / "link").is_symlink()
        assert (folder / "between").is_symlink()
        assert (folder / target).read_text() == SUM
        (folder / "link").unlink()
        (folder / "between").unlink()
    (folder / "one.wkt").write_text("old")
    os.link(folder / "one.wkt", folder / "other.wkt")
    output(folder, "sum a.wkt b.wkt -o one.wkt")
    assert (folder / "other.wkt").read_text() == SUM
    (folder / "loop").symlink_to("loop")
    run = run_program(folder, *["sum", "a.wkt", "b.wkt", "-o", "loop"])
    assert (run.stderr, run.returncode) == (
        "gcv: loop: Too many levels of symbolic links\n",
        1,
    )


def test_what_is_no_regular_file(folder: Path) -> None:
    run = run_shell(folder, "mkfifo pipe; cat pipe & gcv sum a.wkt b.wkt -o pipe; wait; ls -l pipe")
    assert run.stdout.startswith(f"{SUM}p")
    (folder / "link").symlink_to("/dev/stdout")
    command = "{ gcv sum a.wkt b.wkt -o link; echo after >> /dev/stdout; } > out.txt; cat out.txt"
    assert run_shell(folder, command).stdout == f"{SUM}after\n"
    assert run_shell(folder, "gcv sum a.wkt b.wkt -o /dev/stdout | cat").stdout == SUM
    command = "gcv sum a.wkt b.wkt -o /dev/fd/3 3> out.txt; cat out.txt"
    assert run_shell(folder, command).stdout == SUM
    for name in ("missing/", ".", ""):
        run = run_program(folder, *["sum", "a.wkt", "b.wkt", "-o", name])
        assert run.returncode == 1
        assert run.stderr.startswith(f"gcv: {name or repr('')}: ")


def test_broken_pipe_is_quiet(folder: Path) -> None:
    run = run_shell(folder, "set -o pipefail; gcv sum two.wkt two.wkt | true; echo $?")
    assert run.stdout in ("0\n", "1\n")
    program = subprocess.Popen(
        [sys.executable, "-m", "gcv", "simplify", "-", "--tolerance", "0"],
        cwd=folder,
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    )
    assert program.stdout is not None
    program.stdout.close()
    _, errors = program.communicate(PEG.encode())
    assert (errors, program.returncode) == (b"", 1)


def test_full_disc(folder: Path) -> None:
    if not os.path.exists("/dev/full"):
        pytest.skip("there is no /dev/full: writing to a full disc is not tested")
    run = run_shell(folder, "gcv sum a.wkt b.wkt > /dev/full; echo $?")
    assert run.stdout == "gcv: standard output: No space left on device\n1\n"
    run = run_shell(folder, "gcv sum a.wkt b.wkt -o /dev/full; echo $?")
    assert run.stdout == "gcv: /dev/full: No space left on device\n1\n"
