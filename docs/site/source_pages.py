# SPDX-License-Identifier: LGPL-3.0-or-later
"""Where links from the manual to files of the repository lead.

A page that the manual includes is linked as a page of the manual. A file of HTML is copied with
its folder. Any other file becomes a page with its text, and a folder a page with the names of its
files. So every link of the site works where nothing but the site is there.
"""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Iterator
from html import escape
from pathlib import Path
from typing import Any, Optional

from docutils import nodes
from sphinx.addnodes import download_reference, pending_xref
from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment
from sphinx.highlighting import PygmentsBridge

ROOT = Path(__file__).resolve().parent.parent.parent

# Pages of the repository that pages of the manual include whole.
INCLUDED = {
    "README.md": "overview",
    "NEWS.md": "news",
    "bench/README.md": "benchmarks",
    "bindings/c": "start/c",
    "bindings/c/README.md": "start/c",
    "bindings/javascript": "start/javascript",
    "bindings/javascript/README.md": "start/javascript",
    "bindings/python": "start/python",
    "bindings/python/README.md": "start/python",
    "bindings/rust": "start/rust",
    "bindings/rust/README.md": "start/rust",
}
LANGUAGES = {".c": "c", ".h": "c", ".cpp": "cpp", ".hpp": "cpp", ".py": "python", ".rs": "rust",
             ".sh": "bash", ".ts": "typescript", "": "bash"}  # fmt: skip
# Larger files, tables of results above all, are shown by their beginning.
MOST_LINES = 2000


def redirect_links(app: Sphinx, doctree: nodes.document) -> None:
    env = app.env
    for link in [*doctree.findall(pending_xref), *doctree.findall(download_reference)]:
        target, _, anchor = link["reftarget"].partition("#")
        if link.get("reftype") == "myst" and target and target not in env.found_docs:
            path = in_repository(Path(link.source or env.doc2path(env.docname)), target)
            if path is not None:
                anchor = anchor or link.get("reftargetid") or ""
                link.replace_self(new_link(env, link, path, anchor))


def in_repository(page: Path, target: str) -> Optional[Path]:
    """The path, from the root on, of what a link of a page leads to, if there is such a thing."""
    for path in ((page.parent / target).resolve(), Path(f"{target}.md")):
        if path.is_relative_to(ROOT) and path.exists():
            return path.relative_to(ROOT)
    return None


def new_link(env: BuildEnvironment, link: nodes.Element, path: Path, anchor: str) -> nodes.Element:
    children = [child.deepcopy() for child in link.children]
    if str(path) in INCLUDED:
        return pending_xref(
            "",
            *children,
            refdoc=env.docname,
            refdomain="doc",
            reftype="myst",
            reftarget=INCLUDED[str(path)],
            reftargetid=anchor or None,
            refexplicit=True,
        )
    env.metadata[env.docname].setdefault("linked", set()).add(str(path))
    up = "../" * env.docname.count("/")
    inline = nodes.reference("", "", internal=True, refuri=f"{up}{location(path)}")
    inline += [inner for child in children for inner in child.children] or children
    return inline


def location(path: Path) -> str:
    return f"source/{path}" if path.suffix == ".html" else f"source/{path}.html"


def source_pages(app: Sphinx) -> Iterator[tuple[str, dict[str, Any], str]]:
    bridge = PygmentsBridge("html")
    linked = [page.get("linked", set()) for page in app.env.metadata.values()]
    for name in sorted(set().union(*linked)):
        path = Path(name)
        if path.suffix == ".html":
            folder = Path(app.outdir, "source", path.parent)
            shutil.copytree(ROOT / path.parent, folder, dirs_exist_ok=True)
            continue
        body = names(path) if (ROOT / path).is_dir() else text(path, bridge)
        context = {"title": name, "body": f"<h1>{escape(name)}</h1>{body}", "display_toc": False}
        yield f"source/{path}", context, "page.html"


def names(folder: Path) -> str:
    """The files of the folder that the repository has, and not those of builds."""
    run = subprocess.run(
        ["git", "-C", ROOT, "ls-files", "--", folder], capture_output=True, text=True, check=True
    )
    return f"<pre>{escape(run.stdout)}</pre>"


def text(path: Path, bridge: PygmentsBridge) -> str:
    lines = (ROOT / path).read_text(encoding="utf-8").splitlines(keepends=True)
    rest = len(lines) - MOST_LINES
    shown = bridge.highlight_block("".join(lines[:MOST_LINES]), LANGUAGES.get(path.suffix, "text"))
    return shown + (f"<p>And {rest} lines more.</p>" if rest > 0 else "")


def setup(app: Sphinx) -> dict[str, bool]:
    app.connect("doctree-read", redirect_links, priority=100)  # before files to download are copied
    app.connect("html-collect-pages", source_pages)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
