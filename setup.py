"""Tags the wheel for the limited API only where the extension was built: without a compiler it is pure Python."""

import os

from setuptools import setup
from setuptools.command.bdist_wheel import bdist_wheel


class Wheel(bdist_wheel):
    """A wheel whose tag says what is in it."""

    def run(self) -> None:
        """Build the extension first, then decide on the tag."""
        self.run_command("build_ext")
        built = all(map(os.path.exists, self.get_finalized_command("build_ext").get_outputs()))
        if not built:
            self.distribution.ext_modules = []  # its files belong where pure packages lie
            self.root_is_pure, self.py_limited_api = True, False
        super().run()


setup(cmdclass={"bdist_wheel": Wheel})
