# SPDX-License-Identifier: LGPL-3.0-or-later
"""The hand-made inputs of corpus/calls that call the functions of scenes."""


def scene_calls() -> dict[str, bytes]:
    """Bytes as fuzz_calls.cpp reads them, for the functions of scenes."""
    create_wkt, contacts = 1, 40
    (
        create, copy, set_container, add, set_, set_layers, remove, ids, positions, polygon,
        destroy, relation, distance, cast, penetration, near, pairs, list_contacts, listed_pairs,
        listed_contacts, listed_indices, free_region, best, destroy_lists,
    ) = range(44, 68)  # fmt: skip
    too_many = 7  # a count beyond all memory
    none, special = 3, 192  # an earlier list; ids from there on are of no members
    options = bytes(6)
    made = bytes([0, 1])  # to slot 0, an output that is not NULL
    all_members = b"\0"

    def some(*ignored: int, size: int = 1, layers: int = 0, unknown: int = 0) -> bytes:
        is_null = size in (0, 3)
        return bytes([size] if is_null else [size, layers, len(ignored), *ignored, 0, unknown])

    def added(*members: tuple[int, int, int], scene: int = 0) -> bytes:
        """Members are polygons at x y."""
        xy = bytes(16 + number for member in members for number in member[1:])
        shapes = bytes(member[0] for member in members)
        return bytes([add, scene, len(members)]) + shapes + b"\1" + xy + b"\1\1"

    def named(call: int, *members: int, count: int | None = None, null: int = 1) -> bytes:
        count = len(members) if count is None else count
        return bytes([call, 0, count, *members, null])

    def asked(
        call: int, query: bytes = all_members, count: int = 2, xy: bytes = b"\x10\x11\x14\x1a",
        moving: int = 0, given: bytes = options, nulls: bytes = b"\1\1",
    ) -> bytes:  # fmt: skip
        motions = bytes([*([20, 18] * (len(xy) // 2)), 1]) if call == cast else b""
        return bytes([call, 0, moving]) + given + query + bytes([count]) + xy + nulls + motions

    def near_to(query: bytes = all_members, at: bytes = b"\x12\x12\1", size: bytes = b"\1\x12",
                moving: int = 0, given: bytes = options) -> bytes:  # fmt: skip
        return bytes([near, 0, moving]) + given + query + at + size + made

    def listed(call: int, query: bytes = all_members, previous: bytes | None = None,
               scene: int = 0, size: bytes = b"\1\x12", to: int = 0,
               given: bytes = options) -> bytes:  # fmt: skip
        if previous is None:
            previous = bytes([none]) if call == pairs else bytes([0, 0, none])
        sizes = size if call == pairs else size + b"\1\x10"
        return bytes([call, scene]) + given + query + previous + sizes + bytes([to, 1])

    def free(window: int, query: bytes = all_members, null: int = 1, moving: int = 0,
             given: bytes = options) -> bytes:  # fmt: skip
        return bytes([free_region, 0, moving]) + given + query + bytes([window, null]) + made

    def furthest(direction: bytes, query: bytes = all_members, given: bytes = options) -> bytes:
        return bytes([best, 0, 0]) + given + query + direction + b"\1\1"

    shapes = (
        bytes([create_wkt, 0, 1, 1, 0, 1, create_wkt, 1, 1, 1, 1, 1])
        + bytes([0, 0, 4, 16, 16, 31, 16, 31, 31, 16, 31, 1, 1, 2, 1])
    )  # fmt: skip
    empty = shapes + bytes([create]) + made
    row = empty + added((0, 1, 1), (1, 5, 2), (0, 8, 8))
    room = row + bytes([set_container, 0, 2])
    questions = (relation, distance, cast, penetration)
    inputs = {
        "null": shapes + bytes([copy, 0, 0, 1, set_container, 0, 2]) + added((0, 1, 1))
        + named(set_, 0) + b"\0\1\1\x10\x10\1\1" + named(set_layers, 0) + bytes([1, 1, 1, 1, 1])
        + named(remove, 0) + bytes([ids, 0, 3, 0]) + named(positions, 0) + b"\1"
        + bytes([polygon, 0, 0, 2, 1, destroy, 0]) + b"".join(asked(call) for call in questions)
        + near_to() + listed(pairs) + listed(list_contacts) + free(0) + furthest(b"\x11\x11\1")
        + bytes([listed_pairs, 0, 3, 0, listed_contacts, 0, 3, 0, listed_indices, 0, 3, 0])
        + bytes([destroy_lists, 0, 0]),
        "changes": row + added((1, 12, 3)) + named(set_, 0, 2) + bytes([1, 0, 1, 1])
        + b"\x12\x13\x14\x15\1\1"
        + named(set_, 1) + bytes([1, 1, 0, 16, 16, 1, 1])  # moved alone
        + named(set_, 1) + bytes([1, 1, 1, 16, 16, 1, 0])  # another polygon alone
        + named(set_layers, 0, 1) + bytes([1, 2, 3, 4, 1]) + named(remove, 1, 3)
        + named(positions, 1, 0) + b"\1" + bytes([polygon, 0, 0, 2, 1, polygon, 0, 195, 2, 1])
        + b"".join(bytes([ids, 0, kind, 0]) for kind in range(6)) + added((0, 1, 1)),
        "changes_refused": row
        + b"".join(
            named(call, *members, null=null) + tail
            for call, tail in (
                (set_, b"\0\0\1\1\x12\x12\x13\x13\1\1"), (set_layers, bytes([1, 1, 1, 1, 1])),
                (remove, b""), (positions, b"\1"),
            )
            for members, null in (
                ((0, 0), 1), *(((1, special + k), 1) for k in range(6)), ((0, 1), 0)
            )
        ),
        "changes_not_finite": row
        + b"".join(
            bytes([add, 0, 1, 0, 1]) + xy + b"\1\1"
            + named(set_, 1) + bytes([0, 1, 1]) + xy + b"\1\1"
            for xy in (b"\x10\0", b"\1\x10", b"\x10\2", b"\3\4", b"\5\6", b"\7\10")
        ),
        "changes_of_null": row
        + bytes([add, 0, 2, 0, 1, 0, 16, 16, 17, 17, 1, 1, add, 0, 1, 0, 1, 16, 16, 0, 1])
        + bytes([add, 0, 1, 0, 1, 16, 16, 1, 0, add, 0, 0, 0, 0, 0])
        + named(set_layers, 0) + bytes([1, 1, 1, 1, 0])
        + named(positions, 0) + b"\0" + named(set_, 0) + bytes([0, 1, 0, 16, 16, 1, 0]),
        "changes_too_many": row
        + bytes([add, 0, too_many, 1, 1, 1])
        + b"".join(
            named(call, count=too_many, null=null) + tail
            for call, tail in (
                (set_, b"\1\1\1\1"), (set_layers, bytes([1, 1, 1, 1, 1])), (remove, b""),
                (positions, b"\1"),
            )
            for null in (0, 1)
        )
        + b"".join(asked(call, count=too_many, xy=b"") for call in questions),
        "copies": room + bytes([copy, 0, 1, 1]) + added((0, 3, 3)) + added((1, 3, 3), scene=1)
        + listed(pairs) + listed(pairs, previous=b"\0", scene=1, to=1)
        + listed(list_contacts) + listed(list_contacts, previous=bytes(3), scene=1, to=1)
        + bytes([create, 2, 1]) + listed(pairs, previous=b"\0", scene=2)
        + listed(list_contacts, previous=bytes(3), scene=2) + bytes([copy, 0, 0, 1])
        + listed(pairs, previous=b"\1") + bytes([copy, 1, 0, 0, destroy, 1, destroy, 0])
        + named(remove, 0),
        "questions": room
        + b"".join(
            asked(call, moving=moving) + asked(call, xy=b"", count=0, nulls=b"\0\0")
            for call in questions
            for moving in range(3)
        ),
        "questions_not_finite": row
        + b"".join(
            asked(call, count=1, xy=xy)
            for call in questions
            for xy in (b"\x10\0", b"\1\x10", b"\2\2", b"\3\4", b"\4\3", b"\5\6")
        )
        + b"".join(near_to(at=xy + b"\1") for xy in (b"\x10\0", b"\2\x10", b"\3\4")),
        "questions_of_null": room
        + b"".join(asked(call, nulls=nulls) for call in questions for nulls in (b"\0\1", b"\1\0")),
        "nothing_there": empty
        + b"".join(asked(call) for call in questions)
        + near_to() + listed(pairs) + listed(list_contacts) + free(0) + free(0, null=0)
        + furthest(b"\x0f\x11\1"),
        "queries_sizes": room
        + b"".join(
            asked(relation, some(size=size, unknown=unknown)) + asked(penetration, some(size=size))
            for size in range(11)
            for unknown in range(2)
        ),
        "queries": room + named(set_layers, 0, 1) + bytes([1, 2, 3, 4, 1])
        + b"".join(
            asked(call, query)
            for call in (distance, cast, penetration)
            for query in (
                *(some(layers=layers) for layers in range(6)), some(0, 1), some(0, 0, 1),
                some(special + 1), some(special, special + 4, special + 5),
            )
        ),
        "queries_of_null": room
        + b"".join(
            asked(call, bytes([1, 0, 2, 0, 1, 7, count, 0]))
            for call in questions
            for count in range(3)
        ),
        "lists": room + near_to() + near_to(some(special + 1)) + listed(pairs, size=b"\1\x18")
        + listed(list_contacts, size=b"\1\x18")
        + b"".join(
            bytes([call, 0, kind, 0])
            for call in (listed_pairs, listed_contacts, listed_indices)
            for kind in range(6)
        )
        + listed(pairs, some(0), size=b"\1\x12", to=1) + named(set_, 1)
        + bytes([0, 1, 0, 17, 20, 1, 1]) + listed(pairs, previous=b"\0")
        + listed(list_contacts, previous=bytes(3)) + bytes([listed_indices, 0, 3, 0])
        + bytes([destroy_lists, 0, 0, destroy_lists, 1, 2]),
        "lists_of_others": room + near_to() + listed(pairs, previous=b"\0")
        + bytes([contacts, 0, 1]) + options + bytes([16, 20, 1, 1, 16, 1, 16]) + made
        + listed(list_contacts, previous=bytes([3, 0]))
        + listed(list_contacts, previous=bytes([3, 1])) + listed(list_contacts)
        + bytes([destroy, 0, create]) + made + listed(list_contacts, previous=bytes(3)),
        "lists_of_no_size": room
        + b"".join(
            near_to(size=size) + listed(pairs, size=size) + listed(list_contacts, size=size)
            for size in (b"\0\x11", b"\1\1", b"\1\2", b"\1\0", b"\1\3", b"\0\x10")
        ),
        "windows": row + b"".join(free(k) for k in range(13)) + free(13)[:-3]
        + b"\x10\x11\x15\x1a\1" + made + bytes([set_container, 0, 2])
        + b"".join(free(k) for k in range(13)),
        "free": room + free(0, null=0) + free(1, null=0, moving=1) + free(0, some(0), null=0)
        + free(0, some(special + 1), null=0) + free(0, some(layers=4), null=0)
        + free(0, some(special + 1)) + bytes([set_container, 0, 1]) + free(0, null=0, moving=1),
        "best": room
        + b"".join(
            furthest(direction)
            for direction in (
                b"\x11\x10\1", b"\4\x10\1", b"\x10\x10\1", b"\x10\2\1", b"\1\x10\1",
                b"\5\6\1", b"\x11\x12\0",
            )
        )
        + furthest(b"\x11\x11\1", some(special + 1)) + furthest(b"\x11\x11\1", some(layers=4))
        + furthest(b"\x11\x11\1")[:-2] + b"\0\1" + furthest(b"\x11\x11\1")[:-1] + b"\0"
        + bytes([set_container, 0, 1]) + furthest(b"\x11\x11\1"),
    }  # fmt: skip
    for k, name in enumerate(("sizes", "roundings", "tolerances", "threads", "leave_outs")):
        whole = bytes([1]) + options[1:]
        inputs[f"options_{name}"] = room + b"".join(
            free(0, given=given) + asked(penetration, given=given)
            + furthest(b"\x11\x11\1", given=given)
            for given in (whole[:k] + bytes([value]) + whole[k + 1 :] for value in range(10))
        )  # fmt: skip
    return {f"scenes_{name}": data for name, data in inputs.items()}
