# SPDX-FileCopyrightText: 2026 The Tactooth authors
# SPDX-License-Identifier: Apache-2.0
"""How many asserts the layers have that would go wrong silently without them."""
import re

# At least so many asserts per 1,000 lines.
FEWEST = {"src/collision": 10, "src/tooth": 10, "src/haptics": 10, "src/journal": 10}
ASSERT = re.compile(r"\bTACTOOTH_ASSERT\s*\(|\bstatic_assert\b")
DEFINITION = re.compile(r"#\s*define\s+TACTOOTH_ASSERT\b")


def densities(tree):
    """Layer: asserts per 1,000 lines."""
    found = {}
    for layer in FEWEST:
        files = [f for f in tree.cpp_files if f.name.startswith(layer + "/")]
        lines = sum(len(f.lines) for f in files)
        asserts = sum(len(ASSERT.findall(DEFINITION.sub("", f.code))) for f in files)
        if lines:  # a tree without the layer has nothing to count
            found[layer] = 1000 * asserts / lines
    return found


def check(tree, fewest=None):
    for layer, density in densities(tree).items():
        wanted = (fewest or FEWEST)[layer]
        if density < wanted:
            yield f"{layer}: {density:.1f} asserts per 1,000 lines, fewer than {wanted}"
