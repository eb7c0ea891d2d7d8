// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// libsndfile corrects the lengths of its header at the end; a file that appears when it is complete cannot seek. Here
// the length is known before, and the header is the 44 bytes of RIFF/WAVE with one 'fmt ' and one 'data' chunk. A test
// compares every byte with the output of libsndfile.
#include "sound/files/wav_file.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "geometry/util/assert.h"
#include "sound/files/messages.h"
#include "sound/files/sound_format.h"

namespace tactooth {
namespace {

constexpr std::uint32_t kChannels = 2, kBits = 16;
constexpr std::uint32_t kFrameBytes = kChannels * kBits / 8;
constexpr std::uint32_t kHeadBytes = 44;
constexpr std::uint32_t kRiffHead = 8;  // bytes that its length does not count

class HeadWriter {
public:
    void word(const char (&letters)[5]) {
        for (int i = 0; i < 4; ++i) bytes_[at_++] = static_cast<std::byte>(letters[i]);
    }
    void number(std::uint32_t value, int bytes) {
        for (int i = 0; i < bytes; ++i, value >>= 8) bytes_[at_++] = static_cast<std::byte>(value);
    }
    [[nodiscard]] const std::array<std::byte, kHeadBytes>& bytes() const { return bytes_; }

private:
    std::array<std::byte, kHeadBytes> bytes_{};
    std::size_t at_ = 0;
};

std::array<std::byte, kHeadBytes> headFor(std::uint32_t dataBytes) {
    constexpr std::uint32_t kPcm = 1, kFormatBytes = 16;
    HeadWriter head;
    head.word("RIFF");
    head.number(kHeadBytes - kRiffHead + dataBytes, 4);
    head.word("WAVE");
    head.word("fmt ");
    head.number(kFormatBytes, 4);
    head.number(kPcm, 2);
    head.number(kChannels, 2);
    head.number(kSoundRate, 4);
    head.number(kSoundRate * kFrameBytes, 4);
    head.number(kFrameBytes, 2);
    head.number(kBits, 2);
    head.word("data");
    head.number(dataBytes, 4);
    return head.bytes();
}

/// Like libsndfile: in 32 bits, of which the upper ones stay.
std::int16_t pcmOf(float sample) {
    constexpr float kFull = 0x7FFFFFFF;  // 2^31 as a float
    const float scaled = sample * kFull;
    if (!(scaled > -kFull)) return std::isnan(scaled) ? std::int16_t{0} : std::numeric_limits<std::int16_t>::min();
    if (scaled >= kFull) return std::numeric_limits<std::int16_t>::max();
    return static_cast<std::int16_t>(static_cast<std::int32_t>(std::lrint(scaled)) >> kBits);
}

}  // namespace

Expected<WavWriter> WavWriter::create(const std::filesystem::path& path, std::size_t frames) {
    constexpr std::size_t kMaxFrames = (std::numeric_limits<std::uint32_t>::max() - kHeadBytes) / kFrameBytes;
    if (frames > kMaxFrames) {
        return unexpected(msg::kWavTooLong);
    }
    Expected<AtomicFile> file = AtomicFile::create(path);
    if (!file) return Unexpected{file.error()};
    file->write(headFor(static_cast<std::uint32_t>(frames * kFrameBytes)));
    return WavWriter(std::move(*file), frames * kChannels);
}

void WavWriter::write(std::span<const float> stereo) {
    TACTOOTH_ASSERT(stereo.size() <= remaining_);
    remaining_ -= stereo.size();
    chunk_.clear();
    for (const float sample : stereo) {
        const auto bits = static_cast<std::uint16_t>(pcmOf(sample));
        chunk_.push_back(static_cast<std::byte>(bits));
        chunk_.push_back(static_cast<std::byte>(bits >> 8));
    }
    file_.write(chunk_);
}

Expected<void> WavWriter::commit() {
    TACTOOTH_ASSERT(remaining_ == 0);
    return file_.commit();
}

Expected<void> writeWav(const std::filesystem::path& path, std::span<const float> stereo) {
    Expected<WavWriter> file = WavWriter::create(path, stereo.size() / kChannels);
    if (!file) return Unexpected{file.error()};
    constexpr std::size_t kPiece = std::size_t{1} << 16;
    for (std::size_t at = 0; at < stereo.size(); at += kPiece) {
        file->write(stereo.subspan(at, std::min(kPiece, stereo.size() - at)));
    }
    return file->commit();
}

}  // namespace tactooth
