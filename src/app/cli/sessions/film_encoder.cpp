// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/sessions/film_encoder.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "app/cli/sessions/messages.h"
#include "geometry/files/atomic_file.h"
#include "geometry/files/file_bytes.h"
#include "geometry/util/display_text.h"
#include "sound/files/sound_format.h"

extern char** environ;

// ffmpeg reads and writes files of memory (memfd_create) by the names that /proc/self/fd gives them, so that nothing is
// left on the disk if this program or ffmpeg is ended.

namespace tactooth {
namespace {

constexpr int kFirstFile = 3;  // number of the first of the files that ffmpeg gets

std::string fileName(int number) { return fmt::format("/proc/self/fd/{}", kFirstFile + number); }

/// False if the reader has gone, or the memory is full.
bool writeAll(int file, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return true;
}

/// The container that ffmpeg makes for the ending of a name.
std::string formatOf(const std::filesystem::path& film) {
    return film.extension() == ".mkv" ? "matroska" : film.extension() == ".mov" ? "mov" : "mp4";
}

}  // namespace

/// A file in memory that has no name.
class FilmEncoder::MemoryFile {
public:
    MemoryFile() : file_(::memfd_create("tactooth-film", MFD_CLOEXEC)) {}
    ~MemoryFile() {
        if (file_ >= 0) ::close(file_);
    }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    [[nodiscard]] int number() const { return file_; }
    [[nodiscard]] bool write(std::span<const std::byte> bytes) const { return writeAll(file_, bytes); }

    /// Calls `visit` with the content, piece by piece.
    template <class Visit>
    void forEachPiece(const Visit& visit) const {
        std::vector<std::byte> piece(std::size_t{1} << 20);
        for (off_t at = 0;;) {
            const ssize_t count = ::pread(file_, piece.data(), piece.size(), at);
            if (count < 0 && errno == EINTR) continue;
            if (count <= 0) return;
            visit(std::span(piece).first(static_cast<std::size_t>(count)));
            at += count;
        }
    }
    [[nodiscard]] std::size_t size() const {
        struct stat facts {};
        return ::fstat(file_, &facts) == 0 ? static_cast<std::size_t>(facts.st_size) : 0;
    }

private:
    int file_;
};

std::optional<std::filesystem::path> findFfmpeg() {
    const char* const path = std::getenv("PATH");
    std::string rest = path != nullptr ? path : "";
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find(':'), rest.size());
        const std::filesystem::path file = std::filesystem::path(rest.substr(0, end)) / "ffmpeg";
        if (end > 0 && ::access(file.c_str(), X_OK) == 0) return file;
        rest.erase(0, end + 1);
    }
    return std::nullopt;
}

FilmEncoder::FilmEncoder(std::filesystem::path ffmpeg, std::filesystem::path film)
    : ffmpeg_(std::move(ffmpeg)),
      film_(std::move(film)),
      errors_(std::make_unique<MemoryFile>()),
      silent_(std::make_unique<MemoryFile>()) {}

FilmEncoder::~FilmEncoder() {
    if (encoder_.process == 0) return;
    ::kill(encoder_.process, SIGKILL);
    (void)waitFor(encoder_);
}

Expected<std::unique_ptr<FilmEncoder>> FilmEncoder::start(const std::filesystem::path& ffmpeg,
                                                          const std::filesystem::path& film, ImageSize size, int fps) {
    auto encoder = std::unique_ptr<FilmEncoder>(new FilmEncoder(ffmpeg, film));
    const std::vector<std::string> arguments = {"-f",
                                                "rawvideo",
                                                "-pixel_format",
                                                "rgba",
                                                "-video_size",
                                                fmt::format("{}x{}", size.width, size.height),
                                                "-framerate",
                                                std::to_string(fps),
                                                "-i",
                                                "pipe:0",
                                                "-c:v",
                                                "libx264",
                                                "-preset",
                                                "veryfast",
                                                "-crf",
                                                "20",
                                                "-pix_fmt",
                                                "yuv420p",
                                                "-f",
                                                formatOf(film),
                                                fileName(0)};
    Expected<Child> child = encoder->run(arguments, {encoder->silent_->number()}, true);
    if (!child) return Unexpected{child.error()};
    encoder->encoder_ = *child;
    return encoder;
}

