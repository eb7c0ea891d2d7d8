// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/process/fault_log.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <optional>
#include <string_view>

#include "geometry/util/number_text.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::system_clock;

constexpr std::string_view kHead = "time,cause,device,force_n,zero_ms\n";
constexpr std::size_t kColumns = 5;
constexpr std::size_t kLongestName = 80;

/// An open file that is locked against other writers, and closed at the end.
class LockedFile {
public:
    explicit LockedFile(const fs::path& path)
        : file_(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, S_IRUSR | S_IWUSR)) {
        while (file_ >= 0 && flock(file_, LOCK_EX) != 0 && errno == EINTR) {
        }
    }
    ~LockedFile() {
        if (file_ >= 0) ::close(file_);  // unlocks
    }
    LockedFile(const LockedFile&) = delete;
    LockedFile& operator=(const LockedFile&) = delete;

    /// Only a regular file is a log.
    [[nodiscard]] bool isUsable() const {
        struct stat facts {};
        return file_ >= 0 && fstat(file_, &facts) == 0 && S_ISREG(facts.st_mode);
    }
    [[nodiscard]] std::size_t size() const {
        return static_cast<std::size_t>(std::max<off_t>(0, lseek(file_, 0, SEEK_END)));
    }
    [[nodiscard]] std::string from(std::size_t start) const {
        std::string text(size() - std::min(start, size()), '\0');
        const ssize_t count = pread(file_, text.data(), text.size(), static_cast<off_t>(start));
        text.resize(static_cast<std::size_t>(std::max<ssize_t>(0, count)));
        return text;
    }
    /// Writes at a place; the file ends behind it.
    [[nodiscard]] bool put(std::string_view text, std::size_t at) const {
        const ssize_t count = pwrite(file_, text.data(), text.size(), static_cast<off_t>(at));
        return count == static_cast<ssize_t>(text.size()) &&
               ftruncate(file_, static_cast<off_t>(at + text.size())) == 0;
    }

private:
    int file_;
};

/// A name without what separates fields and lines.
std::string fieldOf(std::string_view name) {
    std::string field(name.substr(0, kLongestName));
    std::ranges::replace_if(
        field, [](char c) { return c == ',' || c == '"' || static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }, ' ');
    return field;
}

std::string isoTime(Clock::time_point time) {
    const auto millis = std::chrono::floor<std::chrono::milliseconds>(time.time_since_epoch()).count();
    const std::time_t seconds = static_cast<std::time_t>(millis / 1000);
    std::tm parts{};
    gmtime_r(&seconds, &parts);
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%04d-%02d-%02dT%02d:%02d:%02d.%03dZ", parts.tm_year + 1900,
                  parts.tm_mon + 1, parts.tm_mday, parts.tm_hour, parts.tm_min, parts.tm_sec,
                  static_cast<int>(millis % 1000));
    return text.data();
}

/// The number of digits at a place of a text; none if something else is there.
std::optional<int> digits(std::string_view text, std::size_t at, std::size_t count) {
    return text.size() < at + count ? std::nullopt : toNumber<int>(text.substr(at, count));
}

std::optional<Clock::time_point> timeFrom(std::string_view text) {
    const auto year = digits(text, 0, 4), month = digits(text, 5, 2), day = digits(text, 8, 2);
    const auto hour = digits(text, 11, 2), minute = digits(text, 14, 2), second = digits(text, 17, 2);
    if (!year || !month || !day || !hour || !minute || !second) return std::nullopt;
    const std::chrono::year_month_day date{std::chrono::year(*year), std::chrono::month(static_cast<unsigned>(*month)),
                                           std::chrono::day(static_cast<unsigned>(*day))};
    if (!date.ok()) return std::nullopt;
    return std::chrono::sys_days(date) + std::chrono::hours(*hour) + std::chrono::minutes(*minute) +
           std::chrono::seconds(*second) + std::chrono::milliseconds(digits(text, 20, 3).value_or(0));
}

