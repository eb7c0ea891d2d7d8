#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Tactooth authors
# SPDX-License-Identifier: Apache-2.0
# check_spelling.sh: prints the words that codespell takes for misspelt, and fails if there are any. Words that are right
# are in checks/codespell-ignore.txt. It ends with 77 (skipped) where codespell is missing.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."

if ! command -v codespell >/dev/null; then
  echo "skipped: codespell is not installed (apt-get install codespell)"
  exit 77
fi
# Without codespell's list of British words: British spelling is right here. Names such as upTo are no words.
codespell --builtin clear,rare --ignore-words cmake/checks/codespell-ignore.txt --ignore-regex '\b[a-z]+[A-Z]\w*|\w+_\b' \
  --skip '*/corpus/*,*.ts,*.png,*.stl,*.json,__pycache__,codespell-ignore.txt' \
  README.md CONTRIBUTING.md CHANGELOG.md docs src include tests bench examples cmake
echo "no offences"
