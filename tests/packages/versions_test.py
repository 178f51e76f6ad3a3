# SPDX-License-Identifier: LGPL-3.0-or-later
"""The version is everywhere that of project(gcv VERSION ...), and NEWS.md tells of its ABI."""

import argparse
import pathlib
import re
import sys

PLACES = {
    "capi/include/gcv/gcv.h": r"GCV_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)",
    "NEWS.md": r"\A# News\n\n## ([\d.]+)\n",
    "bindings/javascript/package-lock.json": r'"name": "gcv",\n *"version": "(.*)"',
    "bindings/javascript/package.json": r'(?m)^  "version": "(.*)"',
    "bindings/python/gcv/__init__.py": r'(?m)^__version__ = "(.*)"',
    "bindings/python/pyproject.toml": r'(?m)^version = "(.*)"',
    "bindings/rust/Cargo.lock": r'name = "gcv(?:-sys)?"\nversion = "(.*)"',
    "bindings/rust/gcv-sys/Cargo.toml": r'(?m)^version = "(.*)"',
    "bindings/rust/gcv/Cargo.toml": r'(?m)^(?:gcv-sys = \{ )?version = "(.*?)"',
    "debian/changelog": r"\Agcv \((.*)-[^-]*\) ",
    "docs/gcv.1": r'(?m)^\.TH GCV 1 \S+ "gcv (.*?)"',
    "examples/web/package.json": r'(?m)^  "version": "(.*)"',
    "gcv.pc": r"(?m)^Version: (.*)$",
}
"""Where the version is, or its parts are, which then make the version."""


def versions(file: str, text: str) -> set[str]:
    found = re.findall(PLACES[file], text)
    return {".".join(found)} if file.endswith(".h") else set(found)


def complaints(version: str, texts: dict[str, str]) -> list[str]:
    found = [
        f"{file}: the version is {given or 'missing'}, not {version}"
        for file, text in texts.items()
        if (given := versions(file, text)) != {version}
    ]
    for section in re.split(r"(?m)^## ", texts["NEWS.md"])[1:]:
        if not re.search(r"(?m)^ABI: \S", section):
            found.append(f"NEWS.md: no line on the ABI of {section.splitlines()[0]}")
    return found


def controls(version: str, texts: dict[str, str]) -> dict[str, list[str]]:
    """What must be complained about: another version in any one place, and silent news."""
    changed = {}
    for file, text in texts.items():
        for match in re.finditer(PLACES[file], text):
            other = text[: match.start(1)] + "7" + text[match.end(1) :]
            changed[f"{match[0]!r} in {file}"] = complaints(version, {**texts, file: other})
    news = texts["NEWS.md"].replace("ABI:", "")
    return {
        **changed,
        "another version": complaints("7.7.7", texts),
        "news without an ABI": complaints(version, {**texts, "NEWS.md": news}),
    }


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--source", type=pathlib.Path, required=True)
    parser.add_argument("--build", type=pathlib.Path, required=True)
    parser.add_argument("--version", required=True, help="that of the project")
    options = parser.parse_args()

    texts = {
        file: ((options.build if file == "gcv.pc" else options.source) / file).read_text()
        for file in PLACES
    }
    found = complaints(options.version, texts)
    found += [
        f"not noticed: {name}"
        for name, noticed in controls(options.version, texts).items()
        if not noticed
    ]
    print(*found, sep="\n")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
