"""Reads the public headers: what they declare and what their comments say of it, as plain data.

Kinds of parameters and results:
  value       a number, or a struct by value
  handle      an opaque object
  new_handle  receives an opaque object
  handles     an array of opaque objects
  pointer     one struct or number behind a pointer
  array       numbers or structs; with a length if that is fixed
  bytes       memory of no type
  string      characters up to a 0
  nothing     no result
The kind says which C type `of` it is; `const` tells whether the library only reads it. What is not constant
has a direction, out or in_out, from the words of the comment.
"""
import os.path
import re

from clang import cindex
from clang.cindex import CursorKind, TypeKind

import comment

HEADER = "capi/include/halfspace/halfspace.h"
DECLARATIONS = ("aliases", "handles", "structs", "callbacks")
TYPES = {"int32_t", "uint32_t", "int64_t", "uint64_t", "size_t", "double", "char", "void"}


class Fault(Exception):
    """What the bindings cannot be made from."""


def describe(root, header=HEADER, known=None):
    """The public interface that the header in the source tree `root` declares; its types may be those of the interface
    `known`, which is another header's."""
    include, folder = root / "capi" / "include", (root / header).parents[1]
    options = cindex.TranslationUnit.PARSE_DETAILED_PROCESSING_RECORD
    unit = cindex.Index.create().parse(str(root / header), ["-std=c99", f"-I{include}"], options=options)
    for diagnostic in unit.diagnostics:
        raise Fault(str(diagnostic))
    api = {
        "generated": f"by bindings/api/generate from {header}; do not edit",
        "version": version(root),
        "status_codes": [],
        "constants": [],
        "aliases": [],
        "handles": [],
        "structs": [],
        "callbacks": [],
        "functions": [],
    }
    known = known or dict.fromkeys(DECLARATIONS, [])
    for kind in DECLARATIONS:
        api[kind] += known[kind]
    texts = status_texts(unit) if header == HEADER else {}
    for cursor in unit.cursor.get_children():
        if not cursor.location.file or not cursor.location.file.name.startswith(str(folder)):
            continue
        if cursor.kind == CursorKind.ENUM_DECL:
            add_enum(api, cursor, texts)
        elif cursor.kind == CursorKind.TYPEDEF_DECL:
            add_type(api, cursor)
        elif cursor.kind == CursorKind.FUNCTION_DECL:
            api["functions"].append(function(api, cursor, os.path.relpath(cursor.location.file.name, folder)))
    for kind in DECLARATIONS:
        del api[kind][:len(known[kind])]
    return api


def version(root):
    project = re.search(r"project\(halfspace\s+VERSION (\S+)", (root / "CMakeLists.txt").read_text(encoding="utf-8"))
    return project.group(1)


def status_texts(unit):
    """Text of each status code, from the list X(name, value, text)."""
    for cursor in unit.cursor.get_children():
        if cursor.kind == CursorKind.MACRO_DEFINITION and cursor.spelling == "HS_STATUS_LIST":
            tokens = " ".join(token.spelling for token in cursor.get_tokens())
            return dict(re.findall(r'X \( (\w+) , [-\d ]+ , "(.*?)" \)', tokens))
    raise Fault("there is no HS_STATUS_LIST")


def add_enum(api, cursor, texts):
    names = [constant.spelling for constant in cursor.get_children()]
    if names == list(texts):
        api["status_codes"] = [{"name": constant.spelling, "value": constant.enum_value,
                                "text": texts[constant.spelling]} for constant in cursor.get_children()]
        return
    prefix = re.sub(r"[^_]*$", "", os.path.commonprefix(names)) if len(names) > 1 else names[0]
    constants = [{"name": constant.spelling, "value": constant.enum_value,
                  "comment": comment.plain(constant.raw_comment)} for constant in cursor.get_children()]
    api["constants"].append({"group": prefix, "comment": comment.plain(cursor.raw_comment), "constants": constants})


def add_type(api, cursor):
    name, words = cursor.spelling, comment.plain(cursor.raw_comment)
    underlying = cursor.underlying_typedef_type
    record = underlying.get_canonical().get_declaration()
    if is_function(underlying):
        add_callback(api, name, comment.of_function(cursor.raw_comment)[0], cursor, underlying.get_pointee())
    elif record.kind != CursorKind.STRUCT_DECL:
        api["aliases"].append({"name": name, "type": underlying.spelling, "comment": words})
    elif not record.is_definition():
        api["handles"].append({"name": name, "comment": words})
    else:
        fields = [field(api, name, member) for member in record.get_children()]
        api["structs"].append({"name": name, "comment": words, "size": record.type.get_size(), "fields": fields})


