// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/cases/case_names.h"

#include <string_view>

#include "geometry/util/lower_case.h"
#include "instruments/builtin_tooth.h"
#include "session/io/unicode_text.h"

namespace tactooth {

namespace {

/// Independent of the locale, so that a name gives the same case everywhere.
bool isPlain(char letter) {
    return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') || (letter >= '0' && letter <= '9') ||
           letter == '_';
}

}  // namespace

NamedSurface surfaceNamed(const std::filesystem::path& file, const MaterialRegistry& materials) {
    const std::string stem = file.stem().string();
    const std::size_t split = stem.find_last_of("_- ");
    const std::string last = toLowerCase(split == std::string::npos ? stem : stem.substr(split + 1));
    for (const std::string_view word : {"bone", "jaw", "gum", "gums", "gingiva", "mandible", "maxilla"}) {
        if (last == word) return {stem, std::nullopt, true};
    }
    if (split == std::string::npos || split == 0) return {stem, std::nullopt, false};
    const std::string body = stem.substr(0, split);
    if (last == "outer" || last == "whole") return {body, std::nullopt, false};
    if (const auto id = materials.find(last)) return {body, id, false};
    return {stem, std::nullopt, false};
}

int fdiNamed(const std::string& name, const std::optional<int>& quadrant) {
    const std::size_t digits = name.find_last_not_of("0123456789") + 1;  // npos + 1 = 0
    const std::string number = name.substr(digits);
    if (number.size() == 2 && isPermanentTooth(std::stoi(number))) return std::stoi(number);
    if (quadrant && number.size() == 1 && number[0] >= '1' && number[0] <= '8')
        return *quadrant * 10 + (number[0] - '0');
    return 0;
}

std::string EntryNames::make(const std::string& name) {
    constexpr std::size_t kLongest = 80;  // letters: with folder and ending a path that every system accepts
    std::string plain;
    for (const char letter : name.substr(0, kLongest)) plain += isPlain(letter) ? letter : '-';
    std::string entry = plain;
    for (int number = 2; !taken_.insert(toLowerCase(entry)).second; ++number) {
        entry = plain + "-" + std::to_string(number);
    }
    return entry;
}

std::string BodyNames::make(const std::string& name) {
    constexpr std::size_t kLongest = 56;  // bytes: 60 with a number behind it
    std::string text = composed(validUtf8(name));
    for (char& letter : text) {
        if (static_cast<unsigned char>(letter) < 0x20 || letter == 0x7f || letter == '/' || letter == '\\')
            letter = '-';
    }
    const auto isInsideLetter = [&](std::size_t at) { return (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80; };
    if (text.size() > kLongest) {
        std::size_t end = kLongest;
        while (isInsideLetter(end)) --end;
        text.resize(end);
    }
    std::string unique = text;
    for (int number = 2; !taken_.insert(unique).second; ++number) unique = text + "-" + std::to_string(number);
    return unique;
}

}  // namespace tactooth
