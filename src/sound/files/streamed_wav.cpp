// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/files/streamed_wav.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>

#include "geometry/util/byte_text.h"

// Microsoft and IBM, "Multimedia Programming Interface and Data Specifications 1.0" (1991); RF64: EBU Tech 3306 (2009).

namespace tactooth {
namespace {

constexpr std::size_t kFileHead = 12;                    // "RIFF", length, "WAVE"
constexpr std::size_t kChunkHead = 8;                    // name and length
constexpr std::size_t kLengthAt = 4;                     // in both
constexpr std::uint64_t kMinUnknownLength = 0x7FFFF000;  // from here on a length means: unknown
constexpr std::uint64_t kMax = std::numeric_limits<std::uint32_t>::max();

class Wav {
public:
    explicit Wav(std::vector<std::byte>& bytes) : bytes_(bytes) {}

    [[nodiscard]] std::size_t size() const { return bytes_.size(); }
    [[nodiscard]] bool isAt(std::size_t place, std::string_view word) const {
        return place + word.size() <= size() && asText(bytes_).substr(place, word.size()) == word;
    }
    [[nodiscard]] std::uint64_t number(std::size_t place, int count = 4) const {
        std::uint64_t value = 0;
        for (int i = count; i-- > 0;)
            value = value << 8 | std::to_integer<std::uint64_t>(bytes_[place + static_cast<std::size_t>(i)]);
        return value;
    }
    void write(std::size_t place, std::uint64_t value) {
        for (std::size_t i = 0; i < 4; ++i) bytes_[place + i] = static_cast<std::byte>(value >> (8 * i));
    }
    void write(std::size_t place, std::string_view word) {
        std::ranges::copy(asBytes(word), bytes_.begin() + static_cast<std::ptrdiff_t>(place));
    }

    /// Position of the chunk after the one at `place`; beyond the end if there is none.
    [[nodiscard]] std::size_t after(std::size_t place) const {
        const std::uint64_t length = number(place + kLengthAt);
        return static_cast<std::size_t>(place + kChunkHead + length + length % 2);
    }
    [[nodiscard]] std::optional<std::size_t> find(std::string_view name) const {
        for (std::size_t place = kFileHead; place + kChunkHead <= size(); place = after(place)) {
            if (isAt(place, name)) return place;
        }
        return std::nullopt;
    }
    /// Whether valid chunks follow one another from `place` to the end of the file, with names of letters.
    [[nodiscard]] bool isChunksFrom(std::size_t place) const {
        while (place + kChunkHead <= size()) {
            const std::string_view name = asText(bytes_).substr(place, 4);
            if (!std::ranges::all_of(name, [](char letter) { return letter >= ' ' && letter <= '~'; })) return false;
            place = after(place);
        }
        return place == size() || place == size() + 1;  // the last one may lack its padding byte
    }

private:
    std::vector<std::byte>& bytes_;
};

bool isMark(std::uint64_t length) { return length == 0 || length >= kMinUnknownLength; }

/// The length of the samples in the first chunk of an RF64 file.
std::uint64_t longLength(const Wav& wav) {
    constexpr std::size_t kSamplesAt = kChunkHead + 8;  // after the length of the file
    const auto place = wav.find("ds64");
    return place && *place + kSamplesAt + 8 <= wav.size() ? wav.number(*place + kSamplesAt, 8) : 0;
}

}  // namespace

void completeStreamedWav(std::vector<std::byte>& bytes) {
    Wav wav(bytes);
    const bool isLong = wav.isAt(0, "RF64");
    if ((!isLong && !wav.isAt(0, "RIFF")) || !wav.isAt(8, "WAVE") || wav.size() > kMax) return;
    const auto data = wav.find("data");
    if (!data) return;
    const std::uint64_t rest = wav.size() - *data - kChunkHead;
    std::uint64_t length = wav.number(*data + kLengthAt);
    if (isLong && length == kMax) length = longLength(wav);
    const bool isEmpty = length == 0 && wav.isChunksFrom(*data + kChunkHead);
    if (isMark(length) && !isEmpty) length = rest;
    const std::uint64_t file = wav.number(kLengthAt);
    const bool claimsComplete = !isLong && !isMark(file) && file + kChunkHead <= wav.size();
    if (claimsComplete) length = std::min(length, rest);
    if (isLong) {
        wav.write(0, "RIFF");
        if (const auto longs = wav.find("ds64")) wav.write(*longs, "JUNK");
    }
    wav.write(*data + kLengthAt, std::min(length, kMax));
    // Replaces a wrong length of the file, also that of a file that was cut off, by that of the samples.
    if (isLong || isMark(file)) wav.write(kLengthAt, std::min(kMax, *data + std::max(length, rest)));
}

}  // namespace tactooth
