# Copyright (c) falko_slam contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the documents say of topics, services, parameters and files is what there is."""
import pathlib
import re
import subprocess
from xml.etree import ElementTree

import pytest

SOURCE = pathlib.Path(__file__).resolve().parents[2]
NODELETS = SOURCE / "src" / "nodelets"
PLUGINS = [entry.get("type").split("::")[1] for entry in
           ElementTree.parse(SOURCE / "nodelet_plugins.xml").iter("class")]
CONSTANTS = dict(re.findall(r'constexpr char (k\w+)\[\] = "([^"]+)"',
                            (SOURCE / "include/falko_slam/ros_bridge/topics.hpp").read_text()))
# What libraries publish and serve for a nodelet.
OF_LIBRARIES = {"tf", "tf_static", "/diagnostics", "/clock"}


def section(nodelet):
    text = (SOURCE / "doc" / "nodelets.md").read_text()
    found = re.search(rf"^## {nodelet}\n(.*?)(?=^## |\Z)", text, re.MULTILINE | re.DOTALL)
    assert found, f"doc/nodelets.md has no section {nodelet}"
    return found[1]


def sources_of(type_name):
    """The header of a nodelet's class, what it is made of, and what it includes of this folder."""
    header = next(path for path in NODELETS.glob("*.hpp")
                  if re.search(rf"class {type_name}\b[^;]*\{{", path.read_text()))
    found = set()
    todo = [header.name]
    while todo:
        name = todo.pop()
        if name in found:
            continue
        found.add(name)
        of_it = [path for path in NODELETS.glob("*.cpp") if f'#include "{name}"' in path.read_text()
                 and (name == header.name or path.stem == name[:-4])]
        for path in of_it + [NODELETS / name]:
            found.add(path.name)
            todo += [include for include in re.findall(r'#include "(\w+\.hpp)"', path.read_text())
                     if (NODELETS / include).exists()]
    return [NODELETS / name for name in found]


def names_in_code(type_name):
    used = set()
    for path in sources_of(type_name):
        for statement in path.read_text().split(";"):
            if re.search(r"advertise|ubscribe", statement):
                used |= set(re.findall(r"topics::(k\w+)", statement))
    return {CONSTANTS[name] for name in used}


def names_in_tables(text):
    for row in re.findall(r"^\| ([^|]+) \|", text, re.MULTILINE):
        yield from re.findall(r"`([^`]+)`", row)


def last_part(name):
    return name if name.startswith("/") else name.split("/")[-1]


@pytest.mark.parametrize("type_name", PLUGINS)
def test_every_topic_and_service_stands_in_the_tables(type_name):
    documented = {last_part(name) for name in names_in_tables(section(type_name[:-len("Nodelet")]))}
    assert names_in_code(type_name) - OF_LIBRARIES - {"calibrate"} <= documented


@pytest.mark.parametrize("type_name", PLUGINS)
def test_the_tables_tell_of_nothing_else(type_name):
    documented = {last_part(name) for name in names_in_tables(section(type_name[:-len("Nodelet")]))}
    assert documented <= names_in_code(type_name) | OF_LIBRARIES | {"..."}


def test_parameters_are_those_of_the_files():
    done = subprocess.run([SOURCE / "scripts/document_parameters", "--check"], check=False,
                          capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize("path", sorted([*SOURCE.glob("*.md"), *SOURCE.glob("doc/**/*.md")]),
                         ids=lambda path: str(path.relative_to(SOURCE)))
def test_links_lead_to_files_and_headings(path):
    for target in re.findall(r"\]\(([^)\s]+)\)", path.read_text()):
        if target.startswith("http"):
            continue
        file, _, heading = target.partition("#")
        to = (path.parent / file).resolve() if file else path
        assert to.exists(), f"{path.name}: {target}"
        if heading:
            headings = re.findall(r"^#+ (.+)$", to.read_text(), re.MULTILINE)
            slugs = {re.sub(r"[^\w\- ]", "", text.lower()).replace(" ", "-") for text in headings}
            assert heading in slugs, f"{path.name}: {target}"


def test_messages_in_tables_exist():
    text = "".join(path.read_text() for path in [SOURCE / "README.md", *SOURCE.glob("doc/*.md")])
    for name in set(re.findall(r"falko_slam/([A-Z]\w+)", text)):
        there = [SOURCE / kind / f"{name}.{kind}" for kind in ("msg", "srv", "action")]
        plugin = f"{name}Nodelet" in PLUGINS
        action = name.endswith("ActionGoal")
        assert plugin or action or any(path.exists() for path in there), name


def test_the_tuning_guide_names_parameters():
    parameters = set(re.findall(r"^\| `([\w/]+)` \|", (SOURCE / "doc/parameters.md").read_text(), re.MULTILINE))
    text = (SOURCE / "doc/tuning.md").read_text()
    for name in set(re.findall(r"`([a-z_]+(?:/[a-z_]+)*)(?:: [^`]*)?`", text)):
        assert any(known == name or known.endswith("/" + name) for known in parameters), name
