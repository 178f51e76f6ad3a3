# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Arrow arrays of polygons, as GeoArrow lays them out and names them, by pyarrow."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Any, Optional, Union

from ._coordinates import Rings, invalid
from ._ffi import PARSE, Error, InputError
from ._outer_face import OuterFace
from ._polygon import Polygon
from ._ragged import Rows, absent, levels_of, rows_of_geometries, rows_of_levels
from ._region import Region
from ._sources import read

_NAME, _METADATA = b"ARROW:extension:name", b"ARROW:extension:metadata"
_NAMES_OF_LEVELS = ("polygons", "rings", "vertices")
_READ = {"geoarrow.polygon", "geoarrow.multipolygon", "geoarrow.wkb", "geoarrow.wkt", "ogc.wkb"}


class _Schema:
    """A schema that another object has exported."""

    def __init__(self, capsule: Any) -> None:
        self._capsule = capsule

    def __arrow_c_schema__(self) -> Any:
        return self._capsule


def arrow_column(source: Any) -> Optional[tuple[Rows, Any]]:
    """The rows of an Arrow array or a stream, and its reference system; None for others.

    Columns of pandas are taken for sequences.
    """
    if type(source).__module__.partition(".")[0] == "pandas":
        return None
    if hasattr(source, "__arrow_c_array__"):
        import pyarrow

        field, array = pyarrow.field(_Schema(source.__arrow_c_array__()[0])), pyarrow.array(source)
    elif hasattr(source, "__arrow_c_stream__"):
        import pyarrow

        array = pyarrow.chunked_array(source).combine_chunks()
        field = pyarrow.field("", array.type)
    else:
        return None
    name, metadata = _extension(field)
    if name and name not in _READ:
        raise invalid(f"an Arrow array of {name} has no polygons")
    edges = metadata.get("edges") or "planar"
    if edges != "planar":
        raise invalid(f"the edges of this Arrow array are {edges}, and not straight")
    return _rows(array.storage if hasattr(array, "storage") else array), metadata.get("crs")


def _extension(field: Any) -> tuple[str, dict[str, Any]]:
    """The name and the metadata of the extension type of a field, where it has one."""
    if hasattr(field.type, "extension_name"):
        name, metadata = field.type.extension_name, field.type.__arrow_ext_serialize__()
    else:
        known = field.metadata or {}
        name, metadata = known.get(_NAME, b"").decode(), known.get(_METADATA, b"")
    return name, json.loads(metadata) if metadata else {}


def _rows(array: Any) -> Rows:
    """The rows of an array of the storage that GeoArrow has for polygons."""
    from pyarrow import types

    of, missing = array.type, array.is_null().to_numpy(zero_copy_only=False)
    if any(is_a(of) for is_a in (types.is_binary, types.is_large_binary, types.is_binary_view)):
        return _rows_of_binaries(array.cast("large_binary"))
    if any(is_a(of) for is_a in (types.is_string, types.is_large_string, types.is_string_view)):
        return list(map(_rings_of_text, array.to_pylist()))
    levels: list[Any] = []
    gone: list[tuple[int, Any]] = []
    while types.is_list(array.type) or types.is_large_list(array.type):
        levels.append(array.offsets.to_numpy())
        array = array.values
        gone.append((len(levels), _nulls(array)))
    coordinates = _coordinates(array)
    if coordinates is None or len(levels) not in (2, 3):
        raise invalid(f"an Arrow array of type {of} has no polygons")
    found, nulls = coordinates
    rows = rows_of_levels(found, levels, missing)
    for depth, numbers in [*gone, (len(levels), nulls)]:
        for row in _rows_with(numbers, levels[:depth]):
            if not missing[row]:
                rows[row] = invalid("a ring, a vertex or a coordinate of it is null")
    return rows


def _nulls(array: Any) -> Any:
    """The numbers of the elements that are null."""
    import numpy

    if not array.null_count:
        return numpy.empty(0, int)
    return numpy.flatnonzero(array.is_null().to_numpy(zero_copy_only=False))


