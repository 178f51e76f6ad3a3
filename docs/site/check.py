# SPDX-License-Identifier: LGPL-3.0-or-later
"""Every link of the built site leads somewhere, and nothing is loaded from elsewhere.

rustdoc checks its links itself, and some of them only its scripts can follow.
"""

from __future__ import annotations

import sys
from functools import cache
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

LOADED = {"img", "script", "link", "source", "iframe", "object"}


class Page(HTMLParser):
    """What a page links, what it loads, and the names in it."""

    def __init__(self, file: Path) -> None:
        super().__init__()
        self.links: set[str] = set()
        self.loads: set[str] = set()
        self.names: set[str] = set()
        self.feed(file.read_text(encoding="utf-8"))

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        for name, value in attributes:
            if name == "id" and value:
                self.names.add(value)
            if name in ("href", "src", "data") and value:
                (self.loads if tag in LOADED else self.links).add(value)


read = cache(Page)


def fault(file: Path, link: str) -> str:
    """What is wrong with a link to this site: nothing where it is right."""
    parts = urlsplit(link)
    target = (file.parent / unquote(parts.path)).resolve() if parts.path else file
    if not target.is_file():
        return "leads to nothing"
    name = unquote(parts.fragment)
    if name and target.suffix == ".html" and name not in read(target).names:
        return "leads to no such place of the page"
    return ""


def main() -> int:
    site = Path(sys.argv[1]).resolve()
    count, wrong = 0, []
    for file in sorted(site.rglob("*.html")):
        page = read(file)
        by_rustdoc = file.is_relative_to(site / "reference" / "rust")
        for link in page.loads if by_rustdoc else page.links | page.loads:
            if urlsplit(link).scheme == "data":
                continue
            message = ""
            if not (urlsplit(link).scheme or urlsplit(link).netloc):
                count += 1
                message = fault(file, link)
            elif link in page.loads:
                message = "is loaded from elsewhere"
            if message:
                wrong.append(f"{file.relative_to(site)}: {link} {message}")
    print(*wrong, f"{count} links, {len(wrong)} of them wrong", sep="\n")
    return int(bool(wrong) or count == 0)


if __name__ == "__main__":
    sys.exit(main())
