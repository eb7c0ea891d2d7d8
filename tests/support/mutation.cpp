// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "support/mutation.h"

#include <algorithm>
#include <string_view>

namespace tactooth::test {
namespace {

constexpr std::size_t kHead = 100;  // bytes that hold the numbers of most formats
constexpr std::size_t kPiece = 60;  // largest number of bytes that are cut or moved

/// Words that break readers of text.
constexpr std::string_view kWords[] = {"nan",
                                       "-inf",
                                       "1e999",
                                       "1e-999",
                                       "-1",
                                       "+",
                                       "99999999999999999999",
                                       "0x",
                                       "1979-05-27",
                                       "[[",
                                       "a.b.c",
                                       "[enamel]\n",
                                       "colour = [1,2]\n",
                                       "\"\"\"",
                                       "\\u12",
                                       "\"",
                                       "'",
                                       "{",
                                       "}",
                                       "[",
                                       "]",
                                       "=",
                                       ",",
                                       ":",
                                       "\n",
                                       "\r",
                                       "#",
                                       "\xff",
                                       "\xEF\xBB\xBF",
                                       "e",
                                       "true",
                                       "null"};

}  // namespace

std::size_t below(std::mt19937& random, std::size_t limit) { return random() % std::max<std::size_t>(limit, 1); }

void mutate(std::string& bytes, std::span<const std::string> others, std::mt19937& random) {
    const std::string& other = others[below(random, others.size())];
    const std::size_t at = below(random, random() % 2 == 0 ? std::min(bytes.size(), kHead) : bytes.size());
    const std::size_t length = below(random, kPiece);
    switch (random() % 8) {
        case 0:
            bytes[at] = static_cast<char>(random());
            break;
        case 1:
            bytes[at] = static_cast<char>(bytes[at] ^ (1 << random() % 8));
            break;
        case 2:
            bytes.erase(at, length);
            break;
        case 3:
            bytes.insert(at, bytes.substr(at, length));
            break;
        case 4:
            bytes.resize(at + 1);
            break;
        case 5:
            bytes.replace(at, std::min<std::size_t>(4, bytes.size() - at), 4, random() % 2 == 0 ? '\xff' : '\0');
            break;
        case 6:
            bytes.insert(at, kWords[below(random, std::size(kWords))]);
            break;
        default:
            bytes.insert(at, other.substr(below(random, other.size()), length));
    }
    if (bytes.empty()) bytes = other;
}

}  // namespace tactooth::test
