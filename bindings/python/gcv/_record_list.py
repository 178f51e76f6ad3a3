# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Lists of records that the library made: what those of contacts and of pairs have in common."""

from __future__ import annotations

from collections.abc import Sequence
from ctypes import c_void_p, sizeof
from typing import TYPE_CHECKING, Any, ClassVar, Optional, TypeVar, Union, overload

from . import _ffi
from ._contacts import dtype_of, record_of
from ._facts import made_by_itself

if TYPE_CHECKING:
    import numpy
    import numpy.typing

_T = TypeVar("_T")
_ListType = TypeVar("_ListType", bound="RecordList[Any]")


class RecordList(Sequence[_T]):
    """A sequence of records, which never changes, on structs of the library.

    The structs are read when they are needed: a list that is passed on as the previous one
    costs nothing more. A pickle has the structs and no handle.
    """

    __slots__ = ("__weakref__", "_handle", "_memory", "_records")

    _struct: ClassVar[Any]
    """The C type of the structs."""
    _noun: ClassVar[str]
    """What one record is called."""
    _read: ClassVar[Any]
    """The function of the library that writes the structs."""
    _memory: Union[bytes, memoryview, None]
    """The structs, once they were needed."""
    _handle: Any
    """The list of the library, for the next question to a scene; None where there is none."""
    _records: Optional[tuple[_T, ...]]
    """The records, once one was asked for."""

    def __init__(self, structs: Any = None, handle: Any = None) -> None:
        if not isinstance(handle, c_void_p) and (
            not isinstance(structs, bytes) or len(structs) % sizeof(self._struct)
        ):
            raise made_by_itself(self)
        self._memory, self._handle, self._records = structs, handle, None

    def _structs(self) -> Union[bytes, memoryview]:
        if self._memory is None:
            structs = _ffi.elements(self._read, self._struct, self._handle)
            self._memory = memoryview(structs).cast("B").toreadonly()
        return self._memory

    @property
    def array(self) -> numpy.typing.NDArray[numpy.void]:
        """A structured array of n, which cannot be written to.

        Every access looks at the same memory, without a copy. A list of records without
        numpy.
        """
        try:
            import numpy
        except ImportError:
            return list(self)  # type: ignore[return-value]
        return numpy.frombuffer(self._structs(), dtype_of(self._struct))

    def __array__(
        self, dtype: Any = None, copy: Optional[bool] = None
    ) -> numpy.typing.NDArray[Any]:
        """What numpy.asarray gives: array."""
        import numpy

        return numpy.array(self.array, dtype, copy=copy)

    def _all(self) -> tuple[_T, ...]:
        if self._records is None:
            structs = (self._struct * len(self)).from_buffer_copy(self._structs())
            self._records = tuple(map(record_of(self._struct), structs))
        return self._records

    def __len__(self) -> int:
        if self._memory is None:
            return _ffi.count(self._read, self._handle)
        return len(self._memory) // sizeof(self._struct)

    @overload
    def __getitem__(self, index: int) -> _T: ...

    @overload
    def __getitem__(self, index: slice) -> Sequence[_T]: ...

    def __getitem__(self, index: Union[int, slice]) -> Union[_T, Sequence[_T]]:
        return self._all()[index]

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, type(self)):
            return NotImplemented
        return bytes(self._structs()) == bytes(other._structs())

    def __hash__(self) -> int:
        return hash(bytes(self._structs()))

    def __copy__(self: _ListType) -> _ListType:
        return self

    def __deepcopy__(self: _ListType, _memo: object) -> _ListType:
        return self

    def __repr__(self) -> str:
        plural = "s" if len(self) != 1 else ""
        return f"<gcv.{type(self).__name__} of {len(self)} {self._noun}{plural}>"

    def __reduce__(self) -> tuple[type[RecordList[_T]], tuple[bytes, ...]]:
        return type(self), (bytes(self._structs()),)
