"""Writes what _alltact.pyi says of each class, function and property as C++: docstrings.py STUB OUT."""
import ast, sys


def said(body: list, before: str = ""):
    for node in body:
        if isinstance(node, (ast.ClassDef, ast.FunctionDef)):
            if text := ast.get_docstring(node):
                yield before + node.name, text
            if isinstance(node, ast.ClassDef):
                yield from said(node.body, f"{node.name}.")


if __name__ == "__main__":
    stub, out = sys.argv[1:]
    with open(stub, encoding="utf-8") as file:
        tree = ast.parse(file.read())
    with open(out, "w", encoding="utf-8") as file:
        for name, text in said(tree.body):
            file.write(f'{{"{name}", R"doc({text})doc"}},\n')
