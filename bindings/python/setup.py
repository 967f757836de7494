"""The version is that of the C interface. A package that holds the shared library is for one platform: build_wheel puts
it there, and in a checkout CMake builds it."""
import pathlib
import re
import shutil
import subprocess

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py
from wheel.bdist_wheel import bdist_wheel

HERE = pathlib.Path(__file__).resolve().parent
PACKAGE = HERE / "halfspace"
SOURCES = HERE.parents[1]
IS_BUNDLED = any(PACKAGE.glob("**/*.so*"))
IS_BUILT_HERE = not IS_BUNDLED and (SOURCES / "capi" / "CMakeLists.txt").exists()
OTHER_PARTS = ("CLI", "TESTS", "BENCHMARKS", "DOCS", "BOX2D", "FORTRAN", "PYTHON", "RUST")
RAW = (PACKAGE / "_raw.py").read_text(encoding="utf-8")
VERSION = re.search(r"libhalfspace (\d+\.\d+\.\d+) ", RAW).group(1)
SONAME = re.search(r'^SONAME = "(.+)"', RAW, re.MULTILINE).group(1)


class WithLibrary(build_py):
    """Builds the kernel's library, without that of scenes and the viewer, where no library is bundled."""

    def run(self):
        super().run()
        if not IS_BUILT_HERE:
            return
        build = pathlib.Path(self.get_finalized_command("build").build_temp).resolve() / "libhalfspace"
        parts = [f"-DHALFSPACE_BUILD_{part}=OFF" for part in OTHER_PARTS]
        subprocess.run(["cmake", "-S", SOURCES, "-B", build, "-DCMAKE_BUILD_TYPE=Release", *parts], check=True)
        subprocess.run(["cmake", "--build", build, "--target", "halfspace", "--parallel"], check=True)
        shutil.copy2(build / "capi" / SONAME, pathlib.Path(self.build_lib) / "halfspace" / SONAME)


class PlatformWheel(bdist_wheel):
    """Bound to the platform, but to no version of Python: nothing here is compiled against one."""

    def get_tag(self):
        platform = super().get_tag()[2]
        return "py3", "none", platform


class PlatformDistribution(Distribution):
    def has_ext_modules(self):
        return IS_BUNDLED or IS_BUILT_HERE


setup(version=VERSION, distclass=PlatformDistribution, cmdclass={"bdist_wheel": PlatformWheel, "build_py": WithLibrary})
