"""The modules of the package for Python, read from their sources: the names that the package imports for its users. The
members that a public class has from another one stand on the page of the other, under the name of the public class."""
import ast
import re
import textwrap

from page_of_module import Item, Module

HEADINGS = ("Parameters", "Returns", "Raises", "Attributes", "Examples", "Notes", "Yields", "See Also")

IMPORTED = ("records", "trade")  # modules that users import by themselves


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

    def literal(found):
        return ":\n\n```\n" + textwrap.dedent(found[1]).rstrip() + "\n```\n"

    examples = re.sub(r"(?m)^>>> .*\n(?:(?!\n).+\n?)*", fenced, body + "\n")
    return re.sub(r"::\n\n((?: {4}.*\n|\n)+)", literal, examples)


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


def class_item(node, owner):
    members, start = [], owner
    for one in node.body:
        if not isinstance(one, ast.FunctionDef) or is_setter(one):
            continue
        if one.name == "__init__":
            if owner == node.name:
                start = signature(one, owner)
        elif not one.name.startswith("_"):
            result = f" -> {ast.unparse(one.returns)}" if one.returns else ""
            shown = f"{one.name}{result}  # property" if is_property(one) else signature(one, one.name)
            members.append(Item(one.name, shown, doc(one)))
    constants = [ast.unparse(one) for one in node.body if isinstance(one, ast.Assign)]
    if constants and not members:
        start += "\n" + "\n".join(f"    {line}" for line in constants)
    return Item(owner, f"class {start}", doc(node), members)


def public_names(trees):
    """The names that the package imports for its users, all of a module or `as` themselves, and those of modules that
    users import by themselves."""
    imports = [one for one in trees["__init__"].body if isinstance(one, ast.ImportFrom)]
    whole = [one.module for one in imports if one.names[0].name == "*"]
    listed = [each.name for one in imports for each in one.names if each.asname == each.name]
    defined = [getattr(one, "name", "_") for name in (*IMPORTED, *whole) for one in trees[name].body]
    return {*listed, *(name for name in defined if not name.startswith("_"))}


def owners_of(trees, public):
    """The public classes that have the members of each class."""
    bases = {node.name: [ast.unparse(base) for base in node.bases]
             for tree in trees.values() for node in tree.body if isinstance(node, ast.ClassDef)}

    def ancestors(name):
        return {name}.union(*(ancestors(base) for base in bases.get(name, [])))

    return {name: [name] if name in public else [each for each in bases if each in public and name in ancestors(each)]
            for name in bases}


def items_of(tree, owners, public):
    for node in tree.body:
        if isinstance(node, ast.ClassDef) and not node.name.startswith("_") and owners[node.name]:
            yield class_item(node, ", ".join(owners[node.name]))
        elif isinstance(node, ast.FunctionDef) and node.name in public:
            yield Item(node.name, signature(node, node.name), doc(node))


def modules(root):
    paths = sorted((root / "bindings/python/halfspace").glob("*.py"))
    trees = {path.stem: ast.parse(path.read_text(encoding="utf-8")) for path in paths}
    public = public_names(trees)
    owners = owners_of(trees, public)
    found = [Module(name, doc(tree), list(items_of(tree, owners, public)))
             for name, tree in trees.items() if not name.startswith("_")]
    for module in found:
        defined = {node.name for node in trees[module.name].body if isinstance(node, ast.ClassDef)}
        for item in module.items:
            others = [other.name for other in found if other is not module and item.name in defined
                      and any(item.name in one.name.split(", ") and one.members for one in other.items)]
            if others:
                links = ", ".join(f"[{name.replace('_', ' ')}](python_{name}.html)" for name in others)
                item.text += f"\n\nOther members of {item.name}: {links}."
    return [module for module in found if module.items]
