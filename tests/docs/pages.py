# SPDX-License-Identifier: LGPL-3.0-or-later
"""The pages of the repository, and the blocks of code in them."""

from __future__ import annotations

import pathlib
import re
import textwrap
from collections.abc import Iterator
from typing import NamedTuple, Optional

# Folders of what others make: builds, tools, and the repository's own.
SKIPPED = {"build", "venv", ".git", "target", "node_modules", "__pycache__"}

FENCE = re.compile(r"^( *)(```+)([^`\n]*)\n(.*?)^\1\2 *$", re.MULTILINE | re.DOTALL)
HEADING = re.compile(r"^#+ ", re.MULTILINE)
MARK = re.compile(r"<!-- (not run|run by):? ([^\n]+?) -->\n\Z")
PAGE_MARK = re.compile(r"^<!-- (\w+): run by ([\w.]+) -->$", re.MULTILINE)


class Block(NamedTuple):
    """A block of code."""

    page: pathlib.Path
    line: int
    language: str
    text: str
    output: Optional[str]
    """What it prints: the text of the next block of its section, if that has no language."""
    not_run: str
    """Why it is not run, as the comment before it says."""
    run_by: str
    """The test that runs it, as the comment before it or one for its page and language says."""

    @property
    def place(self) -> str:
        return f"{self.page}:{self.line}"


def pages(root: pathlib.Path) -> Iterator[pathlib.Path]:
    for file in sorted(root.iterdir()):
        if file.is_symlink() or file.name in SKIPPED:
            continue
        if file.is_dir():
            yield from pages(file)
        elif file.suffix == ".md":
            yield file


def blocks(page: pathlib.Path) -> Iterator[Block]:
    """The blocks of a page that have a language; directives of the manual have none."""
    text = page.read_text(encoding="utf-8")
    run_by = dict(PAGE_MARK.findall(text))
    fences = list(FENCE.finditer(text))
    for fence, following in zip(fences, [*fences[1:], None]):
        language = language_of(fence[3])
        if not language:
            continue
        mark = MARK.search(text, 0, fence.start())
        kind, about = mark.groups() if mark else ("", "")
        yield Block(
            page=page,
            line=text.count("\n", 0, fence.start()) + 2,
            language=language,
            text=textwrap.dedent(fence[4]),
            output=output_of(text, fence, following),
            not_run=about if kind == "not run" else "",
            run_by=about if kind == "run by" else run_by.get(language, ""),
        )


def language_of(info: str) -> str:
    """That of a fence: a cell of a notebook is `cell`, any other directive is nothing."""
    first, *_ = info.split() or [""]
    if first.startswith("{"):
        return "cell" if first == "{code-cell}" else ""
    return first


def output_of(text: str, fence: re.Match[str], following: Optional[re.Match[str]]) -> Optional[str]:
    if not following or following[3].strip():
        return None
    between = text[fence.end() : following.start()]
    return None if HEADING.search(between) else textwrap.dedent(following[4])
