"""Writes what type checkers read, from what the compiled module says of itself: stubs.py FOLDER_OF_SNUG.

Every docstring of the module begins with its signature and types, one line for each way to call it; that of a property
begins with its type.
"""
import ast
import importlib.machinery
import importlib.util
import inspect
import sys
from pathlib import Path

HEAD = '''\
# Written by bindings/python/stubs.py when the module is built.
from collections.abc import Callable, Iterable, Iterator
from os import PathLike
from typing import Any, Literal, Never, Self, final, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

__version__: str
'''
# What Python itself asks of a class.
PROTOCOL = {
    "__array__": "(self, dtype: Any = None, copy: Any = None) -> NDArray[np.float64]",
    "__copy__": "(self) -> Self",
    "__deepcopy__": "(self, memo: dict[int, Any], /) -> Self",
    "__eq__": "(self, other: object, /) -> bool",
    "__getstate__": "(self) -> tuple[Any, ...]",
    "__getitem__": "(self, index: int, /) -> float",
    "__hash__": "(self) -> int",
    "__iter__": "(self) -> Iterator[float]",
    "__len__": "(self) -> int",
    "__reduce__": "(self) -> tuple[Any, ...]",
    "__setstate__": "(self, state: tuple[Any, ...], /) -> None",
    "_repr_html_": "(self) -> str",
    "_repr_svg_": "(self) -> str | None",
}


def quoted(text, indent):
    lines = [line.strip() for line in text.strip().splitlines()]
    return indent + '"""' + f"\n{indent}".join(lines).replace("\\", "\\\\") + '"""'


def function(name, thing, indent="", static=False):
    """Its signatures, and what it answers."""
    if name in PROTOCOL:
        return [f"{indent}def {name}{PROTOCOL[name]}: ..."]
    signatures, _, meaning = thing.__doc__.partition("\n\n")
    lines, ways = [], signatures.splitlines()
    for way in ways:
        ast.parse(f"def {way}: ...")
        lines += [f"{indent}@overload"] if len(ways) > 1 else []
        lines += [f"{indent}@staticmethod"] if static else []
        lines += [f"{indent}def {way}:", quoted(meaning, indent + "    "), f"{indent}    ..."]
    return lines


def of_class(name, thing):
    if issubclass(thing, Exception):
        return [f"class {name}(ValueError):", quoted(thing.__doc__, "    ")]
    members = vars(thing)
    meaning = thing.__doc__
    lines = ["@final", f"class {name}:"]
    if members["__init__"].__doc__.startswith("__init__("):
        meaning = meaning.partition("\n\n")[2]
        made = function("__init__", members["__init__"], "    ")
    else:
        made = ["    def __init__(self, *args: Never, **kwargs: Never) -> None: ..."]
    lines += [quoted(meaning, "    "), *made]
    for member, value in members.items():
        if isinstance(value, property):
            of, _, meaning = value.__doc__.partition(": ")
            ast.parse(of, mode="eval")
            lines += ["    @property", f"    def {member}(self) -> {of}:", quoted(meaning, "        "), "        ..."]
        elif member in PROTOCOL or (callable(value) or isinstance(value, staticmethod)) and not member.startswith("_"):
            static = isinstance(value, staticmethod)
            lines += function(member, value.__func__ if static else value, "    ", static)
    fields = ", ".join(["str"] * len(thing.__match_args__)) or "()"
    return lines + [f"    __match_args__: tuple[{fields}]"]


def stub(module):
    text = HEAD
    for name, thing in vars(module).items():
        if not name.startswith("_"):
            text += "\n" + "\n".join(of_class(name, thing) if inspect.isclass(thing) else function(name, thing)) + "\n"
    return text


if __name__ == "__main__":
    folder = Path(sys.argv[1])
    (library,) = folder.glob("_snug.*.so")
    found = importlib.util.spec_from_file_location("_snug", library)
    module = importlib.util.module_from_spec(found)
    found.loader.exec_module(module)
    text = stub(module)
    ast.parse(text)
    (folder / "_snug.pyi").write_text(text)
