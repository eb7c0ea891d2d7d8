// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/recording/recording_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <ctime>
#include <regex>

#include "geometry/files/file_bytes.h"
#include "geometry/files/temporary_file.h"
#include "geometry/files/unfinished_files.h"
#include "geometry/util/system_reason.h"
#include "journal/file/journal_file.h"
#include "session/recording/messages.h"
#include "session/recording/session_recorder.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::system_clock;

constexpr std::size_t kMaxTitleBytes = 80;  // the whole name stays far below the 255 bytes of a file's name
constexpr int kMostTries = 1000;            // names of one process, or of one minute

Clock::time_point writtenAt(const fs::path& file) {
    std::error_code ignored;
    const fs::file_time_type time = fs::last_write_time(file, ignored);
    if (ignored) return {};
    return std::chrono::time_point_cast<Clock::duration>(fs::file_time_type::clock::to_sys(time));
}

std::uint64_t sizeOf(const fs::path& file) {
    std::error_code gone;
    const std::uintmax_t bytes = fs::file_size(file, gone);
    return gone ? 0 : bytes;
}

/// The part of a title that any file system takes as a name: no signs that some forbid, whole characters.
std::string nameOf(const std::string& title) {
    std::string name;
    for (const char c : title) {
        const bool isForbidden = static_cast<unsigned char>(c) < ' ' || c == '\x7f' ||
                                 std::string_view("/\\:*?\"<>|").find(c) != std::string_view::npos;
        name += isForbidden ? '_' : c;
    }
    const auto isInside = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; };  // of a UTF-8 sign
    std::size_t end = std::min(name.size(), kMaxTitleBytes);
    while (end < name.size() && end > 0 && isInside(name[end])) --end;
    name.resize(end);
    while (name.ends_with(' ') || name.ends_with('.')) name.pop_back();
    return name;
}

bool isOurName(const std::string& name) {
    static const std::regex ours(R"(\d{4}-\d\d-\d\d \d\d\.\d\d.*\.ttsession)");
    return std::regex_match(name, ours);
}

bool isKept(const fs::path& file) { return file.extension() == kSessionFileEnding || file.extension() == ".tactooth"; }

/// The last number of "live-4711-12.ttsession": it grows with each file that begins. 0 for another name.
std::uint64_t orderOf(const fs::path& file) {
    static const std::regex form(R"((live|autosave)-\d+-(\d{1,18})\.\w+)");
    const std::string name = file.filename().string();
    std::smatch parts;
    return std::regex_match(name, parts, form) ? std::stoull(parts[2].str()) : 0;
}

bool isUnfinished(const fs::path& file) {
    const std::string name = file.filename().string();
    return name.starts_with("live-") || name.starts_with("autosave-");
}

/// The files of a folder that exists; none otherwise.
std::vector<fs::path> filesIn(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code failure;
    fs::directory_iterator file(folder, failure);
    for (; !failure && file != fs::directory_iterator(); file.increment(failure)) {
        std::error_code ignored;
        if (file->is_regular_file(ignored) && isKept(file->path())) files.push_back(file->path());
    }
    return files;
}

}  // namespace

fs::path defaultRecordingFolder() {
    const auto folder = [](const char* name) {
        const char* value = std::getenv(name);
        return fs::path(value != nullptr ? value : "");
    };
    constexpr const char* kBelow = "tactooth/recordings";
    // The XDG specification says to ignore a relative path.
    if (const fs::path own = folder("XDG_DATA_HOME"); own.is_absolute()) return own / kBelow;
    if (const fs::path home = folder("HOME"); home.is_absolute()) return home / ".local/share" / kBelow;
    return {};
}

std::string recordingName(Clock::time_point began, const std::string& title) {
    const std::time_t seconds = Clock::to_time_t(began);
    std::tm local{};
    ::localtime_r(&seconds, &local);
    std::array<char, 32> date{};
    std::strftime(date.data(), date.size(), "%Y-%m-%d %H.%M", &local);  // some file systems forbid a colon
    const std::string name = nameOf(title);
    return name.empty() ? std::string(date.data()) : std::string(date.data()) + ' ' + name;
}

/// A lock (flock) on a file, as its writer held one.
class Leftover::Lock {
public:
    explicit Lock(const fs::path& file) : descriptor_(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)) {
        if (descriptor_ < 0 || ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
        ::close(descriptor_);
        descriptor_ = -1;
    }
    ~Lock() {
        if (descriptor_ >= 0) ::close(descriptor_);
    }
    Lock(const Lock&) = delete;
    Lock& operator=(const Lock&) = delete;

    [[nodiscard]] bool isHeld() const { return descriptor_ >= 0; }

private:
    int descriptor_;
};

Leftover::Leftover(Kind kind, fs::path file, std::shared_ptr<Lock> lock)
    : kind_(kind), file_(std::move(file)), time_(writtenAt(file_)), order_(orderOf(file_)), lock_(std::move(lock)) {}

