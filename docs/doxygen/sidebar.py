"""The list of pages beside each page, from the tables of the guide."""
import html
import re

import pages

GUIDE = "docs/guide.md"
SCENES = "docs/scenes/index.md"
FIRST = ["docs/tutorial.md", "docs/gallery.md", GUIDE, "docs/troubleshooting.md"]


def shown(words):
    """Without code, and with a capital."""
    words = html.escape(words.replace("`", ""))
    return words[0].upper() + words[1:]


def entry(words, address):
    return f'<li><a href="$relpath^{address}">{shown(words)}</a></li>'


def of_table(rows, page, known):
    """The first link of each row."""
    for row in rows:
        found = pages.LINK.search(row[0])
        address = found and pages.address_of(found[3], page, known)
        if address:
            yield entry(found[2], address)


def group(name, entries):
    return f"<details><summary>{shown(name)}</summary><ul>{''.join(entries)}</ul></details>"


def title_of(page):
    return re.search(r"(?m)^# (.*)$", (pages.ROOT / page).read_text(encoding="utf-8"))[1]


def first(known):
    return "".join(f'<a href="$relpath^{pages.name_of(page)}.html">{html.escape(title_of(page))}</a>' for page in FIRST
                   if page in known)


def sidebar(known, references):
    """A group for each table of the guide, and one of the tables of scenes. `references` are words and addresses of
    further pages of the reference."""
    groups = []
    guide = pages.with_outside_links((pages.ROOT / GUIDE).read_text(encoding="utf-8"), GUIDE)
    for name, rows in pages.tables(guide):
        entries = list(of_table(rows, GUIDE, known))
        if name == "reference":
            scenes = pages.tables((pages.ROOT / SCENES).read_text(encoding="utf-8"))
            listed = [one for head, rows in scenes if head == "page" for one in of_table(rows, SCENES, known)]
            groups.append(group("scene files", [entry("Scene files", "scenes_index.html")] + listed))
            entries[1:1] = [entry(*one) for one in references]
        groups.append(group(name, entries))
    return "\n".join(groups)
