"""The modules for Fortran, read from their sources."""
import re

from page_of_module import Item, Module

PROCEDURE = re.compile(r"\s*(?:module |elemental |pure |recursive )*(subroutine|function) (\w+)\((.*)")
TYPE = re.compile(r"\s*type(?:,[^:]*)? ?:: (\w+)|\s*type, ?[^:]*:: (\w+)")
INTERFACE = re.compile(r"\s*interface (\w+)")
DECLARATION = re.compile(r"\s*(?:real|integer|logical|character|class|type|procedure)\b.*::")
LEFT_OUT = {"halfspace_c", "halfspace_handles", "halfspace_views"}


def joined(lines):
    """Lines with their continuations."""
    whole = []
    for line in lines:
        if whole and whole[-1].rstrip().endswith("&"):
            whole[-1] = whole[-1].rstrip()[:-1].rstrip() + " " + line.strip()
        else:
            whole.append(line)
    return whole


def argument(line):
    """A declaration with its comment behind it."""
    return re.sub(r"\s+!<", "  !<", line.strip())


def procedure(lines, start, words):
    shown, i = [lines[start].strip()], start + 1
    while i < len(lines) and (DECLARATION.match(lines[i]) and "intent(" in lines[i] or "!" == lines[i].strip()[:1]
                              or re.match(r"\s*(use|import|procedure)\b", lines[i])):
        if "intent(" in lines[i] or "procedure(" in lines[i] and "::" in lines[i] or lines[i].strip().startswith("!"):
            shown.append("  " + argument(lines[i]))
        i += 1
    return Item(PROCEDURE.match(lines[start])[2], "\n".join(shown), " ".join(words))


def fields(lines, start, words):
    """A type: what of it is public."""
    shown, i, is_private = [lines[start].strip()], start + 1, False
    while not re.match(r"\s*end type", lines[i]):
        line = lines[i].strip()
        is_private = line != "contains" and (is_private or line == "private")
        if line == "contains" or "procedure" not in line and not is_private and ", private" not in line and line:
            shown.append("  " * (line != "contains") + argument(lines[i]))
        elif re.match(r"(procedure|generic) ::", line):
            shown.append("  " + line)
        i += 1
    name = next(filter(None, TYPE.match(lines[start]).groups()))
    return Item(name, "\n".join(shown), " ".join(words)), i


def items_of(lines):
    words, i = [], 0
    while i < len(lines):
        line, stripped = lines[i], lines[i].strip()
        if stripped.startswith(("!> ", "!! ")) or stripped == "!!":
            words = [stripped[3:]] if stripped.startswith("!> ") else words + [stripped[3:]]
        else:
            if words and PROCEDURE.match(line):
                yield procedure(lines, i, words)
            elif words and TYPE.match(line) and "(" not in line.split("::")[0].replace("bind(c)", "").replace(
                    "extends(", ""):
                item, i = fields(lines, i, words)
                yield item
            elif words and INTERFACE.match(line):
                yield Item(INTERFACE.match(line)[1], f"interface {INTERFACE.match(line)[1]}", " ".join(words))
            words = []
        i += 1


def modules(root):
    for path in sorted((root / "bindings/fortran/src").glob("halfspace_*.f90")):
        if path.stem in LEFT_OUT:
            continue
        text = path.read_text(encoding="utf-8")
        head = re.search(r"(?m)^!> ((?:.*\n)(?:!!.*\n)*)", text)
        words = re.sub(r"(?m)^!! ?", "", head[1]) if head else ""
        body = text[head.end():] if head else text
        items = list(items_of(joined(body.splitlines())))
        if items:
            yield Module(path.stem.removeprefix("halfspace_"), words, items)
