// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/files/recording_file.h"

#include <algorithm>
#include <cctype>
#include <string>

#include "geometry/files/file_bytes.h"
#include "sound/files/memory_sound_file.h"
#include "sound/files/messages.h"
#include "sound/files/streamed_wav.h"

namespace tactooth {

namespace {

constexpr int kMaxChannels = 8;

std::uint32_t littleEndian(std::span<const std::byte> bytes) {
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;) value = value << 8 | std::to_integer<std::uint32_t>(bytes[i]);
    return value;
}

bool isAt(std::span<const std::byte> bytes, std::size_t place, std::string_view word) {
    if (place + word.size() > bytes.size()) return false;
    return std::equal(word.begin(), word.end(), bytes.begin() + static_cast<std::ptrdiff_t>(place),
                      [](char letter, std::byte byte) { return letter == std::to_integer<char>(byte); });
}

/// Whether the last page of an Ogg file is marked as the last.
bool hasLastPage(std::span<const std::byte> bytes) {
    constexpr std::size_t kFlagsAt = 5;
    constexpr unsigned kLast = 4;
    for (std::size_t place = bytes.size(); place-- > 0;) {
        if (isAt(bytes, place, "OggS") && place + kFlagsAt < bytes.size())
            return (std::to_integer<unsigned>(bytes[place + kFlagsAt]) & kLast) != 0;
    }
    return false;
}

/// libsndfile reads what is left of a file that was cut off; half of a loop is not what the user meant.
bool isCutOff(std::span<const std::byte> bytes, int kind) {
    if (kind == SF_FORMAT_OGG) return !hasLastPage(bytes);
    if (kind == SF_FORMAT_FLAC) return false;  // contains its length: reading comes up short
    constexpr std::size_t kLengthAt = 4, kHead = 8;
    return bytes.size() < kHead || littleEndian(bytes.subspan(kLengthAt, 4)) + std::uint64_t{kHead} > bytes.size();
}

/// The message of libsndfile, without its full stop and line ends.
std::string errorText(SNDFILE* file) {
    std::string reason = sf_strerror(file);
    std::replace_if(
        reason.begin(), reason.end(), [](unsigned char letter) { return std::iscntrl(letter) != 0; }, ' ');
    reason.erase(reason.find_last_not_of(" .") + 1);
    return reason;
}

Expected<void> check(const SF_INFO& info, std::span<const std::byte> bytes, const std::string& name) {
    const int kind = info.format & SF_FORMAT_TYPEMASK;
    if (kind != SF_FORMAT_WAV && kind != SF_FORMAT_WAVEX && kind != SF_FORMAT_FLAC && kind != SF_FORMAT_OGG)
        return unexpected(msg::kRecordingFormat, name);
    if (info.channels < 1 || info.channels > kMaxChannels) {
        return unexpected(msg::kRecordingChannels, name, info.channels);
    }
    const double longest = Recording::kMaxLength * std::clamp<double>(info.samplerate, 1.0, Recording::kMaxRate);
    if (info.frames < 0 || static_cast<double>(info.frames) > longest) return unexpected(msg::kRecordingTooLong, name);
    if (isCutOff(bytes, kind)) return unexpected(msg::kRecordingCutOff, name);
    return {};
}

Expected<std::vector<float>> readMono(SNDFILE* file, const SF_INFO& info, const std::string& name) {
    const auto channels = static_cast<std::size_t>(info.channels);
    std::vector<float> all(static_cast<std::size_t>(info.frames) * channels);
    if (sf_readf_float(file, all.data(), info.frames) != info.frames)
        return unexpected(msg::kRecordingDamaged, name, errorText(file));
    std::vector<float> mono(static_cast<std::size_t>(info.frames));
    for (std::size_t frame = 0; frame < mono.size(); ++frame) {
        for (std::size_t channel = 0; channel < channels; ++channel) mono[frame] += all[frame * channels + channel];
        mono[frame] /= static_cast<float>(channels);
    }
    return mono;
}

}  // namespace

Expected<Recording> parseRecording(std::span<const std::byte> bytes, std::string_view name) {
    const std::string who(name);
    if (!isAt(bytes, 0, "RIFF") && !isAt(bytes, 0, "RF64") && !isAt(bytes, 0, "fLaC") && !isAt(bytes, 0, "OggS"))
        return unexpected(msg::kRecordingFormat, who);
    MemoryFile memory{{bytes.begin(), bytes.end()}, 0};
    completeStreamedWav(memory.bytes);
    SF_INFO info{};
    const SoundFile file = openInMemory(memory, SFM_READ, info);
    if (file == nullptr) {
        return unexpected(msg::kRecordingNotRead, who, errorText(nullptr));
    }
    if (auto checked = check(info, memory.bytes, who); !checked) return Unexpected{checked.error()};
    const auto mono = readMono(file.get(), info, who);
    if (!mono) return Unexpected{mono.error()};
    return Recording::make(*mono, info.samplerate, who);
}

Expected<Recording> readRecording(const std::filesystem::path& path) {
    const Expected<FileBytes> file = readFile(path);
    if (!file) return Unexpected{file.error()};
    return parseRecording(file->bytes(), displayName(path));
}

}  // namespace tactooth
