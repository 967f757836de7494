"""Fortran: the comments of the headers in its words. Indices count from 1, and an argument may be absent."""
import re

from header import Fault

# What C says, and what Fortran does; in order.
EVERYWHERE = [
    (r"^Bulk: (\w)", lambda found: found[1].upper()),
    (r"\bhs_world_def\.(?=\w)", ""),
    (r"\bhs_world_def\b", "create()"),
    (r"\bhs_share_info\.(\w+)", r"\1 of share_info()"),
    (r" A world of the same settings is made [^.]+\.", ""),
]
OF_ARGUMENTS = [
    (r"(?:^|;)\s*(?:may be|not) NULL\b.*$", ""),
    (r"^id(?:$|, or 0(?=:))", ""),
    (r"^: ", "absent: "),
    (r"(?:; )?its count is the capacity", ""),
    (r"^receives (?:them|it|as many as fit|up to `capacity` \w+)\b[,; ]*", ""),
    (r"^receives (?:the |its (?=id))?", ""),
    (r"^((?:its )?ind(?:ex|ices)\b(?! from)[^,;]*)(?:, >= 0)?", r"\1, from 1"),
    (r", or -1$", ", or 0"),
    (r", or 0 (?=for|if)", ", or none "),
    (r"\b3 values(.*); 2D uses z", r"3 values (2D: or 1, about z)\1"),
    (r"\b3 values\b(?! \(2D)", "3 values (2D: or 2)"),
    (r"\b3 x 9 values as stress", "(:, :, k) along axis k"),
    (r"\b9 values(?: row by row)?", "(row, column), 3 x 3 (2D: or 2 x 2)"),
    (r"; (?:a view with count 0 skips it|may be empty)", ""),
    (r"a view with count 0", "its absence"),
    (r"^1: (.*); 0: ", r".true.: \1; .false.: "),
]
OF_C_ALONE = re.compile(r"\bNULL\b|\bcapacity\b|\bview with|\brow by row|\bhs_")


def replaced(words, replacements):
    for pattern, replacement in replacements:
        words = re.sub(pattern, replacement, words)
    return words


class Words:
    def __init__(self, names):
        self.names = names

    def of_method(self, function):
        """The brief, and the errors that have a condition."""
        returned = function["result"]["comment"].replace(", also for", " for")
        errors = re.findall(r"\bHS_ERROR_\w+ (?:if|for|unless|before) .*", returned)
        return self.in_fortran(" ".join([function["comment"], *(f"{words}." for words in errors)]))

    def of_argument(self, comment, default):
        """With the default of an argument that may be absent, None for others."""
        words = replaced(self.in_fortran(comment), OF_ARGUMENTS)
        if OF_C_ALONE.search(words):
            raise Fault(f"fortran_words.py has no words for: {words}")
        if default is None or "absen" in words:
            return words
        if ", or 0: " in words:
            return words.replace(", or 0: ", "; default: ")
        return f"{words}; default {default}"

    def in_fortran(self, words):
        named = re.sub(r"\bhs_world_(?:get_)?(\w+)\(\)", lambda found: f"{self.names.get(found[1], found[1])}()", words)
        return replaced(named, EVERYWHERE)
