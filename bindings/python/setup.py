"""The version is that of the C interface; a package that bundles the shared library is for one platform."""
import pathlib
import re

from setuptools import Distribution, setup
from wheel.bdist_wheel import bdist_wheel

PACKAGE = pathlib.Path(__file__).parent / "halfspace"
BUNDLED = any(PACKAGE.glob("**/*.so*"))
VERSION = re.search(
    r"libhalfspace (\d+\.\d+\.\d+) ", (PACKAGE / "_raw.py").read_text(encoding="utf-8")
).group(1)


class PlatformWheel(bdist_wheel):
    """Bound to the platform, but to no version of Python: nothing here is compiled against one."""

    def get_tag(self):
        platform = super().get_tag()[2]
        return "py3", "none", platform


class PlatformDistribution(Distribution):
    def has_ext_modules(self):
        return BUNDLED


setup(version=VERSION, distclass=PlatformDistribution, cmdclass={"bdist_wheel": PlatformWheel})
