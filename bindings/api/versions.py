"""The files that state the project's version among other things: for C, for cargo, for fpm, and for pkg-config to ask
for. Cargo.lock states it too, but `cargo --locked` sees to that."""
import re

from header import Fault

PACKAGES = [
    "bindings/fortran/fpm.toml",
    "bindings/rust/halfspace/Cargo.toml",
    "bindings/rust/halfspace-sys/Cargo.toml",
    "bindings/rust/overhead/Cargo.toml",
]
LOOKUP = "bindings/rust/halfspace-sys/build.rs"
HEADER = "capi/include/halfspace/status.h"


def files(root, version):
    """Path in the tree and text of each file, as it is but for the version."""
    packages = {path: stating(root, path, r'(?<![\w-])version = "([^"]*)"', version) for path in PACKAGES}
    lookup = stating(root, LOOKUP, r'"halfspace >= ([^"]*)"', wanted(version))
    return packages | {LOOKUP: lookup, HEADER: header(root, version)}


def interface(version):
    """The leading numbers that all versions of one interface share: before 1.0 a minor version may change it."""
    major, minor, _ = version.split(".")
    return f"0.{minor}" if major == "0" else major


def soname(version):
    return "libhalfspace.so." + interface(version)


def wanted(version):
    """The versions of this interface that know no less, as pkg-config has it, behind `halfspace >= `."""
    leading, _, last = interface(version).rpartition(".")
    after = f"{leading}.{int(last) + 1}" if leading else str(int(last) + 1)
    return f"{version.rpartition('.')[0]}, halfspace < {after}"


def header(root, version):
    """The macros HS_VERSION_..."""
    text = (root / HEADER).read_text(encoding="utf-8")
    for part, number in zip(("MAJOR", "MINOR", "PATCH"), version.split(".")):
        text = replaced(text, rf"#define HS_VERSION_{part} (\d+)", number, HEADER)
    return text


def stating(root, path, statement, version):
    """The text of a file in which the group of every `statement` is the version."""
    return replaced((root / path).read_text(encoding="utf-8"), statement, version, path)


def replaced(text, statement, version, path):
    text, count = re.subn(statement, lambda found: found.group().replace(found.group(1), version), text)
    if count == 0:
        raise Fault(f"{path} states no version")
    return text