/// Starts ffmpeg with these files as its files from kFirstFile on.
Expected<FilmEncoder::Child> FilmEncoder::run(const std::vector<std::string>& arguments, const std::vector<int>& files,
                                              bool withInput) const {
    std::vector<std::string> words = {ffmpeg_.native(), "-hide_banner", "-loglevel", "error", "-nostats", "-y"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    int pipe[2] = {-1, -1};
    if (withInput && ::pipe2(pipe, O_CLOEXEC) != 0) {
        return unexpected(msg::kFilmNotStarted, displayName(film_), displayName(ffmpeg_));
    }
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    // First far away from the numbers that they shall have: one of these may be the number of another file.
    constexpr int kAside = 100;
    const auto move = [&](int from, int to) { posix_spawn_file_actions_adddup2(&actions, from, to); };
    if (withInput) move(pipe[0], kAside);
    move(errors_->number(), kAside + 1);
    for (std::size_t i = 0; i < files.size(); ++i) move(files[i], kAside + 2 + static_cast<int>(i));
    if (withInput) {
        move(kAside, STDIN_FILENO);
    } else {
        posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    }
    move(kAside + 1, STDOUT_FILENO);
    move(kAside + 1, STDERR_FILENO);
    for (int i = 0; i < static_cast<int>(files.size()); ++i) move(kAside + 2 + i, kFirstFile + i);
    for (int i = withInput ? 0 : 1; i < 2 + static_cast<int>(files.size()); ++i) {
        posix_spawn_file_actions_addclose(&actions, kAside + i);
    }
    Child child;
    const int failed = ::posix_spawn(&child.process, ffmpeg_.c_str(), &actions, nullptr, pointers.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (withInput) ::close(pipe[0]);
    child.input = pipe[1];
    if (failed == 0) return child;
    if (withInput) ::close(pipe[1]);
    return unexpected(msg::kFilmNotStarted, displayName(film_), displayName(ffmpeg_));
}

/// Closes its input and waits for its end.
Expected<void> FilmEncoder::waitFor(Child& child) const {
    if (child.input >= 0) ::close(std::exchange(child.input, -1));
    int status = 0;
    while (::waitpid(child.process, &status, 0) < 0 && errno == EINTR) continue;
    child.process = 0;
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return {};
    return unexpected(msg::kFilmFailed, displayName(film_), lastWords());
}

/// The last line that ffmpeg has written, without control characters.
std::string FilmEncoder::lastWords() const {
    std::string text;
    errors_->forEachPiece([&](std::span<const std::byte> piece) {
        text.append(reinterpret_cast<const char*>(piece.data()), piece.size());
    });
    while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
    const std::size_t line = text.rfind('\n');
    return displayText(line == std::string::npos ? text : text.substr(line + 1));
}

Expected<void> FilmEncoder::add(const Image& image) {
    if (writeAll(encoder_.input, std::as_bytes(std::span(image.pixels)))) return {};
    if (auto ended = waitFor(encoder_); !ended) return ended;
    return unexpected(msg::kFilmFailed, displayName(film_), lastWords());
}

Expected<void> FilmEncoder::finish(std::span<const float> stereo) {
    if (auto encoded = waitFor(encoder_); !encoded) return encoded;
    MemoryFile sound, whole;
    const MemoryFile* result = silent_.get();
    if (!stereo.empty()) {
        if (!sound.write(std::as_bytes(stereo))) return unexpected(msg::kFilmFailed, displayName(film_), "memory");
        const std::vector<std::string> arguments = {
            "-i",   fileName(0), "-f",        "f32le",     "-ar",           std::to_string(kSoundRate),
            "-ac",  "2",         "-i",        fileName(1), "-c:v",          "copy",
            "-c:a", "aac",       "-shortest", "-f",        formatOf(film_), fileName(2)};
        Expected<Child> child = run(arguments, {silent_->number(), sound.number(), whole.number()}, false);
        if (!child) return Unexpected{child.error()};
        if (auto joined = waitFor(*child); !joined) return joined;
        result = &whole;
    }
    if (result->size() == 0) return unexpected(msg::kFilmFailed, displayName(film_), lastWords());
    Expected<AtomicFile> file = AtomicFile::create(film_);
    if (!file) return Unexpected{file.error()};
    result->forEachPiece([&](std::span<const std::byte> piece) { file->write(piece); });
    return file->commit();
}

}  // namespace tactooth
