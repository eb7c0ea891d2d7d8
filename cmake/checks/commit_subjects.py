# SPDX-FileCopyrightText: 2026 The Tactooth authors
# SPDX-License-Identifier: Apache-2.0
"""Rules for the first line of a commit's message."""
import re

LONGEST = 72  # characters: what git log and the web pages show without cutting it off
ALLOWED = re.compile(r'(Merge (branch|commit|pull request|tag|remote-tracking branch)|Revert ")')
# Commands that end like a past tense or a gerund.
IMPERATIVES = {"Bring", "Embed", "Exceed", "Feed", "Need", "Proceed", "Seed", "Shed", "Speed", "String", "Swing", "Weed"}


def offences_in(subject):
    if ALLOWED.match(subject):
        return []
    if not subject.strip():
        return ["the subject is empty"]
    found = []
    first = re.match(r"[^\s:,]*", subject)[0]
    if not first[:1].isupper():
        found.append("begin with a capital letter")
    if re.search(r"(ed|ing)$", first) and first not in IMPERATIVES:
        found.append(f"use the imperative, not '{first}'")
    if subject.rstrip().endswith("."):
        found.append("leave out the full stop")
    if len(subject) > LONGEST:
        found.append(f"{len(subject)} characters, more than {LONGEST}")
    return found
