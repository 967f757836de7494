"""The pages of the site: their names, headings, links and tables."""
import pathlib
import posixpath
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]
MAIN_PAGE = "docs/doxygen/main_page.md"
C_REFERENCE = "docs/doxygen/c_reference.md"
# Pages outside of docs/, which pages name by their paths, as they are not installed beside them; and their titles.
OUTSIDE = {
    "bindings/python/README.md": "Python",
    "bindings/fortran/README.md": "Fortran",
    "bindings/rust/README.md": "Rust",
    "box2d_adapter/README.md": "Box2D adapter",
    "docs/papers/wang_2021.md": "Map of Wang 2021",
    "docs/papers/zheng_2020.md": "Map of Zheng 2020",
    "docs/papers/li_2015.md": "Map of Li 2015",
    "CONTRIBUTING.md": "Contributing",
    "CHANGELOG.md": "Changes",
}
LINK = re.compile(r"(!?)\[((?:[^\[\]`]|`[^`]*`)*)\]\(([^()\s]+)\)")


def sources():
    """All pages, by their paths in the repository."""
    folders = ["docs"] + [f"docs/{name}" for name in ("concepts", "scenes", "measured", "decisions", "coming_from")]
    inside = (path for folder in folders for path in sorted((ROOT / folder).glob("*.md")))
    return [str(path.relative_to(ROOT)) for path in inside] + [C_REFERENCE] + list(OUTSIDE)


def name_of(path):
    """docs/concepts/laws.md is concepts_laws, bindings/python/README.md is bindings_python."""
    return re.sub(r"\W", "_", path.removeprefix("docs/").removeprefix("doxygen/").removesuffix(".md").removesuffix("/README")).lower()


def place_of(heading):
    """The name that GitHub gives to a heading."""
    return re.sub(r"[^\w\- ]", "", LINK.sub(r"\2", heading).strip().lower()).replace(" ", "-")


def file_of(link, page):
    """The file of a link, by its path in the repository, and the place in it."""
    path, _, place = link.partition("#")
    return posixpath.normpath(posixpath.join(posixpath.dirname(page), path)) if path else page, place


def address_of(link, page, pages):
    """The same link within the site, or None where the site does not have the file."""
    if "://" in link:
        return link
    file, place = file_of(link, page)
    if file == "README.md" or file == MAIN_PAGE:
        return "index.html"
    if file in pages:
        return f"{name_of(file)}.html" + (f"#{name_of(file)}-{place}" if place else "")
    return file.removeprefix("docs/") if file.startswith("docs/") else None


def with_outside_links(text, page):
    """Paths of pages outside of docs/ as links."""
    for path, title in OUTSIDE.items():
        text = text.replace(f"`{path}`", f"[{title}]({posixpath.relpath(path, posixpath.dirname(page))})")
    return text


def tables(text):
    """Tables of a page: the first cell of the head, and rows as lists of cells."""
    for table in re.findall(r"(?m)(?:^\|.*\n)+", text):
        rows = [[cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]] for line in table.splitlines()]
        yield rows[0][0], rows[2:]
