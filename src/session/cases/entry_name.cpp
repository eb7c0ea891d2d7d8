// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/cases/entry_name.h"

#include <algorithm>
#include <array>

#include "geometry/util/lower_case.h"
#include "session/cases/messages.h"
#include "session/io/unicode_text.h"

namespace tactooth {
namespace {

constexpr std::size_t kLongest = 1000;  // bytes: systems accept paths of 4096, with the folder before it

bool isControl(char letter) { return static_cast<unsigned char>(letter) < 0x20 || letter == 0x7f; }

bool isLetter(char letter) { return (letter >= 'A' && letter <= 'Z') || (letter >= 'a' && letter <= 'z'); }

bool isAbsolute(std::string_view path) {
    const bool hasDrive =
        path.size() >= 2 && isLetter(path[0]) && path[1] == ':' && (path.size() == 2 || path[2] == '/');
    return path.starts_with('/') || hasDrive;
}

/// Calls `take` with each part of a path until it returns false. Returns true if it never did.
template <class Take>
bool allParts(std::string_view path, Take take) {
    for (std::size_t begin = 0; begin <= path.size();) {
        const std::size_t end = std::min(path.find('/', begin), path.size());
        if (!take(path.substr(begin, end - begin))) return false;
        begin = end + 1;
    }
    return true;
}

}  // namespace

EntryName entryName(std::string_view written) {
    if (written.size() > kLongest) return {{}, EntryFault::TooLong};
    std::string path(written);
    std::ranges::replace(path, '\\', '/');
    if (isAbsolute(path)) return {{}, EntryFault::PathTraversal};
    std::string name;
    const bool isWithin = allParts(path, [&](std::string_view part) {
        if (part == "..") return false;
        if (!part.empty() && part != ".") name.append(name.empty() ? "" : "/").append(part);
        return true;
    });
    if (!isWithin) return {{}, EntryFault::PathTraversal};
    if (std::ranges::any_of(name, isControl)) return {{}, EntryFault::ControlCharacter};
    if (name.empty() || path.back() == '/') return {{}, EntryFault::NoFile};
    return {composed(name), EntryFault::None};
}

bool isSafeEntry(std::string_view path) { return entryName(path).fault == EntryFault::None; }

Message inWords(EntryFault fault, const std::string& name) {
    switch (fault) {
        case EntryFault::PathTraversal:
            return {msg::kEntryLeadsOut, name};
        case EntryFault::ControlCharacter:
            return {msg::kEntryControlCharacters, name};
        case EntryFault::TooLong:
            return {msg::kEntryTooLong, name};
        case EntryFault::NoFile:
            return {msg::kEntryNoFile, name};
        case EntryFault::None:
            break;
    }
    return {};
}

bool isSystemFile(std::string_view name) {
    static constexpr std::array<std::string_view, 4> kSystemNames = {"__macosx", "thumbs.db", "ehthumbs.db",
                                                                     "desktop.ini"};
    if (name.starts_with('.') && name != "." && name != "..") return true;
    return name == "Icon\r" || std::ranges::find(kSystemNames, toLowerCase(std::string(name))) != kSystemNames.end();
}

bool isSystemEntry(std::string_view path) {
    return !allParts(path, [](std::string_view part) { return !isSystemFile(part); });
}

}  // namespace tactooth
