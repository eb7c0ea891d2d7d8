// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/io/stl_sniffer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "geometry/io/stl_format.h"
#include "geometry/util/byte_text.h"
#include "geometry/util/messages.h"

namespace tactooth::stl {
namespace {

/// Number of bytes that decide between text and binary.
constexpr std::size_t kBeginning = 512;

std::uint32_t declaredCount(std::span<const std::byte> bytes) {
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + kHeaderBytes, sizeof count);
    return count;
}

std::uint64_t binarySize(std::uint32_t count) { return kFirstRecord + std::uint64_t{count} * kRecordBytes; }

std::string_view beginningOf(std::span<const std::byte> bytes) {
    return asText(bytes.first(std::min(bytes.size(), kBeginning)));
}

bool isText(std::string_view text) {
    return std::none_of(text.begin(), text.end(), [](unsigned char letter) {
        return letter < 0x20 && letter != '\t' && letter != '\n' && letter != '\v' && letter != '\f' && letter != '\r';
    });
}

bool beginsWithSolid(std::string_view text) {
    text = withoutByteOrderMark(text);
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    constexpr std::string_view kSolid = "solid";
    const auto same = [](char letter, char wanted) { return (letter | 0x20) == wanted; };
    return text.size() >= kSolid.size() && std::equal(kSolid.begin(), kSolid.end(), text.begin(),
                                                      [&](char wanted, char letter) { return same(letter, wanted); });
}

/// Whether the first record holds numbers that a surface may have. One random record in 2,000 does: a float with random
/// bits is in this range every second time, and there are twelve.
bool firstRecordIsPlausible(std::span<const std::byte> bytes) {
    if (bytes.size() < kFirstRecord + kRecordBytes) return true;
    std::array<float, 12> numbers;
    std::memcpy(numbers.data(), bytes.data() + kFirstRecord, sizeof numbers);
    return std::all_of(numbers.begin() + 3, numbers.end(), [](float number) {
        return number == 0.0F || (std::abs(number) > 1e-30F && std::abs(number) < 1e10F);
    });
}

/// The name of another format whose signature the file has, or nothing.
const MessageText* otherFormat(std::string_view text) {
    struct Mark {
        std::string_view bytes;
        const MessageText* format;
    };
    static constexpr std::array kMarks = {Mark{"ply\n", &msg::kPlyMesh},
                                          Mark{"ply\r", &msg::kPlyMesh},
                                          Mark{"PK\x03\x04", &msg::kZipArchive},
                                          Mark{"\x1f\x8b", &msg::kGzipArchive},
                                          Mark{"\x89PNG", &msg::kPngPicture},
                                          Mark{"OFF", &msg::kOffMesh},
                                          Mark{"\xff\xd8\xff", &msg::kJpegPicture},
                                          Mark{"%PDF", &msg::kPdfDocument},
                                          Mark{"\x7f"
                                               "ELF",
                                               &msg::kProgram},
                                          Mark{{"\0\5\x16\7", 4}, &msg::kMacNotes}};
    for (const Mark& mark : kMarks) {
        if (text.starts_with(mark.bytes)) return mark.format;
    }
    return text.size() >= 132 && text.substr(128, 4) == "DICM" ? &msg::kDicomImage : nullptr;
}

Error notStl(const std::string& name, const MessageText& what) { return {msg::kNotStl, name, what}; }

Error wrongCount(std::span<const std::byte> bytes, const std::string& name) {
    const std::uint32_t count = declaredCount(bytes);
    const bool tooShort = bytes.size() < binarySize(count);
    return {msg::kStlWrongCount, name,        tooShort ? msg::kStlCutShort : msg::kStlTooLong, count,
            binarySize(count),   bytes.size()};
}

}  // namespace

Kind sniff(std::span<const std::byte> bytes) {
    if (bytes.size() >= kFirstRecord && bytes.size() == binarySize(declaredCount(bytes))) return Kind::Binary;
    const std::string_view beginning = beginningOf(bytes);
    return beginsWithSolid(beginning) && isText(beginning) ? Kind::Ascii : Kind::Neither;
}

Error explainRefusal(std::span<const std::byte> bytes, const std::string& name) {
    if (bytes.empty()) return {msg::kFileEmpty, name};
    const std::string_view beginning = beginningOf(bytes);
    if (const MessageText* const other = otherFormat(beginning)) return notStl(name, *other);
    if (isText(beginning)) return notStl(name, msg::kTextWithoutSolid);
    if (bytes.size() < kFirstRecord) {
        return {msg::kStlTooShort, name, bytes.size(), kFirstRecord};
    }
    return firstRecordIsPlausible(bytes) ? wrongCount(bytes, name) : notStl(name, msg::kUnknownBinary);
}

}  // namespace tactooth::stl
