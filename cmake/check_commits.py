#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Tactooth authors
# SPDX-License-Identifier: Apache-2.0
"""Checks the subjects of commits: imperative, capital letter, no full stop, at most 72 characters.

Usage: check_commits.py [BASE..HEAD]
Without a range it checks what came after the commit of checks/first_checked_commit.txt. It ends with 77 (skipped) where
there is no git or the history does not reach that far back.
"""
import subprocess
import sys
from pathlib import Path

from checks.commit_subjects import offences_in

SKIPPED = 77
HERE = Path(__file__).resolve().parent


def git(*arguments):
    return subprocess.run(("git", "-C", str(HERE), *arguments), capture_output=True, text=True, check=False)


def first_checked_commit():
    lines = (HERE / "checks" / "first_checked_commit.txt").read_text(encoding="utf-8").splitlines()
    return next(line for line in lines if line and not line.startswith("#"))


def skip(reason):
    print(f"skipped: {reason}")
    sys.exit(SKIPPED)


def checked_range():
    base = first_checked_commit()
    try:
        found = git("cat-file", "-e", base + "^{commit}")
    except FileNotFoundError:
        skip("git is not installed")
    if found.returncode != 0:
        skip(f"this is no git repository, or its history lacks {base[:10]} (git fetch --unshallow)")
    return base + "..HEAD"


def main():
    span = sys.argv[1] if len(sys.argv) > 1 else checked_range()
    log = git("log", "--format=%h%x09%s", span, "--")
    if log.returncode != 0:
        sys.exit(log.stderr.strip())
    commits = [line.partition("\t") for line in log.stdout.splitlines()]
    found = [f"{commit} {subject}: {text}" for commit, _, subject in commits for text in offences_in(subject)]
    print(*found, f"{len(commits)} commits, {len(found)} offences", sep="\n")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
