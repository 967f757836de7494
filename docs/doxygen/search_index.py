"""The index of the search: a list of all sections of all pages, with their words."""
import html.parser
import json
import re

MAX_WORDS = 1500  # characters of a section that the search sees
LEFT_OUT = ("globals", "files", "dir_", "_8h_source", "classes", "functions")


class Sections(html.parser.HTMLParser):
    """Title, sections with their places, and words of each."""

    def __init__(self, text):
        super().__init__()
        self.title, self.sections = "", [["", "", []]]
        self.in_title = self.in_heading = self.in_contents = False
        self.skipped = 0
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        kind = attributes.get("class") or ""
        if tag == "div" and kind == "title":
            self.in_title = True
        elif tag == "div" and kind == "contents":
            self.in_contents = True
        elif tag == "footer":
            self.in_contents = False
        elif tag == "div" and "toc" in kind or tag in ("script", "style"):
            self.skipped += 1
        elif self.skipped and tag == "div":
            self.skipped += 1
        elif self.in_contents and tag in ("h1", "h2", "h3"):
            self.in_heading = True
            self.sections.append(["", "", []])
        elif self.in_heading and tag == "a":
            self.sections[-1][1] = attributes.get("id") or (attributes.get("href") or "").removeprefix("#")

    def handle_endtag(self, tag):
        if tag == "div" and self.in_title:
            self.in_title = False
        elif self.skipped and tag in ("div", "script", "style"):
            self.skipped -= 1
        elif tag in ("h1", "h2", "h3"):
            self.in_heading = False

    def handle_data(self, data):
        if self.in_title:
            self.title += data
        elif self.skipped:
            return
        elif self.in_heading:
            self.sections[-1][0] += data
        elif self.in_contents:
            self.sections[-1][2].append(data)


def plain(words):
    return re.sub(r"\s+", " ", words).strip()


def write(folder):
    entries = []
    for path in sorted(folder.glob("*.html")):
        if path.name.startswith(LEFT_OUT) or path.name.endswith("_source.html"):
            continue
        page = Sections(path.read_text(encoding="utf-8"))
        for heading, place, words in page.sections:
            heading = plain(heading).removeprefix("◆ ").removeprefix("◆")
            text = plain(" ".join(words))[:MAX_WORDS]
            if heading or text:
                entries.append([plain(page.title), heading, path.name + (f"#{place}" if place else ""), text])
    script = "const pagesOfSite = " + json.dumps(entries, ensure_ascii=False, separators=(",", ":")) + ";\n"
    (folder / "search_index.js").write_text(script, encoding="utf-8")
