# SPDX-License-Identifier: LGPL-3.0-or-later
"""Every relative link in the Markdown files of the repository leads somewhere.

A link to a file or a folder must name one that exists. A link to a heading must name one of
the headings of its page.
"""

import argparse
import pathlib
import re
import sys
import urllib.parse
from collections.abc import Iterator

from pages import pages

FENCE = re.compile(r"^ {0,3}(```|~~~).*?^ {0,3}\1", re.MULTILINE | re.DOTALL)
CODE = re.compile(r"`[^`\n]*`")
LINK = re.compile(r"\]\(\s*<?([^)\s>]+)>?(?:\s+\"[^\"]*\")?\s*\)")
REFERENCE = re.compile(r"^ {0,3}\[[^\]]+\]:\s+<?([^\s>]+)", re.MULTILINE)
HTML = re.compile(r"""<(?:a|img)\b[^>]*?\b(?:href|src)=["']([^"']+)""")
HEADING = re.compile(r"^#{1,6} +(.+?) *#*$", re.MULTILINE)
# In the manual alone: docs/site/build.sh makes these, and docs/site/check.py looks at their links.
MADE = ("docs/reference/rust", "docs/reference/javascript")
ELSEWHERE = re.compile(r"[a-z][a-z0-9+.-]*:", re.IGNORECASE)


def prose(text: str) -> str:
    """The text without its blocks of code."""
    return FENCE.sub("", text)


def links(text: str) -> Iterator[str]:
    text = CODE.sub("`", prose(text))
    for pattern in (LINK, REFERENCE, HTML):
        yield from pattern.findall(text)


def anchors(text: str) -> set[str]:
    """The names that headings get: in small letters, with hyphens for spaces."""
    found: set[str] = set()
    for heading in HEADING.findall(prose(text)):
        words = re.sub(r"\]\([^)]*\)", "", heading).lower()
        name = re.sub(r"[^\w\- ]", "", words).replace(" ", "-")
        count = 0
        while (numbered := f"{name}-{count}" if count else name) in found:
            count += 1
        found.add(numbered)
    return found


def fault(root: pathlib.Path, page: pathlib.Path, link: str) -> str:
    """What is wrong with a link of a page: nothing where it is right."""
    path, _, anchor = urllib.parse.unquote(link).partition("#")
    target = (page.parent / path).resolve() if path else page
    if path.startswith("/") or not target.is_relative_to(root):
        return "leads out of the repository"
    if any(target.is_relative_to(root / folder) for folder in MADE):
        return ""
    if not target.exists():
        return "leads to nothing"
    if anchor and (target.suffix != ".md" or anchor not in anchors(target.read_text())):
        return "leads to no heading"
    return ""


def check(root: pathlib.Path) -> tuple[int, list[str]]:
    """How many links there are, and what is wrong with them."""
    count = 0
    wrong = []
    for page in pages(root):
        for link in links(page.read_text()):
            if ELSEWHERE.match(link):
                continue
            count += 1
            if message := fault(root, page, link):
                wrong.append(f"{page.relative_to(root)}: {link} {message}")
    return count, wrong


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("root", type=pathlib.Path, help="the folder of the repository")
    root = parser.parse_args().root.resolve()
    count, wrong = check(root)
    print(*wrong, f"{count} links, {len(wrong)} of them wrong", sep="\n")
    if count == 0:
        print("no links were found, so nothing was tested")
    return int(bool(wrong) or count == 0)


if __name__ == "__main__":
    sys.exit(main())