def _rows_with(numbers: Any, levels: list[Any]) -> Any:
    """The rows that elements with these numbers are in, some levels of offsets below them."""
    import numpy

    for level in reversed(levels):
        numbers = numpy.searchsorted(level, numbers, side="right") - 1
        numbers = numbers[(numbers >= 0) & (numbers < len(level) - 1)]
    return numbers


def _rows_of_binaries(array: Any) -> Rows:
    """The rows of an array of Well-Known Binary, by shapely."""
    import shapely

    binaries = array.to_numpy(zero_copy_only=False)
    geometries = shapely.from_wkb(binaries, on_invalid="ignore")
    rows = rows_of_geometries(geometries)
    for k, (binary, geometry) in enumerate(zip(binaries, geometries)):
        if geometry is None and binary is not None:
            rows[k] = InputError(PARSE, "polygon: this is no Well-Known Binary")
    return rows


def _rings_of_text(text: Optional[str]) -> Union[Rings, InputError]:
    if text is None:
        return absent()
    try:
        return read(text)[0]
    except InputError as error:
        return error


def _coordinates(array: Any) -> Optional[tuple[Any, Any]]:
    """An array of shape (n, 2) of x and y, interleaved or not, and which coordinates are null.

    None where they are not there.
    """
    import numpy
    from pyarrow import types

    of = array.type
    if types.is_fixed_size_list(of) and of.value_type == "double" and of.list_size >= 2:
        # Flattened, it would lack the vertices that are null.
        start, stop = (k * of.list_size for k in (array.offset, array.offset + len(array)))
        flat = array.values[start:stop]
        vertices, axes = numpy.divmod(_nulls(flat), of.list_size)
        table = flat.to_numpy(zero_copy_only=False).reshape(-1, of.list_size)
        return table[:, :2], vertices[axes < 2]
    if types.is_struct(of) and all(of.get_field_index(name) >= 0 for name in "xy"):
        columns = [array.field(name) for name in "xy"]
        table = numpy.column_stack([one.to_numpy(zero_copy_only=False) for one in columns])
        return table, numpy.concatenate(list(map(_nulls, columns)))
    return None


def exported(
    shapes: Sequence[Union[Polygon, OuterFace, Region, Error]], crs: Any, *, multi: bool
) -> tuple[Any, Any]:
    """Capsules with a schema and an array: interleaved coordinates, and null for errors.

    multi is whether it is one of geoarrow.multipolygon, as for regions.
    """
    import numpy
    import pyarrow

    doubles, levels = levels_of(shapes, multi=multi)
    known: dict[str, Any] = {} if crs is None else _metadata(crs)
    array = pyarrow.FixedSizeListArray.from_arrays(
        numpy.frombuffer(doubles),
        type=pyarrow.list_(pyarrow.field("xy", pyarrow.float64(), nullable=False), 2),
    )
    missing = pyarrow.array([isinstance(shape, Error) for shape in shapes], "bool")
    for name, level in zip(reversed(_NAMES_OF_LEVELS), reversed(levels)):
        is_outermost = level is levels[0]
        of = pyarrow.list_(pyarrow.field(name, array.type, nullable=False))
        array = pyarrow.ListArray.from_arrays(
            pyarrow.array(level, "int32"), array, of, mask=missing if is_outermost else None
        )
    kind = b"geoarrow.multipolygon" if multi else b"geoarrow.polygon"
    extension = {_NAME: kind, _METADATA: json.dumps(known).encode()}
    field = pyarrow.field("", array.type, metadata=extension)
    return field.__arrow_c_schema__(), array.__arrow_c_array__()[1]


def _metadata(crs: Any) -> dict[str, Any]:
    """The metadata of a reference system of pyproj, or of GeoArrow."""
    if hasattr(crs, "to_json_dict"):
        crs = crs.to_json_dict()
    return {"crs": crs, **({"crs_type": "projjson"} if isinstance(crs, dict) else {})}
