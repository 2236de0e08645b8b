"""Builds the compiled part with the project's CMake, so that there is one description of how."""
import os
import re
import shutil
import subprocess
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

source = Path(__file__).resolve().parents[2]
build = Path(os.environ.get("SNUG_BUILD", source / "build/release"))
version = re.search(r'SNUG_VERSION "(.*)"', (source / "include/snug/version.hpp").read_text()).group(1)


class CMake(build_ext):
    def build_extension(self, extension):
        if not (build / "CMakeCache.txt").exists():
            subprocess.run(["cmake", "--preset", "release", "-B", build], cwd=source, check=True)
        subprocess.run(["cmake", "--build", build, "--parallel", str(os.cpu_count()), "--target", "_snug"], check=True)
        target = Path(self.get_ext_fullpath(extension.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        for made in (target.name, "_snug.pyi"):
            shutil.copy2(build / "bindings/python/snug" / made, target.parent / made)


work = build / "bindings/python/wheel"
work.mkdir(parents=True, exist_ok=True)
setup(
    version=version,
    ext_modules=[Extension("snug._snug", [])],
    cmdclass={"build_ext": CMake},
    options={"build": {"build_base": str(work)}, "egg_info": {"egg_base": str(work)}},
)
