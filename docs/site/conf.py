# SPDX-License-Identifier: LGPL-3.0-or-later
"""How Sphinx builds the manual; docs/site/build.sh calls it."""

import sys
from pathlib import Path

from docutils import nodes
from sphinx.application import Sphinx

SITE = Path(__file__).resolve().parent
ROOT = SITE.parent.parent
sys.path.insert(0, str(SITE))
sys.path.insert(0, str(ROOT / "bindings" / "python"))

import gcv  # noqa: E402

project = "libgcv"
author = "The libgcv authors"
project_copyright = f"2026 {author}"
version = release = gcv.__version__

extensions = [
    "breathe",
    "complete",
    "myst_nb",
    "source_pages",
    "sphinx.ext.autodoc",
    "sphinx_copybutton",
    "sphinx_design",
]
exclude_patterns = ["site"]
primary_domain = "c"

myst_enable_extensions = ["colon_fence"]
myst_heading_anchors = 4
nb_execution_mode = "force"
nb_execution_raise_on_error = True
nb_execution_timeout = 120

breathe_projects = {"gcv": str(ROOT / "build" / "doxygen" / "xml")}
breathe_default_project = "gcv"
breathe_domain_by_extension = {"h": "c"}
breathe_show_include = False
breathe_show_enumvalue_initializer = True

autodoc_member_order = "bysource"
autodoc_typehints = "signature"
autodoc_class_signature = "mixed"

# The prompts of examples are not copied.
copybutton_prompt_text = r">>> |\.\.\. |\$ "
copybutton_prompt_is_regexp = True

highlight_language = "none"

html_theme = "furo"
html_title = f"libgcv {release}"
html_static_path = ["static"]
html_css_files = ["manual.css"]
html_copy_source = False
html_show_sphinx = False


def strip_blocks(app: Sphinx, doctree: nodes.document) -> None:
    """Drop the empty line that ends sessions of Python, which doctest needs and readers do not."""
    for block in doctree.findall(nodes.literal_block):
        if block.rawsource == block.astext():
            block.rawsource = block.rawsource.rstrip("\n")
            block.children = [nodes.Text(block.rawsource)]


def setup(app: Sphinx) -> None:
    app.connect("doctree-read", strip_blocks)
