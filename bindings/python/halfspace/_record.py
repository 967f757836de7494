"""Records: structs of the library as NumPy scalars with fields as attributes."""
from __future__ import annotations

import ctypes
import operator
import textwrap
from enum import IntEnum, IntFlag
from typing import TYPE_CHECKING, Any, Callable, Dict, List, Optional, Tuple, Type, TypeVar, Union

import numpy as np
from numpy.typing import NDArray

from ._attributes import calls_that_set, refused_assignment, unknown_attribute

_LONGEST_LINE = 100
_Kind = Type[Union[IntEnum, IntFlag]]
Floats = NDArray[np.float64]


if TYPE_CHECKING:
    _Struct = np.void  # to a type checker a np.record has any attribute
else:
    _Struct = np.record


class Record(_Struct):
    """One struct: ``record.gap`` is ``record["gap"]``. It prints the names and values of its fields."""

    _kinds: Dict[str, _Kind] = {}  # of fields that are constants
    _structure: Any  # of the library
    _type: Any  # the data type

    def __getitem__(self, key: Any) -> Any:
        return np.void.__getitem__(self, key)  # np.record would return nested records as objects of this class

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any:
            raise unknown_attribute(type(self), name, self.dtype.names)

        def __setattr__(self, name: str, value: Any) -> None:
            if name not in self.dtype.names:
                raise unknown_attribute(type(self), name, self.dtype.names)
            if not self.flags.writeable:
                from .world import World  # which knows records

                ways = {field: f"World.{call}" for field, call in calls_that_set(World).items() if field == name}
                raise refused_assignment(type(self), name, ways, exists=True)
            self[name] = value

    def __repr__(self) -> str:
        name = type(self).__name__
        fields = [f"{field}={self._text_of(field)}" for field in self.dtype.names or () if not field.startswith("reserved")]
        line = f"{name}({', '.join(fields)})"
        if len(line) <= _LONGEST_LINE and "\n" not in line:
            return line
        return f"{name}(\n" + textwrap.indent("".join(f"{field},\n" for field in fields), "    ") + ")"

    __str__ = __repr__

    def _text_of(self, field: str) -> str:
        value = self[field]
        if field in self._kinds:
            return _name_of(self._kinds[field], int(value))
        if isinstance(value, np.ndarray):
            return np.array2string(value, separator=", ", prefix=" " * len(f"{field}="))
        return repr(value if isinstance(value, Record) else value.item())


def _name_of(kind: _Kind, value: int) -> str:
    """The name of a constant, or the names of all flags in a sum; the number if there is none."""
    of_sum = issubclass(kind, IntFlag)
    names = [name for name, of in kind.__members__.items() if (of & value if of_sum else of == value)]
    return f"{kind.__name__}.{'|'.join(names)}" if names else str(value)


AnyRecord = TypeVar("AnyRecord", bound=Record)


class Records(np.ndarray):  # type: ignore[type-arg]
    """An array of records: ``records.gap`` is ``records["gap"]``, and ``records[0]`` is a record."""

    def __getitem__(self, key: Any) -> Any:
        found = super().__getitem__(key)
        is_numbers = isinstance(found, np.ndarray) and found.dtype.names is None
        return found.view(np.ndarray) if is_numbers else found

    def __dir__(self) -> List[str]:
        return [*super().__dir__(), *(self.dtype.names or ())]

    def __getattr__(self, name: str) -> Any:
        fields = self.dtype.names or ()
        if name not in fields:
            raise unknown_attribute(type(self), name, fields)
        return self[name]

    def __setattr__(self, name: str, value: Any) -> None:
        fields = self.dtype.names or ()
        if name in fields:
            self[name] = value
        elif hasattr(np.ndarray, name):
            super().__setattr__(name, value)
        else:
            raise unknown_attribute(type(self), name, fields)

    def columns(self) -> Dict[str, NDArray[Any]]:
        """Returns all numbers by name, in columns for ``pandas.DataFrame(states.columns())``: components of vectors and
        tensors as ``velocity[1]`` and ``stress[0, 1]``, those of records in records as ``pose.position[1]``."""
        columns: Dict[str, NDArray[Any]] = {}
        for name in self.dtype.names or ():
            values = self[name]
            if isinstance(values, Records):
                columns.update({f"{name}.{inner}": column for inner, column in values.columns().items()})
            elif not name.startswith("reserved"):
                for index in np.ndindex(values.shape[1:]):
                    place = f"[{', '.join(map(str, index))}]" if index else ""
                    columns[name + place] = values[(slice(None), *index)]
        return columns


_types: Dict[Any, Any] = {}  # of earlier structs, which may be fields of others


def record_type(record: Type[Record], structure: Any) -> Any:
    """The NumPy data type of a C struct, with elements of the given record class."""
    names = [name for name, *_ in structure._fields_]
    plain = np.dtype(
        {
            "names": names,
            "formats": [_format_of(declared) for _, declared in structure._fields_],
            "offsets": [getattr(structure, name).offset for name in names],
            "itemsize": ctypes.sizeof(structure),
        }
    )
    for name in names:  # also names of NumPy methods, e.g. `mean`
        setattr(record, name, property(_getter(name, record._kinds.get(name))))
    _types[structure] = np.dtype((record, plain))
    record._structure, record._type = structure, _types[structure]
    return record._type


def _getter(name: str, kind: Optional[_Kind]) -> Callable[[Any], Any]:
    """Reads a field; a constant as a member of its enumeration, if it is of this version."""
    read = operator.itemgetter(name)
    if kind is None:
        return read
    members = {int(member): member for member in kind.__members__.values()}
    if issubclass(kind, IntFlag):
        flags = kind
        return lambda record: flags(int(read(record)))
    return lambda record: members.get(int(read(record)), read(record))


def _format_of(declared: Any) -> Any:
    """The data type of a field; nine numbers are a 3 x 3 array."""
    found = _types.get(declared) or np.dtype(declared)
    return np.dtype((found.base, (3, 3))) if found.shape == (9,) else found


def empty_record(kind: Type[AnyRecord]) -> Tuple[AnyRecord, Any]:
    """A record of zeros, and the struct in its memory, which only the library writes."""
    array = np.zeros(1, kind._type)
    struct = kind._structure.from_address(array.ctypes.data)
    array.flags.writeable = False
    return array[0], struct
