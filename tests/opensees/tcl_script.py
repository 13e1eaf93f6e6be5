"""Runs a Tcl script in OpenSees as OpenSees.exe would: tcl_script.py FILE [ARGUMENTS...].

The package index has OpenSees only as a module of Python. This program lets Tcl's own interpreter read the script, and
passes every OpenSees command in it to that module, which parses arguments in the same way for both languages. It cannot
run the few commands that only OpenSees' Tcl program defines. It needs python3-tk and openseespy (tools/opensees.sh).
"""

import os
import sys
import tkinter

import openseespy.opensees as ops

tcl = tkinter.Tcl()


def number(word: str):
    for kind in (int, float):
        try:
            return kind(word)
        except ValueError:
            pass
    return word


def called(name: str, *words: str) -> str:
    # The last argument of `pattern Plain` is a block of commands. If any other argument has several words, it is a list
    # of values.
    block = words[-1] if name == "pattern" and words[0] == "Plain" else None
    arguments = []
    for word in words[:-1] if block is not None else words:
        parts = tcl.splitlist(word) if " " in word.strip() else (word,)
        arguments.extend(number(part) for part in parts)
    result = getattr(ops, name)(*arguments)
    if block is not None:
        tcl.eval(block)
    values = result if isinstance(result, (list, tuple)) else [] if result is None else [result]
    return " ".join(repr(value) if isinstance(value, float) else str(value) for value in values)


def end(code: str = "0") -> None:
    tcl.eval("flush stdout; flush stderr")
    os._exit(int(code))


tcl.createcommand("exit", end)
# Tcl's own command `load` loads libraries. OpenSees replaces this command by its own `load`, and so does this script.
builtin = set(tcl.splitlist(tcl.eval("info commands"))) - {"load"}
for command in dir(ops):
    if not command.startswith("_") and callable(getattr(ops, command)) and command not in builtin:
        tcl.createcommand(command, lambda *words, name=command: called(name, *words))

script = sys.argv[1]
tcl.setvar("argv0", script)
tcl.setvar("argv", tcl.call("list", *sys.argv[2:]))
tcl.setvar("argc", str(len(sys.argv) - 2))
try:
    tcl.evalfile(script)
except tkinter.TclError as error:
    print(error, tcl.getvar("errorInfo"), file=sys.stderr)
