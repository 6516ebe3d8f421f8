"""Builds the compiled modules of the wheel with CMake; all the rest is in pyproject.toml.

The environment variable GRADMESH_BUILD names a folder in which CMake has built them already, for the
Python that runs this; without it they are built here.
"""

import os
import re
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from setuptools.errors import SetupError

SOURCE = Path(__file__).resolve().parent


def version():
    """The version that CMakeLists.txt gives the project."""
    return re.search(r"project\(gradmesh VERSION ([\d.]+)", (SOURCE / "CMakeLists.txt").read_text())[1]


class CMakeBuild(build_ext):
    """Lets CMake build the component `wheel` and install it where the wheel is put together."""

    def run(self):
        built = os.environ.get("GRADMESH_BUILD") or self.build()
        packages = SOURCE / "python" if self.inplace else Path(self.build_lib)
        options = ["--component", "wheel", "--prefix", packages.resolve(), "--strip"]
        subprocess.run(["cmake", "--install", built, *options], check=True)
        module = packages / self.get_ext_filename("gradmesh._core")
        if not module.exists():
            raise SetupError(f"{built} holds no module for this Python: {module.name}.")

    def build(self):
        values = {
            "CMAKE_BUILD_TYPE": "Release",
            "Python_EXECUTABLE": sys.executable,
            "GRADMESH_TESTS": "OFF",
            "GRADMESH_BENCHMARKS": "OFF",
        }
        defined = [f"-D{name}={value}" for name, value in values.items()]
        subprocess.run(["cmake", "-S", SOURCE, "-B", self.build_temp, *defined], check=True)
        # Without a number `make` would start as many compilers as there are files.
        options = ["--parallel", str(os.cpu_count()), "--target", "gradmesh_core", "gradmesh_images"]
        subprocess.run(["cmake", "--build", self.build_temp, *options], check=True)
        return self.build_temp


setup(
    version=version(),
    # Named so that the wheel is one for this machine and this Python.
    ext_modules=[Extension("gradmesh._core", sources=[])],
    cmdclass={"build_ext": CMakeBuild},
)
