"""A page as Doxygen reads it. Its first heading gets the page's name, the others the names that links use, as
Doxygen has the names of all pages in one. Links lead to pages of the site, and a long page gets a table of contents."""
import re

import pages

FENCED = re.compile(r"(?ms)(^ *```.*?^ *```)")


def with_percent_signs(text):
    """Doxygen takes a percent sign before a word away, also within words of code."""
    def code(found):
        return f"`{found[1].replace('%', '%%')}`"

    parts = FENCED.split(text)
    return "".join(part if i % 2 else re.sub(r"`([^`\n]*%\w[^`\n]*)`", code, part) for i, part in enumerate(parts))


def with_links(text, page, known):
    def link(found):
        is_picture, words, target = found.groups()
        if is_picture:
            return found[0].replace("(../", "(")
        address = pages.address_of(target, page, known)
        return f"[{words}]({address})" if address else words

    parts = FENCED.split(text)
    return "".join(part if i % 2 else pages.LINK.sub(link, part) for i, part in enumerate(parts))


def with_headings(text, page):
    """Headings with names. Doxygen shows tags of code in a heading as text, so it has no code."""
    name, seen, in_code, lines = pages.name_of(page), {}, False, []
    is_main = page == pages.MAIN_PAGE
    is_long = len(re.findall(r"(?m)^##+ ", FENCED.sub("", text))) > 2
    for line in text.splitlines():
        in_code ^= line.lstrip().startswith("```")
        heading = not in_code and re.fullmatch(r"(#+) (.*)", line)
        if not heading:
            lines.append(line)
        elif heading[1] == "#":
            contents = "" if is_main or not is_long else "\n\n[TOC]"
            lines.append(f"# {heading[2].replace('`', '')}" + ("" if is_main else f" {{#{name}}}") + contents)
        else:
            place = pages.place_of(heading[2])
            count = seen[place] = seen.get(place, -1) + 1
            place += f"-{count}" if count else ""
            words = pages.LINK.sub(r"\2", heading[2]).replace("`", "")
            lines.append(f"{heading[1]} {words} {{#{name}-{place}}}")
    return "\n".join(lines) + "\n"


def text_of(page, known):
    text = pages.with_outside_links((pages.ROOT / page).read_text(encoding="utf-8"), page)
    text = text.replace('src="../images/', 'src="images/')
    return with_percent_signs(with_headings(with_links(text, page, known), page))