def field(api, struct, cursor):
    described = {"name": cursor.spelling, "type": cursor.type.spelling}
    inner, dimensions = cursor.type, []
    while inner.kind == TypeKind.CONSTANTARRAY:
        dimensions.append(inner.element_count)
        inner = inner.element_type
    if is_function(inner):  # C has no name for it; the struct and its field make one
        name = f"{struct}_{cursor.spelling}"
        add_callback(api, name, comment.plain(cursor.raw_comment), cursor, inner.get_pointee())
        described |= {"kind": "callback", "of": name}
    else:
        described |= typed(api, inner)
    described["dimensions"] = dimensions
    described |= {"offset": cursor.get_field_offsetof() // 8, "size": cursor.type.get_size(),
                  "comment": comment.plain(cursor.raw_comment)}
    return described


def is_function(c_type):
    """Is it a pointer to a function?"""
    return c_type.kind == TypeKind.POINTER and c_type.get_pointee().get_canonical().kind == TypeKind.FUNCTIONPROTO


def add_callback(api, name, words, cursor, prototype):
    arguments = [child for child in cursor.get_children() if child.kind == CursorKind.PARM_DECL]
    api["callbacks"].append({
        "name": name,
        "comment": words,
        "result": {"type": prototype.get_result().spelling} | typed(api, prototype.get_result()),
        "parameters": [{"name": argument.spelling, "type": argument.type.spelling} | typed(api, argument.type)
                       for argument in arguments],
    })


def function(api, cursor, header):
    brief, comments, result = comment.of_function(cursor.raw_comment)
    parameters = [parameter(api, cursor.spelling, argument, comments) for argument in cursor.get_arguments()]
    unknown = comments.keys() - {described["name"] for described in parameters}
    if unknown or not brief:
        raise Fault(f"{cursor.spelling}: its comment has no brief or names no parameter of it {sorted(unknown)}")
    return {
        "name": cursor.spelling,
        "header": header,
        "comment": brief,
        "result": {"type": cursor.result_type.spelling} | typed(api, cursor.result_type) | {"comment": result},
        "parameters": parameters,
    }


def parameter(api, function_name, cursor, comments):
    name = cursor.spelling
    if name not in comments:
        raise Fault(f"{function_name}: the comment does not say what {name} is")
    direction, words = comments[name]
    described = {"name": name, "type": cursor.type.spelling} | typed(api, cursor.type)
    if described["kind"] in ("pointer", "array", "bytes", "new_handle"):
        if described["const"]:
            direction = "in"
        elif not direction and (re.match(r"receives|to fill", words) or function_name.endswith("_def_init")):
            direction = "out"
        elif not direction:
            raise Fault(f"{function_name}: does {name} only receive? Its comment must begin so, or @param say [in,out]")
        described["direction"] = direction
    if described["kind"] not in ("value", "nothing"):
        described["optional"] = bool(re.search(r"^NULL\b|\bmay be NULL\b", words))
    return described | {"comment": words}


def typed(api, c_type):
    """Kind of a type, what it is made `of`, and whether that is constant."""
    described = kind_of(api, c_type)
    declared = {each["name"] for kind in DECLARATIONS for each in api[kind]}
    if described["of"] not in TYPES | declared:
        raise Fault(f"{c_type.spelling}: not a type that all languages have; use numbers of fixed width")
    return described


def kind_of(api, c_type):
    if c_type.kind in (TypeKind.CONSTANTARRAY, TypeKind.INCOMPLETEARRAY):
        element = c_type.element_type
        if element.kind == TypeKind.POINTER:
            return {"kind": "handles"} | named(element.get_pointee())
        length = {"length": c_type.element_count} if c_type.kind == TypeKind.CONSTANTARRAY else {}
        return {"kind": "array"} | named(element) | length
    if c_type.kind == TypeKind.POINTER:
        target = c_type.get_pointee()
        if target.kind == TypeKind.POINTER:
            return {"kind": "new_handle"} | named(target.get_pointee())
        kinds = {"void": "bytes", "char": "string"} | {handle["name"]: "handle" for handle in api["handles"]}
        return {"kind": kinds.get(named(target)["of"], "pointer")} | named(target)
    return {"kind": "nothing" if c_type.kind == TypeKind.VOID else "value", "of": c_type.spelling}


def named(c_type):
    return {"of": c_type.spelling.removeprefix("const "), "const": c_type.is_const_qualified()}
