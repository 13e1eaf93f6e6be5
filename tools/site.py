"""Hooks and an extension that MkDocs uses, besides mkdocs.yml, to make a site from docs/ (./isolaw.sh site).

Pages link to files of the project outside docs/, such as ../LICENSE. The site gets a copy of each such file, as text
that every browser shows, and for a folder a list of its files.
"""

import pathlib
import posixpath
import re

import griffe
from mkdocs.structure.files import File

ROOT = pathlib.Path(__file__).resolve().parents[1]
LINK = re.compile(r"(?<=\]\()\.\./[^)\s#]+")


def outside(page, link):
    """Returns the path of the file or folder that a link names if it exists in the project outside docs/, else None."""
    path = posixpath.normpath(posixpath.join("docs", posixpath.dirname(page.src_uri), link))
    return None if path.startswith("docs/") or not (ROOT / path).exists() else path


def on_files(files, config):
    search = ROOT / "node_modules/iframe-worker/shim/index.js"
    files.append(File.generated(config, "iframe-worker.js", abs_src_path=str(search)))
    links = ((page, link) for page in files.documentation_pages() for link in LINK.findall(page.content_string))
    for path in {outside(*one) for one in links} - {None}:
        source = ROOT / path
        if source.is_dir():
            names = sorted(one.name for one in source.iterdir() if one.is_file())
            how = {"content": "\n".join([f"The files of {path}/ in isolaw:", *names, ""])}
        else:
            how = {"abs_src_path": str(source)}
        files.append(File.generated(config, f"source/{path}.txt", **how))
    return files


def on_page_markdown(markdown, page, **_):
    def in_site(link):
        path = outside(page.file, link[0])
        here = posixpath.dirname(page.file.src_uri) or "."
        return posixpath.relpath(f"source/{path}.txt", here) if path else link[0]

    # CommonMark begins a list right below a paragraph; Python-Markdown needs an empty line between them.
    parts = re.split(r"(^```.*?^```$)", LINK.sub(in_site, markdown), flags=re.M | re.S)
    above_a_list = re.compile(r"^(?![-*] |\d+\. |\s|$)(.+\n)(?=([-*]|1\.) )", re.M)
    return "".join(part if part.startswith("```") else above_a_list.sub(r"\1\n", part) for part in parts)


class Docstrings(griffe.Extension):
    """Takes signatures from the stub, and turns docstrings into Markdown: examples become code, parameters a list."""

    def on_package(self, *, pkg, **_):
        file = ROOT / "python/isolaw/__init__.pyi"
        stub = griffe.visit("isolaw", filepath=file, code=file.read_text())
        pkg.set_member("Record", stub["Record"])  # compiled: the package has only its name
        self.mend(pkg, stub)

    def mend(self, thing, stub):
        for name, member in thing.members.items():
            if not member.is_alias:
                self.mend(member, stub.members.get(name) if stub else None)
        if thing.is_function and stub:
            thing.parameters = stub.parameters
        if not thing.docstring:
            return
        text = re.sub(r"((?:^(?:>>>|\.\.\.) .*(?:\n|\Z))+)", r"```pycon\n\1\n```\n", thing.docstring.value, flags=re.M)
        function = thing.members.get("__init__") if thing.is_class else thing
        names = "|".join(one.name for one in getattr(function, "parameters", ()) if one.name != "self")
        if names:
            # Finds names of parameters before a colon, at the start of a line or sentence. Each may have a remark in
            # brackets.
            one = rf"(?:{names})(?:\s\([^)]*\))?"
            explained = re.compile(rf"(?:^|(?<=[.)])\s)({one}(?:,\s+{one})*): ", re.M)
            text = explained.sub(lambda found: "\n- *" + " ".join(found[1].split()) + "*: ", text)
            text = re.sub(r"(?<=\.)\s+(?=(?:Returns|Raises) )", "\n\n", text.replace("\n- ", "\n\n- ", 1))
        thing.docstring.value = text
