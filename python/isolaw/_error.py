"""The one exception of the package, in a module of its own for the compiled part."""


class Error(ValueError):
    """Wrong input, said once and completely.

    ``str(error)`` holds every problem found, a line for each. ``complaints`` is the same as a list of dicts with the
    texts ``where``, ``found``, ``allowed`` and ``advice``; empty texts say nothing.
    """

    complaints: list[dict[str, str]] = []


Error.__module__ = "isolaw"
