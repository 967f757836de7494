"""A page of the reference: modules and their items as Markdown for Doxygen."""
import dataclasses
import re
from typing import List


@dataclasses.dataclass
class Item:
    """A class, a function, a type: its name, its text as in the source, its documentation, its members."""

    name: str
    signature: str
    text: str
    members: List["Item"] = dataclasses.field(default_factory=list)


@dataclasses.dataclass
class Module:
    """A page."""

    name: str
    text: str
    items: List[Item]


def as_prose(text):
    """Documentation as Doxygen reads it: neither tags nor commands outside of code. It takes single percent signs away."""
    parts = re.split(r"(```.*?```|``.+?``|`[^`]+`)", text, flags=re.DOTALL)
    escape = str.maketrans({"<": "&lt;", "@": "\\@", "\\": "\\\\", "*": "\\*"})
    keep = re.compile(r"(\*\*[^*]+\*\*|^\* )", re.MULTILINE)
    parts = [part if part.startswith("```") else re.sub(r"%(?=\w)", "%%", part) for part in parts]
    return "".join(part if i % 2 else "".join(word if k % 2 else word.translate(escape)
                                              for k, word in enumerate(keep.split(part)))
                   for i, part in enumerate(parts))


def place(page, *names):
    return "-".join([page, *(re.sub(r"\W+", "_", name) for name in names)])


def markdown(language, module, fence):
    """The page, and its name."""
    page = f"{language.lower()}_{module.name}"
    lines = [f"# {language}: {module.name.replace('_', ' ')} {{#{page}}}", "", "[TOC]", "", as_prose(module.text), ""]
    seen = set()
    for item in module.items:
        for name, one in [((item.name,), item), *(((item.name, member.name), member) for member in item.members)]:
            where = place(page, *name)
            while where in seen:
                where += "_"
            seen.add(where)
            lines += [f"{'##' if len(name) == 1 else '###'} {'.'.join(name) if fence == 'py' else name[-1]} {{#{where}}}",
                      "", f"```{{.{fence}}}" if fence else "```", one.signature, "```", "", as_prose(one.text), ""]
    return page, "\n".join(lines)


def first_sentence(text):
    return re.split(r"(?<=\.)(?<!al\.)\s", " ".join(text.split("\n\n")[0].split()))[0]


def index(language, modules, introduction):
    """The page that lists the modules of a language."""
    page = f"{language.lower()}_reference"
    rows = [f"| [{module.name.replace('_', ' ')}]({language.lower()}_{module.name}.html) | "
            + as_prose(first_sentence(module.text)).replace("|", "\\|") + " | "
            + ", ".join(f"`{item.name}`" for item in module.items[:8])
            + (", ..." if len(module.items) > 8 else "") + " |" for module in modules]
    return page, "\n".join([f"# {language} reference {{#{page}}}", "", introduction, "", "| module | content | names |",
                            "|---|---|---|", *rows, ""])