std::optional<FaultRecord> recordFrom(std::string_view line) {
    std::array<std::string_view, kColumns> fields;
    for (std::size_t i = 0; i < kColumns; ++i) {
        const std::size_t comma = line.find(',');
        if ((comma == std::string_view::npos) != (i + 1 == kColumns)) return std::nullopt;
        fields[i] = line.substr(0, comma);
        line.remove_prefix(std::min(line.size(), fields[i].size() + 1));
    }
    const auto time = timeFrom(fields[0]);
    const auto cause = findHandFault(fields[1]);
    const auto force = toNumber<double>(fields[3]);
    const auto toZero = toNumber<double>(fields[4]);
    const bool isWhole = time && cause && force && std::isfinite(*force) && toZero && std::isfinite(*toZero);
    if (!isWhole) return std::nullopt;
    return FaultRecord{*time, *cause, std::string(fields[2]), *force, 1e-3 * *toZero};
}

std::string lineOf(const FaultRecord& record) {
    const auto rounded = [](double value, double steps) {
        return numberText(std::isfinite(value) ? std::round(steps * value) / steps : 0);
    };
    return isoTime(record.time) + ',' + std::string(nameOf(record.cause)) + ',' + fieldOf(record.device) + ',' +
           rounded(record.force, 100) + ',' + rounded(1e3 * record.toZero, 10) + '\n';
}

/// The newer half of a log that has grown too large, from the beginning of a line on.
std::string newerHalf(const LockedFile& file) {
    std::string text = file.from(file.size() - std::min(file.size(), kMaxFaultLogBytes / 2));
    text.erase(0, std::min(text.size(), text.find('\n') + 1));
    return text;
}

}  // namespace

fs::path faultLogFile() {
    const auto folder = [](const char* variable) {
        const char* const value = std::getenv(variable);
        return fs::path(value != nullptr ? value : "");
    };
    fs::path state = folder("XDG_STATE_HOME");
    // The XDG specification says to ignore a relative path.
    if (!state.is_absolute() && folder("HOME").is_absolute()) state = folder("HOME") / ".local" / "state";
    return state.is_absolute() ? state / "tactooth" / "hand-faults.csv" : fs::path();
}

bool appendFault(const fs::path& path, const FaultRecord& record) {
    if (path.empty()) return false;
    std::error_code ignored;
    fs::create_directories(path.parent_path(), ignored);
    const LockedFile file(path);
    if (!file.isUsable()) return false;
    const std::string line = lineOf(record);
    const std::size_t size = file.size();
    if (size == 0) return file.put(std::string(kHead) + line, 0);
    if (size + line.size() <= kMaxFaultLogBytes) return file.put(line, size);
    return file.put(std::string(kHead) + newerHalf(file) + line, 0);
}

std::vector<FaultRecord> readFaults(const fs::path& path, std::size_t most) {
    std::vector<FaultRecord> records;
    const int file = path.empty() ? -1 : ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (file < 0) return records;
    std::string text(2 * kMaxFaultLogBytes, '\0');
    text.resize(static_cast<std::size_t>(std::max<ssize_t>(0, pread(file, text.data(), text.size(), 0))));
    ::close(file);
    for (std::string_view rest = text; !rest.empty();) {
        const std::string_view line = rest.substr(0, rest.find('\n'));
        rest.remove_prefix(std::min(rest.size(), line.size() + 1));
        if (auto record = recordFrom(line)) records.push_back(std::move(*record));
    }
    if (records.size() > most) records.erase(records.begin(), records.end() - static_cast<std::ptrdiff_t>(most));
    return records;
}

std::string faultTimeText(Clock::time_point time) {
    std::string text = isoTime(time);  // 2026-11-27T07:08:22.123Z
    text[10] = ' ';
    return text.substr(0, 19) + " UTC";
}

}  // namespace tactooth
