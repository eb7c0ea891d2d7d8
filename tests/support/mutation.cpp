// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "support/mutation.h"

#include <algorithm>

namespace tactooth::test {
namespace {

constexpr std::size_t kHead = 100;  // bytes in which most formats keep their numbers
constexpr std::size_t kPiece = 60;  // bytes that are cut or moved at most

}  // namespace

std::size_t below(std::mt19937& random, std::size_t limit) { return random() % std::max<std::size_t>(limit, 1); }

void damage(std::string& bytes, std::span<const std::string> others, std::mt19937& random) {
    const std::string& other = others[below(random, others.size())];
    const std::size_t at = below(random, random() % 2 == 0 ? std::min(bytes.size(), kHead) : bytes.size());
    const std::size_t length = below(random, kPiece);
    switch (random() % 7) {
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
        default:
            bytes.insert(at, other.substr(below(random, other.size()), length));
    }
    if (bytes.empty()) bytes = other;
}

}  // namespace tactooth::test
