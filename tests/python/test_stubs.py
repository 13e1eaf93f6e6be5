"""Tests that the type stub lists exactly what the package has."""

import ast
import inspect
import pathlib
import unittest

import isolaw

STUB = ast.parse((pathlib.Path(isolaw.__file__).parent / "__init__.pyi").read_text())


def public(nodes):
    return [n for n in nodes if isinstance(n, (ast.FunctionDef, ast.ClassDef)) and not n.name.startswith("_")]


def parameters(node):
    """Returns name, kind and default of every parameter of a function of the stub."""
    a = node.args
    positional = a.posonlyargs + a.args
    defaults = [None] * (len(positional) - len(a.defaults)) + a.defaults
    found = {p.arg: (d if d is None else ast.literal_eval(d), False) for p, d in zip(positional, defaults)}
    found |= {p.arg: (d if d is None else ast.literal_eval(d), True) for p, d in zip(a.kwonlyargs, a.kw_defaults)}
    return found


def parameters_of(function):
    kinds = (inspect.Parameter.POSITIONAL_OR_KEYWORD, inspect.Parameter.KEYWORD_ONLY)
    return {
        name: (None if p.default is p.empty else p.default, p.kind is p.KEYWORD_ONLY)
        for name, p in inspect.signature(function).parameters.items()
        if p.kind in kinds
    }


class Stubs(unittest.TestCase):
    def test_every_public_name_is_in_both(self):
        stubbed = {node.name for node in public(STUB.body)} | {"__version__"}
        self.assertEqual(stubbed, set(isolaw.__all__))

    def test_functions_have_the_parameters_and_defaults_of_the_stub_and_a_docstring(self):
        for node in public(STUB.body):
            thing = getattr(isolaw, node.name)
            self.assertTrue(inspect.getdoc(thing), node.name)
            if isinstance(node, ast.FunctionDef):
                self.assertEqual(parameters(node), parameters_of(thing), node.name)

    def test_classes_have_the_members_of_the_stub_and_docstrings(self):
        for node in public(STUB.body):
            if not isinstance(node, ast.ClassDef):
                continue
            thing = getattr(isolaw, node.name)
            members = public(node.body)
            names = {member.name for member in members}
            own = {name for name in vars(thing) if not name.startswith("_")}
            if node.name != "Error":  # Error has only attributes, no methods
                self.assertEqual(names, own, node.name)
            for member in members:
                found = inspect.getattr_static(thing, member.name)
                self.assertTrue(inspect.getdoc(found), f"{node.name}.{member.name}")
                is_property = any(isinstance(d, ast.Name) and d.id == "property" for d in member.decorator_list)
                self.assertEqual(isinstance(found, property), is_property, f"{node.name}.{member.name}")
                if not is_property:
                    self.assertEqual(parameters(member), parameters_of(found), f"{node.name}.{member.name}")

    def test_docstrings_that_the_stub_repeats_are_those_of_the_package(self):
        record = next(node for node in STUB.body if getattr(node, "name", "") == "Record")
        self.assertEqual(inspect.cleandoc(ast.get_docstring(record)), inspect.getdoc(isolaw.Record))
        for member in public(record.body):
            found = inspect.getattr_static(isolaw.Record, member.name)
            self.assertEqual(ast.get_docstring(member), inspect.getdoc(found), member.name)

    def test_the_package_says_that_it_is_typed(self):
        self.assertTrue((pathlib.Path(isolaw.__file__).parent / "py.typed").exists())


if __name__ == "__main__":
    unittest.main()
