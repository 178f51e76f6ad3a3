# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""What SVG drawings say, checked before svgelements reads them.

It takes what is missing or wrong for something else, without a word.
"""

from __future__ import annotations

import math
import re
from collections import Counter
from collections.abc import Iterator
from typing import NamedTuple, Optional
from xml.etree.ElementTree import Element

from ._named import NUMBER, invalid

_COUNTS = {"Z": 0, "H": 1, "V": 1, "M": 2, "L": 2, "T": 2, "Q": 4, "S": 4, "C": 6, "A": 7}
"""How many numbers each command of path data takes."""
_LENGTHS = {
    "rect": ("x", "y", "width", "height", "rx", "ry"),
    "circle": ("cx", "cy", "r"),
    "ellipse": ("cx", "cy", "rx", "ry"),
    "use": ("x", "y"),
    "svg": ("x", "y", "width", "height"),
}
_SIZES = {"rect": ("width", "height"), "circle": ("r",), "ellipse": ("rx", "ry")}
"""Without one of these, nothing is drawn."""
_LENGTH = re.compile(rf"\s*({NUMBER})(|%|px|pt|pc|mm|cm|in)\s*")
_TRANSFORMS = {
    "matrix": (6,),
    "translate": (1, 2),
    "scale": (1, 2),
    "rotate": (1, 3),
    "skewx": (1,),
    "skewy": (1,),
}
"""How many numbers each transform takes."""
_TRANSFORM = re.compile(r"[\s,]*([A-Za-z]+)\s*\(([^()]*)\)[\s,]*")
_USED_ONLY = {"clipPath", "defs", "marker", "mask", "pattern", "symbol"}
_HIDDEN = _USED_ONLY - {"clipPath", "defs"}
"""What svgelements draws although it is there to be used."""
_HREFS = ("href", "{http://www.w3.org/1999/xlink}href")

Box = Optional[tuple[float, float]]
"""The width and the height of what percentages are of; None where no viewBox says them."""


class _Place(NamedTuple):
    """An element, and where it is."""

    element: Element
    box: Box
    is_drawn: bool


def check(root: Element, file: str, left_out: Counter[str]) -> None:
    """Check a drawing, and put all of it into numbers.

    What draws nothing is counted in left_out. Raises InputError for what is not SVG.
    """
    if tag(root)[1] != "svg":
        raise invalid(file, f"SVG: this is a drawing of '{tag(root)[1]}', not of 'svg'")
    places = list(_places(root, file))
    identifiers = {element.get("id") for element, _, _ in places}
    for element, box, is_drawn in places:
        _, kind = tag(element)
        name = name_of(file, kind, element.get("id"))
        _check_transform(element.get("transform", ""), name)
        if kind == "path":
            element.set("d", element.get("d", ""))
            _check_path_data(element.get("d", ""), name)
        elif kind in ("polygon", "polyline") and not _is_numbers(element.get("points", ""), 2):
            raise invalid(name, "the points are not pairs of numbers")
        if element is not root:
            _check_lengths(element, kind, box, name)
            if kind == "svg":
                _place_drawing(element, box, name)
        is_empty = any(float(element.get(size, "0")) == 0 for size in _SIZES.get(kind, ()))
        if kind == "use":
            target = next(filter(None, map(element.get, _HREFS)), "")
            is_empty = target[1:] not in identifiers
        left_out[kind] += is_drawn and is_empty
        _hide_what_is_not_drawn(element)


def name_of(file: str, kind: str, identifier: Optional[str]) -> str:
    """What a message calls an element."""
    return f"{file}: {kind} '{identifier}'" if identifier else f"{file}: {kind}"


def tag(element: Element) -> tuple[str, str]:
    """The name space of an element and its kind."""
    space, brace, kind = str(element.tag).rpartition("}")
    return space + brace, kind


def _places(root: Element, file: str) -> Iterator[_Place]:
    """All elements, each before those in it."""
    todo = [_Place(root, None, True)]
    while todo:
        element, around, was_drawn = todo.pop()
        _, kind = tag(element)
        is_drawn = was_drawn and kind not in _USED_ONLY and element.get("display") != "none"
        yield _Place(element, around, is_drawn)
        inside = _view_box(element, file) if kind == "svg" else around
        todo += [_Place(child, inside, is_drawn) for child in reversed(element)]


def _view_box(element: Element, file: str) -> Box:
    text = element.get("viewBox")
    if text is None:
        return None
    numbers = re.findall(NUMBER, text)
    if len(numbers) != 4 or not _is_numbers(text, 4):
        raise invalid(file, f"SVG: the viewBox {text!r} is not four numbers")
    return float(numbers[2]), float(numbers[3])


def _check_lengths(element: Element, kind: str, box: Box, name: str) -> None:
    """Write the lengths of an element as numbers, those that are missing too."""
    if kind == "ellipse":
        for radius, other in (("rx", "ry"), ("ry", "rx")):
            if element.get(radius, "auto") == "auto" and element.get(other, "auto") != "auto":
                element.set(radius, element.get(other, "0"))
    for attribute in _LENGTHS.get(kind, ()):
        text = element.get(attribute, "auto").strip()
        if text != "auto":
            value = _length(text, attribute, box, name)
            if value < 0 and attribute not in ("x", "y", "cx", "cy"):
                raise invalid(name, f"{attribute} is {text}, and below 0")
            element.set(attribute, repr(value))
        elif attribute in _SIZES.get(kind, ()):
            element.set(attribute, "0")
        else:
            element.attrib.pop(attribute, None)


def _place_drawing(element: Element, box: Box, name: str) -> None:
    """Make a drawing inside of another one a group of it, with its place as a transform.

    svgelements has its place right without a viewBox alone.
    """
    if element.get("viewBox") is not None:
        for attribute, whole in zip(("width", "height"), box or (None, None)):
            if whole is None and element.get(attribute) is None:
                raise invalid(name, f"{attribute} is missing, in a drawing without a viewBox")
            element.set(attribute, element.get(attribute, repr(whole)))
    space, _ = tag(element)
    inner = Element(element.tag, element.attrib)
    place = f"translate({inner.attrib.pop('x', 0)} {inner.attrib.pop('y', 0)})"
    transform = f"{inner.attrib.pop('transform', '')} {place}"
    inner.extend(element)
    element.clear()
    element.tag = f"{space}g"
    element.set("transform", transform)
    element.append(inner)


_PIXELS = {"": 1, "px": 1, "pt": 4 / 3, "pc": 16, "mm": 96 / 25.4, "cm": 96 / 2.54, "in": 96}


def _length(text: str, attribute: str, box: Box, name: str) -> float:
    found = _LENGTH.fullmatch(text)
    if not found:
        raise invalid(name, f"{attribute} is {text!r}, and no length")
    value, unit = float(found[1]), found[2]
    if unit != "%":
        return value * _PIXELS[unit]
    if box is None:
        raise invalid(name, f"{attribute} is {text}, of a drawing without a viewBox")
    width, height = box
    whole = math.hypot(width, height) / math.sqrt(2)
    if attribute in ("x", "width", "cx", "rx"):
        whole = width
    elif attribute in ("y", "height", "cy", "ry"):
        whole = height
    return value / 100 * whole


def _check_transform(text: str, name: str) -> None:
    place = 0
    while place < len(text):
        found = _TRANSFORM.match(text, place)
        counts = _TRANSFORMS.get(found[1].lower(), ()) if found else ()
        numbers = re.sub(rf"({NUMBER})(?:deg|px)", r"\1", found[2]) if found else ""
        if not any(_is_numbers(numbers, count, once=True) for count in counts):
            raise invalid(name, f"{text[place:].strip()!r} is no transform")
        place = found.end() if found else len(text)


def _check_path_data(data: str, name: str) -> None:
    """Raise InputError for data that is not whole.

    Programs that draw it stop there without a word.
    """
    word = re.search("nan|inf", data, re.IGNORECASE)
    if word:
        raise invalid(name, f"'{word[0]}' in path data is no number")
    start, *commands = re.split(r"([A-DF-Za-df-z])", data)
    for command, numbers in zip(commands[::2], commands[1::2]):
        count = _COUNTS.get(command.upper())
        # The flags of an arc need no blanks after them.
        fits = count is not None and (count == 7 or _is_numbers(numbers, count))
        if not fits:
            raise invalid(name, f"'{command}{numbers.rstrip()}' is no command of path data")
    if start.strip():
        raise invalid(name, f"'{start.strip()}' is no command of path data")


def _is_numbers(text: str, count: int, *, once: bool = False) -> bool:
    """Whether a text is numbers, just so many or a multiple of it."""
    if re.sub(NUMBER, "", text).strip(" \t\r\n\f,"):
        return False
    numbers = len(re.findall(NUMBER, text))
    if once or count == 0:
        return numbers == count
    return numbers % count == 0


def _hide_what_is_not_drawn(element: Element) -> None:
    """Put symbols and their like among the definitions, which are drawn by use alone."""
    for k, child in enumerate(element):
        space, kind = tag(child)
        if kind in _HIDDEN:
            element[k] = Element(f"{space}defs")
            element[k].append(child)
