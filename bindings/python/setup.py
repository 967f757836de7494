"""The version is that of the C interface. A package that holds the shared library is for one platform: build_wheel puts
it there, and in a checkout CMake builds it."""
import os
import pathlib
import re
import shutil
import subprocess
import sys

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py
from wheel.bdist_wheel import bdist_wheel

HERE = pathlib.Path(__file__).resolve().parent
PACKAGE = HERE / "halfspace"
SOURCES = HERE.parents[1]
IS_BUNDLED = any(PACKAGE.glob("**/*.so*"))
IS_BUILT_HERE = not IS_BUNDLED and (SOURCES / "capi" / "CMakeLists.txt").exists()
OTHER_PARTS = ("TESTS", "BENCHMARKS", "DOCS", "BOX2D", "FORTRAN", "PYTHON", "RUST", "LAMMPS")
RAW = (PACKAGE / "_raw.py").read_text(encoding="utf-8")
VERSION = re.search(r"libhalfspace (\d+\.\d+\.\d+) ", RAW).group(1)
SONAME = re.search(r'^SONAME = "(.+)"', RAW, re.MULTILINE).group(1)


class WithLibraries(build_py):
    """Builds the libraries of the kernel, of scenes and of the viewer, where none is bundled. Where the libraries that
    scenes need are missing, the kernel's alone."""

    def run(self):
        super().run()
        if not IS_BUILT_HERE:
            return
        build = pathlib.Path(self.get_finalized_command("build").build_temp).resolve() / "libhalfspace"
        if configure(build, with_scenes=True) != 0:
            print("halfspace: without scenes and the viewer; CMake has named what they need", file=sys.stderr)
            if configure(build, with_scenes=False) != 0:
                raise RuntimeError("CMake could not configure the library of the kernel")
        environment = {"CMAKE_BUILD_PARALLEL_LEVEL": str(os.cpu_count()), **os.environ}
        subprocess.run(["cmake", "--build", build], env=environment, check=True)
        package = pathlib.Path(self.build_lib) / "halfspace"
        copy_if_built(build / "capi" / SONAME, package)
        copy_if_built(build / "capi" / SONAME.replace("halfspace", "halfspace_scene"), package / "_scene_library")
        copy_if_built(build / "capi" / SONAME.replace("halfspace", "halfspace_viewer"), package)
        copy_if_built(build / "share/halfspace/viewer/viewer.html", package)


def configure(build, with_scenes):
    """CMake's exit code."""
    parts = [f"-DHALFSPACE_BUILD_{part}=OFF" for part in OTHER_PARTS]
    parts.append(f"-DHALFSPACE_BUILD_CLI={'ON' if with_scenes else 'OFF'}")
    return subprocess.run(["cmake", "-S", SOURCES, "-B", build, "-DCMAKE_BUILD_TYPE=Release", *parts]).returncode


def copy_if_built(file, folder):
    if file.exists():
        folder.mkdir(exist_ok=True)
        shutil.copy2(file, folder)


class PlatformWheel(bdist_wheel):
    """Bound to the platform, but to no version of Python: nothing here is compiled against one."""

    def get_tag(self):
        platform = super().get_tag()[2]
        return "py3", "none", platform


class PlatformDistribution(Distribution):
    def has_ext_modules(self):
        return IS_BUNDLED or IS_BUILT_HERE


setup(version=VERSION, distclass=PlatformDistribution, cmdclass={"bdist_wheel": PlatformWheel, "build_py": WithLibraries})
