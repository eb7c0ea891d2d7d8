# SPDX-FileCopyrightText: 2026 The Tactooth authors
# SPDX-License-Identifier: Apache-2.0
"""Which file may include which, as the CMake files say it.

The layers stand in the top CMakeLists.txt from the lowest to the highest; USES of tactooth_layer names those that a layer
includes, and through them those that they use. Inside a layer the FOLDERS of tactooth_layer or tactooth_folder_order
stand in order, too: a file may include files of its own folder and of those before it. Files directly in the parent
of these folders may include all of them, and no file of the folders may include such a file.
"""
import re

LAYER = re.compile(r"\btactooth_layer\s*\(([^)]*)\)")
ORDER = re.compile(r"\btactooth_folder_order\s*\(\s*(\S+)\s+FOLDERS\s+([^)]*)\)")
KEYWORDS = ("NAME", "FOLDERS", "SOURCES", "USES", "LINKS", "PRIVATE_LINKS")


class Architecture:
    def __init__(self, tree):
        self.layers = re.findall(r"add_subdirectory\s*\(\s*src/(\w+)\s*\)", tree.cmake_text("CMakeLists.txt"))
        self.uses = {}  # layer: all layers that it may include, itself too; only layers made by tactooth_layer
        self.orders = {}  # folder below src: its folders, lowest first
        for layer in self.layers:
            text = tree.cmake_text(f"src/{layer}/CMakeLists.txt")
            for call in LAYER.finditer(text):
                self._add_layer(call[1].split())
            for call in ORDER.finditer(text):
                self.orders[call[1]] = call[2].split()

    def _add_layer(self, words):
        lists, current = {}, None
        for word in words:
            if word in KEYWORDS:
                current = lists.setdefault(word, [])
            elif current is not None:
                current.append(word)
        name = lists["NAME"][0]
        uses = lists.get("USES", [])
        self.uses[name] = {name}.union(uses, *(self.uses.get(u, set()) for u in uses))
        if lists.get("FOLDERS"):
            self.orders[name] = lists["FOLDERS"]


def check(tree):
    architecture = Architecture(tree)
    for name in architecture.layers:
        yield from _unordered_folders(tree, name, architecture)
    for file in tree.cpp_files:
        if file.name.startswith("src/"):
            for line, included in file.includes:
                reason = why_not(file.name.removeprefix("src/"), included, architecture)
                if reason:
                    yield f"{file.name}:{line}: includes {included}: {reason}"


def _unordered_folders(tree, layer, architecture):
    """Folders that an order forgets, and folders that it names but that are not there."""
    for parent, order in architecture.orders.items():
        if parent.split("/")[0] == layer:
            paths = (tree.root / "src" / parent).glob("*/")
            with_code = {p.name for p in paths if any(p.rglob("*.h")) or any(p.rglob("*.cpp"))}
            for folder in sorted(with_code.difference(order)):
                yield f"src/{parent}/{folder}: is not in the FOLDERS of its CMakeLists.txt"
            for folder in sorted(set(order).difference(with_code)):
                yield f"src/{parent}/{folder}: is in the FOLDERS but not there; see its CMakeLists.txt"


def why_not(name, included, architecture):
    """Why a file below src may not include another one, or nothing where it may."""
    *folders, _ = name.split("/")
    *target, _ = included.split("/")
    if not folders or not target or target[0] not in architecture.layers:
        return ""
    layer, other = folders[0], target[0]
    if layer != other:
        if layer not in architecture.layers:
            return ""
        if architecture.layers.index(other) > architecture.layers.index(layer):
            return f"the layer {other} stands above {layer}"
        if layer in architecture.uses and other not in architecture.uses[layer]:
            return f"{layer} does not name {other} in its USES"
        return ""
    for depth in range(1, len(folders)):
        parent = "/".join(folders[:depth])
        order = architecture.orders.get(parent)
        own = folders[depth]
        its = target[depth] if depth < len(target) else None
        if order and own in order:
            if its is None:
                return f"it stands in src/{parent} itself, above the folder {own}"
            if its in order and order.index(its) > order.index(own):
                return f"the folder {its} stands after {own}"
        if own != its:
            return ""
    return ""
