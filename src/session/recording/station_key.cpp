// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/recording/station_key.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <string_view>
#include <utility>

#include "geometry/files/file_bytes.h"
#include "geometry/files/temporary_file.h"
#include "geometry/files/unfinished_files.h"
#include "geometry/files/write_refusal.h"
#include "geometry/util/byte_text.h"
#include "session/recording/messages.h"
#include "session/recording/recording_folder.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kFirstLine = "Tactooth station key 1\n", kPublic = "public ", kSecret = "secret ";
constexpr std::size_t kHexDigits = 64;
constexpr std::size_t kFileBytes = kFirstLine.size() + kPublic.size() + kSecret.size() + 2 * kHexDigits + 2;
constexpr std::size_t kMostBytes = 4096;

/// The next part of `text`, which is `before` and a line of hexadecimal digits; nothing for anything else.
std::optional<std::array<std::byte, 32>> takeLine(std::string_view& text, std::string_view before) {
    if (!text.starts_with(before) || text.size() < before.size() + kHexDigits + 1) return std::nullopt;
    const auto bytes = parseHex(text.substr(before.size(), kHexDigits));
    if (text[before.size() + kHexDigits] != '\n') return std::nullopt;
    text.remove_prefix(before.size() + kHexDigits + 1);
    return bytes;
}

/// Null if this is no key, or its two halves do not belong together.
std::shared_ptr<const SigningKey> parseKeyFile(std::string_view text) {
    if (text.size() != kFileBytes || !text.starts_with(kFirstLine)) return nullptr;
    text.remove_prefix(kFirstLine.size());
    const auto stated = takeLine(text, kPublic);
    auto seed = takeLine(text, kSecret);
    if (!stated || !seed) return nullptr;
    auto key = SigningKey::fromSeed(*seed);
    wipe(*seed);
    return key->publicKey().bytes == *stated ? key : nullptr;
}

std::string keyFileText(const SigningKey& key) {
    KeySeed seed = key.seed();
    std::string secret = hexText(seed);
    std::string text = std::string(kFirstLine).append(kPublic).append(keyText(key.publicKey())).append("\n");
    text.append(kSecret).append(secret).append("\n");
    wipe(seed);
    wipe(std::as_writable_bytes(std::span(secret)));
    return text;
}

Expected<StationKey> readKey(const fs::path& file) {
    const Expected<FileBytes> bytes = readFile(file, kMostBytes);
    if (!bytes) return Unexpected{bytes.error()};
    struct stat status {};
    if (::stat(file.c_str(), &status) == 0 && (status.st_mode & (S_IRWXG | S_IRWXO)) != 0) {
        return unexpected(msg::kStationKeyReadable, displayName(file));
    }
    std::shared_ptr<const SigningKey> key = parseKeyFile(bytes->text());
    if (key == nullptr) return unexpected(msg::kStationKeyDamaged, displayName(file));
    return StationKey{std::move(key), file, false};
}

/// Gives the file its name, unless there is one of that name already (EEXIST), and closes it. Returns an errno.
int link(TemporaryFile& temporary, const fs::path& file) {
    const auto lock = lockRenames();
    int failure = 0;
    if (temporary.name.empty()) {
        failure = linkUnnamed(temporary.descriptor, file.c_str());
    } else {
        failure = ::link(temporary.name.c_str(), file.c_str()) == 0 ? 0 : errno;
        ::unlink(temporary.name.c_str());
        unregisterUnfinished(temporary.name);
    }
    ::close(temporary.descriptor);
    return failure;
}

/// Writes a new key. Returns an errno; EEXIST if another program was faster.
int writeKey(const fs::path& file, const SigningKey& key) {
    TemporaryFile temporary;
    if (const int refused = openPrivateTemporary(file.parent_path(), temporary); refused != 0) return refused;
    std::string text = keyFileText(key);
    int failure = writeAll(temporary.descriptor, asBytes(text));
    if (failure == 0 && ::fsync(temporary.descriptor) != 0 && errno != EINVAL) failure = errno;
    wipe(std::as_writable_bytes(std::span(text)));
    if (failure == 0) {
        failure = link(temporary, file);
        if (failure == 0) syncFolder(file.parent_path());
        return failure;
    }
    if (!temporary.name.empty()) {
        const auto lock = lockRenames();
        ::unlink(temporary.name.c_str());
        unregisterUnfinished(temporary.name);
    }
    ::close(temporary.descriptor);
    return failure;
}

bool isThere(const fs::path& file) {
    std::error_code ignored;
    return fs::exists(fs::symlink_status(file, ignored));
}

}  // namespace

fs::path stationKeyFile() {
    const fs::path recordings = defaultRecordingFolder();
    return recordings.empty() ? fs::path() : recordings.parent_path() / "station.key";
}

Expected<StationKey> openStationKey(const fs::path& file) {
    if (file.empty()) return unexpected(msg::kStationKeyNowhere);
    if (isThere(file)) return readKey(file);
    std::error_code failure;
    fs::create_directories(file.parent_path(), failure);
    if (failure) return cannotWrite(file, failure.value());
    const std::shared_ptr<const SigningKey> key = SigningKey::make();
    const int refused = writeKey(file, *key);
    if (refused == EEXIST) return readKey(file);  // of another program that began at the same time
    if (refused != 0) return cannotWrite(file, refused);
    return StationKey{key, file, true};
}

std::optional<PublicKey> knownStationKey(const fs::path& file) {
    if (file.empty() || !isThere(file)) return std::nullopt;
    const Expected<StationKey> known = readKey(file);
    return known ? std::optional(known->key->publicKey()) : std::nullopt;
}

}  // namespace tactooth
