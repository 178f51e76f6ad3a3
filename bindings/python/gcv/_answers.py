# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Records of questions as text and as JSON."""

from __future__ import annotations

import json
from collections.abc import Sequence
from enum import IntEnum
from typing import Any, Callable, NamedTuple, Optional, Union

from ._contact_list import ContactList
from ._contacts import Contact, ContactKind, Escape, Impact, Pair, Relation, Separation
from ._members import CONTAINER_ID, FIRST_ID
from ._pair_list import PairList
from ._polygon import digits
from ._record_list import RecordList


class Answer(NamedTuple):
    """What the library says to a question of the program."""

    numbers: dict[str, int]
    """Which polygons of their files it is about, where files have several."""
    position: Optional[tuple[float, float]]
    """Where the second polygon was moved to, where a table has positions."""
    record: Any


def text(answers: Sequence[Answer]) -> str:
    """A line for each record, and for each one of a list."""
    lines = []
    for numbers, _, record in answers:
        records = record if isinstance(record, RecordList) else [record]
        for one in records:
            about = [*numbers.values(), *_members_of(one).values()]
            lines.append(" ".join([*map(str, about), _TEXTS[type(one)](one)]))
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
    PairList: "pairs",
}
"""What a record is called that has no names of its own."""


def _members_of(record: Any) -> dict[str, Union[int, str]]:
    """What of a scene a record of a list is about: numbers of its file, or the container."""
    ids = {}
    if isinstance(record, Pair):
        ids = {"a": record.a, "b": record.b}
    elif isinstance(record, Contact) and record.id_b:
        ids = {"polygon_a": record.id_a, "polygon_b": record.id_b}
    return {
        name: "container" if number == CONTAINER_ID else number - FIRST_ID
        for name, number in ids.items()
    }


def _object(record: Any) -> dict[str, Any]:
    value = _value(record)
    return value if isinstance(value, dict) else {_NAMES[type(record)]: value}


def _value(of: Any) -> Any:
    if isinstance(of, IntEnum):
        return of.name.lower().replace("_", "-")
    if isinstance(of, RecordList):
        return list(map(_value, of))
    if hasattr(of, "_asdict"):
        members, others = _members_of(of), of._asdict()
        names = [name for name in others if name not in _IDS and name not in members]
        return {**members, **{name: _value(others[name]) for name in names}}
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


def _pair_text(pair: Pair) -> str:
    return _relation_text(pair.relation)


_TEXTS: dict[type, Callable[[Any], str]] = {
    Relation: _relation_text,
    Separation: _separation_text,
    Impact: _impact_text,
    Escape: _escape_text,
    Contact: _contact_text,
    Pair: _pair_text,
    tuple: _point_text,
    type(None): _point_text,
}
