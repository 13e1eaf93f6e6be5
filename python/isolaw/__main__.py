"""The command ``isolaw``: ``pip install`` makes it, and ``python -m isolaw`` is the same."""

import os
import signal
import sys

from . import _core


def main():
    # Ctrl-C and a closed pipe end the command at once, as they end the program. Python's own handlers would wait until
    # the command returns.
    for number in (signal.SIGINT, signal.SIGPIPE):
        signal.signal(number, signal.SIG_DFL)
    # The name by which scripts that the command writes, such as those of `isolaw parts`, call it.
    name = "isolaw" if sys.argv[0] == __file__ else sys.argv[0]
    return _core.command([os.fsencode(word) for word in (name, *sys.argv[1:])])


if __name__ == "__main__":
    sys.exit(main())
