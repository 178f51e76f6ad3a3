# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Records of questions as text and as JSON."""

from __future__ import annotations

import json
from collections.abc import Sequence
from enum import IntEnum
from typing import Any, Callable, NamedTuple, Optional

from ._contact_list import ContactList
from ._contacts import Contact, ContactKind, Escape, Impact, Relation, Separation
from ._polygon import digits


class Answer(NamedTuple):
    """What the library says to a question of the program."""

    numbers: dict[str, int]
    """Which polygons of their files it is about, where files have several."""
    position: Optional[tuple[float, float]]
    """Where the second polygon was moved to, where a table has positions."""
    record: Any


def text(answers: Sequence[Answer]) -> str:
    """A line for each record, and for each contact of a list."""
    lines = []
    for numbers, _, record in answers:
        records = record if isinstance(record, ContactList) else [record]
        for one in records:
            lines.append(" ".join([*map(str, numbers.values()), _TEXTS[type(one)](one)]))
    return "\n".join(lines)


def as_json(answers: Sequence[Answer]) -> str:
    """An object, or a list of them where there are several answers."""
    objects = [
        {**numbers, **({"at": position} if position else {}), **_object(record)}
        for numbers, position, record in answers
    ]
    return json.dumps(objects[0] if len(objects) == 1 else objects)


FORMATS: dict[str, Callable[[Sequence[Answer]], str]] = {"text": text, "json": as_json}

_IDS = {"id", "id_a", "id_b"}
"""What records have of scenes."""
_NAMES = {
    Relation: "relation",
    tuple: "position",
    type(None): "position",
    ContactList: "contacts",
}
"""What a record is called that has no names of its own."""


def _object(record: Any) -> dict[str, Any]:
    value = _value(record)
    return value if isinstance(value, dict) else {_NAMES[type(record)]: value}


def _value(of: Any) -> Any:
    if isinstance(of, IntEnum):
        return of.name.lower().replace("_", "-")
    if isinstance(of, ContactList):
        return [_value(contact) for contact in of]
    if hasattr(of, "_asdict"):
        return {name: _value(value) for name, value in of._asdict().items() if name not in _IDS}
    return of


def _point_text(point: Optional[tuple[float, float]]) -> str:
    return " ".join(map(digits, point)) if point else "nothing is free"


def _contact_text(contact: Contact) -> str:
    of_a = "edge" if contact.kind == ContactKind.EDGE_VERTEX else "vertex"
    of_b = "edge" if contact.kind == ContactKind.VERTEX_EDGE else "vertex"
    return (
        f"{of_a} {contact.a} of A, {of_b} {contact.b} of B, gap {digits(contact.gap)}, "
        f"at {_point_text(contact.on_a)}"
    )


def _impact_text(impact: Impact) -> str:
    if not impact.hit:
        return "no hit"
    return f"hit at time {digits(impact.time)}, position {_point_text(impact.position)}"


def _escape_text(escape: Escape) -> str:
    text = f"depth {digits(escape.depth)}, position {_point_text(escape.position)}"
    return f"{text}, still overlapping" if escape.relation == Relation.OVERLAPPING else text


def _separation_text(separation: Separation) -> str:
    return digits(separation.distance)


def _relation_text(relation: Relation) -> str:
    return relation.name.lower()


_TEXTS: dict[type, Callable[[Any], str]] = {
    Relation: _relation_text,
    Separation: _separation_text,
    Impact: _impact_text,
    Escape: _escape_text,
    Contact: _contact_text,
    tuple: _point_text,
    type(None): _point_text,
}
