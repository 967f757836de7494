"""The modules of the crate for Rust, read from their sources as rustfmt lays them out."""
import re

from page_of_module import Item, Module

ITEM = re.compile(r"pub (?:unsafe |const )*(fn|struct|enum|trait|type|const) (\w+)")


def prose(lines):
    """Documentation without the hidden lines of its examples, and without links of rustdoc."""
    shown, in_code = [], False
    for line in lines:
        if line.startswith("```"):
            in_code = not in_code
            shown.append("```")
        elif not (in_code and re.match(r"#( |$)", line)):
            shown.append(line)
    text = "\n".join(shown).replace("\\[", "[")
    return re.sub(r"(?m)^# (.*)$", r"**\1**", re.sub(r"\[(`[^`\]]+`)\](?:\([^)]*\))?", r"\1", text))


def declaration(lines, start):
    """The text of an item until its body, with the fields of a struct and the values of an enum, and its end."""
    kind = ITEM.match(lines[start].strip())[1]
    indent = len(lines[start]) - len(lines[start].lstrip())
    end = start
    if kind in ("struct", "enum", "trait"):
        while not re.match(rf" {{{indent}}}\}}|.*;$|.*\{{\}}$", lines[end]):
            end += 1
        shown = [line for line in lines[start:end + 1] if not re.match(r"\s*#\[", line)]
        if kind == "struct":
            shown = [line for line in shown if not re.match(r"\s+(?!pub |///|\})\S", line) or line == shown[0]]
    else:
        while not lines[end].rstrip().endswith(("{", ";")):
            end += 1
        shown = lines[start:end + 1]
        shown[-1] = re.sub(r"\s*\{$", "", shown[-1])
    text = "\n".join(line[indent:] for line in shown)
    return re.sub(r" \{\n\}$", " { /* private fields */ }", text), end


def macro_kinds(text):
    """The enums that a macro makes of the library's constants."""
    for found in re.finditer(r"constants! \{\n((?: {4}///[^\n]*\n)*) {4}(\w+) \{\n(.*?)\n {4}\}\n\}", text, re.DOTALL):
        words = [line.strip()[4:] for line in found[1].splitlines()]
        body = re.sub(r" = HS_\w+", "", found[3])
        yield Item(found[2], f"enum {found[2]} {{\n" + "\n".join(line[4:] for line in body.splitlines()) + "\n}",
                   prose(words))


def items_of(text):
    lines, words, items, owner, owners = text.splitlines(), [], [], None, {}
    i = 0
    while i < len(lines):
        line = lines[i]
        stripped = line.strip()
        if stripped.startswith("///"):
            words.append(stripped[4:])
        elif re.match(r"impl\b", line) and line.rstrip().endswith("{"):
            named = re.match(r"impl(?:<.*?>)? (\w+)", line)
            owner = named[1] if named and " for " not in line else None
            words = []
        elif line.startswith("}"):
            owner, words = None, []
        elif ITEM.match(stripped):
            shown, i = declaration(lines, i)
            name = ITEM.match(stripped)[2]
            item = Item(name, shown, prose(words))
            if line.startswith("pub"):
                items.append(item)
                owners.setdefault(name, item)
            elif owner:
                if owner not in owners:
                    owners[owner] = Item(owner, f"impl {owner}", "")
                    items.append(owners[owner])
                owners[owner].members.append(item)
            words = []
        elif stripped and not stripped.startswith(("#[", "//")):
            words = []
        i += 1
    return items


def modules(root):
    folder = root / "bindings/rust/halfspace/src"
    for path in sorted(folder.glob("*.rs")):
        text = path.read_text(encoding="utf-8").split("#[cfg(test)]")[0]
        words = [line[4:] for line in text.splitlines() if line.startswith("//!")]
        items = list(macro_kinds(text)) + [item for item in items_of(text) if item.text or item.members]
        if items:
            yield Module(path.stem, prose(words), items)
