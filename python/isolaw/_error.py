"""The only exception class of the package. It is in a module of its own because the compiled part imports it."""


class Error(ValueError):
    """Wrong input. One exception holds all problems.

    ``str(error)`` has a line for each problem. ``complaints`` has a dict for each, with the texts ``where``, ``found``,
    ``allowed`` and ``advice``, which may be empty.
    """

    complaints: list[dict[str, str]] = []


Error.__module__ = "isolaw"
