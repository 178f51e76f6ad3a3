# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The polygons of DXF drawings, which ezdxf reads."""

from __future__ import annotations

import io
import logging
import math
from collections import Counter
from collections.abc import Iterator
from typing import Any, Optional

from ._coordinates import Points
from ._ffi import InputError
from ._named import NamedPolygon, Reading, curve, invalid, package, too_fine
from ._nested_rings import Ring, polygons_of_rings

_POLYLINES = {"LWPOLYLINE", "POLYLINE"}
_CLOSED_KINDS = {*_POLYLINES, "CIRCLE", "ELLIPSE", "SPLINE"}
_LEAST_LINES = 4
"""A curve has at least as many lines in its place."""
_FINEST = 1e-9
"""How near they may be at most, as a part of the size of the curve."""


def polygons_of_dxf(data: bytes, reading: Reading) -> list[NamedPolygon]:
    """The polygons of the closed polylines in the model space, blocks resolved.

    A closed polyline inside another one of its layer is a hole in it, and one inside the
    hole a polygon of its own.
    """
    logging.getLogger("ezdxf").setLevel(logging.CRITICAL)  # errors are raised
    recover = package("ezdxf.recover", "DXF", reading.file)
    disassemble = package("ezdxf.disassemble", "DXF", reading.file)
    path = package("ezdxf.path", "DXF", reading.file)
    layers: dict[str, list[Ring]] = {}
    left_out = Counter[str]()
    if data.startswith(b"AutoCAD Binary DXF"):
        raise invalid(reading.file, "DXF: this is binary; only DXF that is text is read")
    if not data.rstrip(b" \t\r\n\x1a").endswith(b"EOF"):
        raise invalid(reading.file, "DXF: this ends before the end of the drawing, EOF")
    try:
        document, _ = recover.read(io.BytesIO(data))
        entities = list(_placed(disassemble.recursive_decompose, document.modelspace()))
    except RecursionError:
        raise invalid(reading.file, "DXF: a block is in itself, or nested too deeply") from None
    except Exception as error:
        raise _damaged(reading.file, error) from None
    for entity, matrix in entities:
        name = f"{reading.file}: {_name(entity)}"
        try:
            outline = _outline(path.make_path, entity, name, reading, matrix)
        except InputError:
            raise
        except Exception as error:
            raise _damaged(name, error) from None
        if outline is None:
            left_out[entity.dxftype()] += 1
        else:
            layers.setdefault(entity.dxf.layer, []).append(Ring(name, outline))
    reading.leave_out(left_out)
    return [polygon for rings in layers.values() for polygon in polygons_of_rings(rings)]


def _damaged(name: str, error: Exception) -> InputError:
    """The error for a drawing, or an entity of one, that led to whatever error in ezdxf."""
    return invalid(name, f"DXF: {str(error) or type(error).__name__}")


def _placed(decompose: Any, entities: Any, matrix: Any = None) -> Iterator[tuple[Any, Any]]:
    """The entities, those of blocks too, and the matrix that takes each to its place.

    They stay as they are in their block: scaled unevenly, an arc is one no more.
    """
    for entity in entities:
        block = entity.block() if entity.dxftype() == "INSERT" else None
        if block is None:
            yield from ((piece, matrix) for piece in decompose([entity]))
            continue
        yield from ((attribute, matrix) for attribute in entity.attribs)
        inside = [one for one in block if one.dxftype() != "ATTDEF"]
        for insert in entity.multi_insert() if entity.mcount > 1 else [entity]:
            place = insert.matrix44()
            yield from _placed(decompose, inside, place if matrix is None else place * matrix)


def _stretch(matrix: Any) -> float:
    """At least how much longer a matrix makes a vector; 1 where there is none."""
    if matrix is None:
        return 1.0
    rows = [[abs(value) for value in row[:3]] for row in list(matrix.rows())[:3]]
    most = max(map(sum, rows)) * max(map(sum, zip(*rows)))
    return math.sqrt(most) or 1.0


def _name(entity: Any) -> str:
    """What a message calls an entity; parts of dimensions and their like have no handle."""
    handle = f" {entity.dxf.handle}" if entity.dxf.handle else ""
    return f"{entity.dxftype()}{handle} of layer '{entity.dxf.layer}'"


def _outline(
    make_path: Any, entity: Any, name: str, reading: Reading, matrix: Any
) -> Optional[Points]:
    """The vertices of an entity that is closed, where the matrix takes it; None for others."""
    vertices = _vertices(make_path, entity, name, reading, _stretch(matrix))
    if vertices is not None and matrix is not None:
        vertices = matrix.transform_vertices(vertices)
    return vertices and [(vertex.x, vertex.y) for vertex in vertices]


def _vertices(
    make_path: Any, entity: Any, name: str, reading: Reading, stretch: float
) -> Optional[list[Any]]:
    """The vertices of an entity that is closed, before it is stretched; None for others."""
    kind = entity.dxftype()
    if kind not in _CLOSED_KINDS or _is_mesh(entity):
        return None
    path = make_path(entity)
    if not path.is_closed:
        return None
    controls = list(path.control_vertices())
    if not path.has_curves:
        return controls
    if reading.flatten is None:
        raise curve(name)
    distance = reading.flatten / stretch
    size = max(point.distance(controls[0]) for point in controls)
    if distance < _FINEST * size:
        raise too_fine(name)
    if kind in _POLYLINES:
        points = _flattened_polyline(controls[0], entity, distance)
    else:
        points = _lines(entity, distance)
    # The last point is computed, and only near the first one.
    return points[:-1]


def _is_mesh(entity: Any) -> bool:
    return entity.dxftype() == "POLYLINE" and not (entity.is_2d_polyline or entity.is_3d_polyline)


def _flattened_polyline(start: Any, polyline: Any, distance: float) -> list[Any]:
    points = [start]
    for piece in polyline.virtual_entities():
        lines = _lines(piece, distance)
        # Arcs are counter-clockwise, whichever way the polyline goes.
        if lines[-1].distance(points[-1]) < lines[0].distance(points[-1]):
            lines.reverse()
        points += lines[1:]
    return points


def _lines(entity: Any, distance: float) -> list[Any]:
    kind = entity.dxftype()
    if kind == "LINE":
        return [entity.dxf.start, entity.dxf.end]
    if kind in ("ELLIPSE", "SPLINE"):
        return list(entity.flattening(distance, _LEAST_LINES))
    return list(entity.flattening(min(distance, entity.dxf.radius / 2)))
