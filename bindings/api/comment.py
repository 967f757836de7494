"""Doc comments of the headers: brief, parameters with their directions, result."""
import re


def plain(raw):
    """The words of a comment without its frame, a paragraph per line."""
    if raw is None:
        return ""
    inside = re.sub(r"^/\*\*<?|\*/$", "", raw.strip())
    lines = [re.sub(r"^\s*\* ?", "", line).strip() for line in inside.splitlines()]
    paragraphs = re.split(r"\n{2,}", "\n".join(lines).strip())
    return "\n".join(paragraph.replace("\n", " ").replace("::", "") for paragraph in paragraphs)


def of_function(raw):
    """(brief, {parameter: (direction or None, words)}, result) of a function's comment."""
    parts = re.split(r"@(brief|return|param(?:\[[a-z,]+\])?)\s+", plain(raw))
    brief, result, parameters = parts[0].strip(), "", {}
    for command, words in zip(parts[1::2], map(str.strip, parts[2::2])):
        if command == "brief":
            brief = words
        elif command == "return":
            result = words
        else:
            names, _, words = words.partition(" ")
            direction = re.search(r"\[(.*)\]", command)
            for name in names.split(","):
                parameters[name] = (direction and direction.group(1).replace(",", "_"), words)
    return brief, parameters, result
