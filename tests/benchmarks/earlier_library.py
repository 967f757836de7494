"""Builds the library of an earlier revision."""
import pathlib
import subprocess

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
LAST_RELEASE = (HERE / 'last_release').read_text().strip()
ONLY_THE_LIBRARY = ['-DCMAKE_BUILD_TYPE=Release'] + [
    f'-DHALFSPACE_BUILD_{part}=OFF'
    for part in ('CLI', 'TESTS', 'BENCHMARKS', 'DOCS', 'BOX2D', 'PYTHON', 'FORTRAN', 'RUST', 'LAMMPS')]


def library_of(revision, build):
    """The folder that holds the library of a revision, which is built unless it is there. It has the name there by
    which the programs of this build ask for theirs."""
    commit = subprocess.run(['git', 'rev-parse', '--short', revision + '^{commit}'], cwd=ROOT, check=True,
                            capture_output=True, text=True).stdout.strip()
    place = ROOT / 'build' / commit
    if not list((place / 'capi').glob('libhalfspace.so')):
        source = place / 'source'
        source.mkdir(parents=True, exist_ok=True)
        archive = subprocess.run(['git', 'archive', commit], cwd=ROOT, check=True, capture_output=True).stdout
        subprocess.run(['tar', '-x'], cwd=source, input=archive, check=True)
        subprocess.run(['cmake', '-G', 'Ninja', '-S', source, '-B', place, *ONLY_THE_LIBRARY], check=True)
        subprocess.run(['cmake', '--build', place, '--target', 'halfspace'], check=True)
    for name in (library.name for library in (build / 'capi').glob('libhalfspace.so.*')):
        if not (place / 'capi' / name).exists():
            (place / 'capi' / name).symlink_to('libhalfspace.so')
    return commit, place / 'capi'