Expected<fs::path> RecordingFolder::freeName(const std::string& kind, const std::string& ending,
                                             const fs::path& before) const {
    std::error_code failure;
    fs::create_directories(folder_, failure);
    if (failure) return unexpected(msg::kRecordingFolderUnusable, displayName(folder_), systemReason(failure));
    std::uint64_t first = before.empty() ? 0 : orderOf(before) + 1;
    for (const fs::path& file : filesIn(folder_)) {
        if (isUnfinished(file)) first = std::max(first, orderOf(file) + 1);
    }
    for (std::uint64_t i = first; i < first + kMostTries; ++i) {
        fs::path name = folder_ / fmt::format("{}-{}-{}{}", kind, ::getpid(), i, ending);
        std::error_code ignored;
        if (!fs::exists(fs::symlink_status(name, ignored))) return name;
    }
    return unexpected(msg::kRecordingFolderUnusable, displayName(folder_), systemReason(EEXIST));
}

bool RecordingFolder::hasRoomFor(std::uint64_t bytes) const {
    std::error_code failure;
    fs::create_directories(folder_, failure);
    const fs::space_info space = fs::space(folder_, failure);
    if (failure || space.available < bytes) return false;
    TemporaryFile trial;  // a full quota or a folder that is read-only shows only when something is written
    if (openTemporary(folder_, trial) != 0) return false;
    const std::vector<std::byte> some(std::size_t{64} << 10);
    const bool isWritten = writeAll(trial.descriptor, some) == 0 && ::fdatasync(trial.descriptor) == 0;
    if (!trial.name.empty()) {
        ::unlink(trial.name.c_str());
        unregisterUnfinished(trial.name);
    }
    ::close(trial.descriptor);
    return isWritten;
}

Expected<fs::path> RecordingFolder::keep(const fs::path& file, Clock::time_point began,
                                         const std::string& title) const {
    const std::string name = recordingName(began, title);
    int failure = EEXIST;
    for (int i = 1; failure == EEXIST && i <= kMostTries; ++i) {
        const std::string numbered = i == 1 ? name : fmt::format("{} ({})", name, i);
        const fs::path kept = folder_ / (numbered + file.extension().string());
        // Unlike rename, it replaces no file, not even one that another program has just made.
        failure = ::renameat2(AT_FDCWD, file.c_str(), AT_FDCWD, kept.c_str(), RENAME_NOREPLACE) == 0 ? 0 : errno;
        if (failure == EINVAL) {  // of a file system that cannot do that
            failure = ::link(file.c_str(), kept.c_str()) == 0 ? 0 : errno;
            if (failure == 0) ::unlink(file.c_str());
        }
        if (failure == 0) {
            makeNewest(kept);
            return kept;
        }
    }
    return unexpected(msg::kRecordingNotRenamed, displayName(file), systemReason(failure));
}

/// After the clock was set back, its time would make it the first to be removed.
void RecordingFolder::makeNewest(const fs::path& file) const {
    fs::file_time_type newest = fs::file_time_type::min();
    std::error_code ignored;
    for (const fs::path& other : filesIn(folder_)) {
        if (other != file && isOurName(other.filename().string()))
            newest = std::max(newest, fs::last_write_time(other, ignored));
    }
    if (fs::last_write_time(file, ignored) <= newest && !ignored)
        fs::last_write_time(file, newest + std::chrono::milliseconds(1), ignored);
}

void RecordingFolder::discard(const fs::path& file) const {
    std::error_code ignored;
    fs::remove(file, ignored);
}

std::uint64_t RecordingFolder::bytes() const {
    std::uint64_t sum = 0;
    for (const fs::path& file : filesIn(folder_)) sum += sizeOf(file);
    return sum;
}

std::vector<fs::path> RecordingFolder::finished() const {
    std::vector<std::pair<Clock::time_point, fs::path>> found;
    for (const fs::path& file : filesIn(folder_)) {
        if (isOurName(file.filename().string())) found.emplace_back(writtenAt(file), file);
    }
    std::ranges::sort(found, std::greater());
    std::vector<fs::path> files;
    for (auto& [time, file] : found) files.push_back(std::move(file));
    return files;
}

void RecordingFolder::tidy() const {
    std::uint64_t all = bytes();
    if (all <= mostBytes_) return;
    std::vector<fs::path> oldestFirst = finished();
    std::ranges::reverse(oldestFirst);
    for (const fs::path& file : oldestFirst) {
        if (all <= mostBytes_) return;
        if (isBeingRecorded(file)) continue;  // somebody restores it
        const std::uint64_t freed = sizeOf(file);
        std::error_code failure;
        if (fs::remove(file, failure) && !failure) all -= std::min(all, freed);
    }
}

std::vector<Leftover> RecordingFolder::leftovers() const {
    std::vector<Leftover> found;
    for (const fs::path& file : filesIn(folder_)) {
        const std::string name = file.filename().string();
        const bool isRecording = name.starts_with("live-") && file.extension() == kSessionFileEnding;
        const bool isTooth = name.starts_with("autosave-") && file.extension() == ".tactooth";
        if (!isRecording && !isTooth) continue;
        auto lock = std::make_shared<Leftover::Lock>(file);
        if (!lock->isHeld()) continue;
        found.push_back(
            Leftover(isRecording ? Leftover::Kind::Recording : Leftover::Kind::Tooth, file, std::move(lock)));
    }
    std::ranges::sort(found, std::greater(),
                      [](const Leftover& leftover) { return std::pair(leftover.order_, leftover.time_); });
    return found;
}

}  // namespace tactooth
