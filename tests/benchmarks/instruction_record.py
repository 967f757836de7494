"""The record of instructions: instructions.txt, which the script `instructions` compares with and writes."""
import dataclasses
import math

from earlier_library import LAST_RELEASE

HEADER = f'''\
# Instructions that a step executes per block; of pairs, that hs_pair_detect() executes per call with a warm cache.
# tests/benchmarks/instructions counts them; here by this compiler on this machine, for the present library and for the
# release {LAST_RELEASE}, "-" where that lacks what the scene needs. To renew them:
#   tests/benchmarks/instructions build/release --update
#   tests/benchmarks/instructions build/release --update-release
'''
TITLE = f'{"scene":24} {"blocks":>8} {"now":>12} {LAST_RELEASE:>12}'


class Fault(Exception):
    """A fault that keeps counts from being compared."""


@dataclasses.dataclass
class Row:
    blocks: int
    now: float
    release: float = None  # None where it lacks what the scene needs, or has not been counted


def text_of(count):
    return '-' if count is None else f'{count:.1f}'


def count_of(text, where):
    try:
        count = float(text)
    except ValueError:
        raise Fault(f'{where}: "{text}" is not a number') from None
    if not (math.isfinite(count) and count > 0):
        raise Fault(f'{where}: "{text}" is not a count')
    return count


def row_of(cells, where):
    if len(cells) != 3 or not cells[0].isdecimal():
        raise Fault(f'{where}: a scene has a name, a whole number of blocks, and two counts')
    blocks, now, release = cells
    return Row(int(blocks), count_of(now, where), None if release == '-' else count_of(release, where))


class Record:
    def __init__(self, compiler, machine, rows):
        self.compiler, self.machine, self.rows = compiler, machine, rows

    def write(self, path):
        lines = [f'compiler: {self.compiler}', f'machine: {self.machine}', TITLE]
        lines += [f'{scene:24} {row.blocks:8} {text_of(row.now):>12} {text_of(row.release):>12}'
                  for scene, row in self.rows.items()]
        path.write_text(HEADER + '\n'.join(lines) + '\n')

    @staticmethod
    def read(path):
        try:
            lines = path.read_text().splitlines()
        except (OSError, UnicodeDecodeError) as error:
            raise Fault(f'{path} cannot be read: {error}') from None
        lines = [(f'{path}:{number}', line) for number, line in enumerate(lines, 1) if not line.startswith('#')]
        if len(lines) < 3:
            raise Fault(f'{path} is cut off: a record begins with compiler, machine and the title of its columns')
        about = []
        for (where, line), name in zip(lines, ('compiler: ', 'machine: ')):
            if not line.startswith(name):
                raise Fault(f'{where}: "{line}" in place of "{name}..."')
            about.append(line[len(name):])
        where, title = lines[2]
        if title != TITLE:
            raise Fault(f'{where}: the columns are not "{TITLE}": remove the file and renew it by --update')
        rows = {}
        for where, line in lines[3:]:
            scene, *cells = line.split() or ['']
            if scene in rows:
                raise Fault(f'{where}: {scene} is there twice')
            rows[scene] = row_of(cells, where)
        return Record(*about, rows)
