# SPDX-License-Identifier: MIT
"""The stubs name what is there, and all of it, with the same parameters and defaults."""
import ast
import inspect
import pathlib
import unittest

import similitude

place = pathlib.Path(similitude.__file__).parent


def public(names):
    return {n for n in names if not n.startswith("_") or n in ("__version__", "_repr_html_")}


def stub(name):
    return ast.parse((place / name).read_text()).body


def functions(body):
    return {n.name: n for n in body if isinstance(n, ast.FunctionDef)}


def classes(body):
    return {n.name: n for n in body if isinstance(n, ast.ClassDef)}


def names_of(body):
    return set(functions(body)) | {n.target.id for n in body if isinstance(n, ast.AnnAssign)}


class Stubs(unittest.TestCase):
    def test_the_package_is_typed(self):
        self.assertTrue((place / "py.typed").exists())

    def test_names_of_the_modules(self):
        for module, file in [(similitude, "__init__.pyi"), (similitude._core, "_core.pyi")]:
            body = stub(file)
            stated = public(names_of(body) | set(classes(body)))
            if module is similitude:
                stated |= {"InvalidInput"}
                self.assertEqual(stated - {"__version__"}, set(module.__all__))
            self.assertEqual(stated, public(n for n in vars(module) if not inspect.ismodule(vars(module)[n])), file)

    def test_names_of_the_classes(self):
        for module, file in [(similitude, "__init__.pyi"), (similitude._core, "_core.pyi")]:
            for name, node in classes(stub(file)).items():
                there = public(vars(getattr(module, name)))
                stated = public(names_of(node.body)) - {"units"}  # of an object, not of its class
                if name not in ("InvalidInput", "Result", "Curves", "Scale", "Heap", "Diagnosis"):
                    self.assertEqual(stated, there, name)
                self.assertLessEqual(stated, public(dir(getattr(module, name))), name)
        self.assertEqual(public(names_of(classes(stub("__init__.pyi"))["Result"].body)), public(vars(similitude.Result)))

    def test_parameters_and_defaults(self):
        body = stub("__init__.pyi")
        pairs = [(node, getattr(similitude, name)) for name, node in functions(body).items()]
        for name, node in classes(body).items():
            pairs += [(f, getattr(getattr(similitude, name), n)) for n, f in functions(node.body).items()]
        self.assertGreater(len(pairs), 8)
        for node, there in pairs:
            a = node.args
            stated = [(p.arg, ast.literal_eval(d)) for p, d in zip(a.kwonlyargs, a.kw_defaults)]
            given = inspect.signature(there).parameters.values()
            self.assertEqual(stated, [(p.name, p.default) for p in given if p.kind is p.KEYWORD_ONLY], node.name)
            self.assertEqual([p.arg for p in a.args], [p.name for p in given if p.kind is p.POSITIONAL_OR_KEYWORD], node.name)


if __name__ == "__main__":
    unittest.main()
