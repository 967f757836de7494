"""The modules of the package for Python, read from their sources."""
import ast
import re

from page_of_module import Item, Module

HEADINGS = ("Parameters", "Returns", "Raises", "Attributes", "Examples", "Notes", "Yields", "See Also")


def sections(text):
    """The headings of NumPy's style in bold, their entries as lists, and examples as code."""
    heading = re.compile(rf"(?m)^({'|'.join(HEADINGS)})\n-+\n")
    parts = heading.split(text)
    written = [code_of_examples(parts[0])]
    for name, body in zip(parts[1::2], parts[2::2]):
        is_list = name in ("Parameters", "Returns", "Raises", "Attributes", "Yields")
        written.append(f"**{name}**\n\n{entries(body) if is_list else code_of_examples(body)}")
    return "\n\n".join(part.strip("\n") for part in written)


def entries(body):
    lines = []
    for line in body.splitlines():
        if line and not line.startswith(" "):
            name, _, kind = line.partition(" : ")
            lines.append(f"- `{name.strip()}`" + (f" ({kind})" if kind else "") + ":")
        elif line.strip():
            lines.append("  " + line.strip())
    return "\n".join(lines)


def code_of_examples(body):
    def fenced(found):
        return "```{.py}\n" + found[0].rstrip() + "\n```\n"

    return re.sub(r"(?m)^>>> .*\n(?:(?!\n).+\n?)*", fenced, body + "\n")


def doc(node):
    return sections(ast.get_docstring(node) or "")


def signature(node, name):
    arguments = ast.unparse(node.args)
    arguments = re.sub(r"^(self|cls)(, |$)", "", arguments)
    result = f" -> {ast.unparse(node.returns)}" if node.returns and ast.unparse(node.returns) != "None" else ""
    one_line = f"{name}({arguments}){result}"
    if len(one_line) <= 90:
        return one_line
    parts = re.split(r", (?![^\[(]*[\])])", arguments)
    return f"{name}(\n" + "".join(f"    {part},\n" for part in parts) + f"){result}"


def is_property(node):
    return any(isinstance(decorator, ast.Name) and decorator.id == "property" for decorator in node.decorator_list)


def is_setter(node):
    return any(isinstance(decorator, ast.Attribute) and decorator.attr == "setter" for decorator in node.decorator_list)


def class_item(node):
    members, start = [], node.name
    for one in node.body:
        if not isinstance(one, ast.FunctionDef) or is_setter(one):
            continue
        if one.name == "__init__":
            start = signature(one, node.name)
        elif not one.name.startswith("_"):
            result = f" -> {ast.unparse(one.returns)}" if one.returns else ""
            shown = f"{one.name}{result}  # property" if is_property(one) else signature(one, one.name)
            members.append(Item(one.name, shown, doc(one)))
    constants = [ast.unparse(one) for one in node.body if isinstance(one, ast.Assign)]
    if constants and not members:
        start += "\n" + "\n".join(f"    {line}" for line in constants)
    return Item(node.name, f"class {start}", doc(node), members)


def modules(root):
    for path in sorted((root / "bindings/python/halfspace").glob("[a-z]*.py")):
        tree = ast.parse(path.read_text(encoding="utf-8"))
        items = []
        for node in tree.body:
            if isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
                items.append(class_item(node))
            elif isinstance(node, ast.FunctionDef) and not node.name.startswith("_"):
                items.append(Item(node.name, signature(node, node.name), doc(node)))
        if items:
            yield Module(path.stem, doc(tree), items)
