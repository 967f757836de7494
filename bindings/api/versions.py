"""The files that state the project's version among other things: for cargo, for fpm, and for pkg-config to ask for.
Cargo.lock states it too, but `cargo --locked` sees to that."""
import re

from header import Fault

PACKAGES = [
    "bindings/fortran/fpm.toml",
    "bindings/rust/halfspace/Cargo.toml",
    "bindings/rust/halfspace-sys/Cargo.toml",
    "bindings/rust/overhead/Cargo.toml",
]
LOOKUP = "bindings/rust/halfspace-sys/build.rs"


def files(root, version):
    """Path in the tree and text of each file, as it is but for the version."""
    # The interface of one minor version may be unknown to the one before.
    needed = version.rpartition(".")[0]
    packages = {path: stating(root, path, r'(?<![\w-])version = "([^"]*)"', version) for path in PACKAGES}
    return packages | {LOOKUP: stating(root, LOOKUP, r'"halfspace >= ([^"]*)"', needed)}


def stating(root, path, statement, version):
    """The text of a file in which the group of every `statement` is the version."""
    text, count = re.subn(
        statement,
        lambda found: found.group().replace(found.group(1), version),
        (root / path).read_text(encoding="utf-8"),
    )
    if count == 0:
        raise Fault(f"{path} states no version")
    return text
