// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/watched_run.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <csignal>
#include <stdexcept>

#include "geometry/io/mesh_file.h"
#include "geometry/util/display_text.h"
#include "support/sanitizer.h"
#include "support/test_data.h"
#include "support/text_file.h"

namespace tactooth::test {
namespace {

constexpr double kMaxSeconds = 10;
constexpr std::size_t kMostBytes = std::size_t{1} << 30;
constexpr int kTimeoutMs = 300'000;

double secondsOf(const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// Starts the process in `folder`.
pid_t start(const std::vector<std::string>& arguments, const std::filesystem::path& folder, const std::string& out,
            const std::string& err) {
    std::vector<std::string> words = {TACTOOTH_PROGRAM};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addchdir_np(&files, folder.c_str());
    posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT, 0600);
    posix_spawn_file_actions_addopen(&files, STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT, 0600);
    pid_t process = 0;
    const int failure = ::posix_spawn(&process, TACTOOTH_PROGRAM, &files, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&files);
    if (failure != 0) throw std::runtime_error("cannot start " TACTOOTH_PROGRAM);
    return process;
}

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines(1);
    for (const char letter : text) {
        if (letter == '\n') {
            lines.emplace_back();
        } else {
            lines.back() += letter;
        }
    }
    if (lines.back().empty()) lines.pop_back();
    return lines;
}

/// Whether a word of a table or a text in JSON or TOML is a number that is not finite.
bool isNotFinite(std::string word) {
    std::ranges::transform(word, word.begin(), [](unsigned char letter) { return std::tolower(letter); });
    if (word.starts_with('-') || word.starts_with('+')) word.erase(0, 1);
    constexpr std::array<const char*, 3> kWords = {"nan", "inf", "infinity"};
    return std::ranges::find(kWords, word) != kWords.end();
}

bool hasNotFinite(const std::string& text) {
    std::string word;
    bool isQuoted = false;
    for (const char letter : text + " ") {
        if (letter == '"') isQuoted = !isQuoted;
        const bool isPart =
            std::isalnum(static_cast<unsigned char>(letter)) || letter == '-' || letter == '+' || letter == '.';
        if (isPart) {
            word += letter;
            continue;
        }
        if (!isQuoted && isNotFinite(word)) return true;
        word.clear();
    }
    return false;
}

}  // namespace

WatchedRun watchTactooth(const std::vector<std::string>& arguments, const std::filesystem::path& folder) {
    const TemporaryFolder streams;
    const std::string out = streams / "out", err = streams / "err";
    const pid_t process = start(arguments, folder, out, err);
    WatchedRun run;
    pollfd end{static_cast<int>(::syscall(SYS_pidfd_open, process, 0)), POLLIN, 0};  // its header is not C++
    run.isLate = ::poll(&end, 1, kTimeoutMs) == 0;
    if (run.isLate) ::kill(process, SIGKILL);
    int status = 0;
    rusage used{};
    ::wait4(process, &status, 0, &used);
    ::close(end.fd);
    run.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    run.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    run.out = readText(out);
    run.err = readText(err);
    run.processorSeconds = secondsOf(used.ru_utime) + secondsOf(used.ru_stime);
    run.peakBytes = static_cast<std::size_t>(used.ru_maxrss) * 1024;
    return run;
}

std::string faultOf(const WatchedRun& run) {
    if (run.isLate) return "it did not end";
    if (run.exitCode < 0) return "it was ended by signal " + std::to_string(run.signal);
    if (run.exitCode > 2) return "it ended with " + std::to_string(run.exitCode);
    if (!isSanitized() && run.processorSeconds > kMaxSeconds)
        return "it took " + std::to_string(run.processorSeconds) + " s";
    if (!isSanitized() && run.peakBytes > kMostBytes) return "it took " + std::to_string(run.peakBytes) + " bytes";
    for (const std::string& text : {run.out, run.err}) {
        for (const std::string& line : linesOf(text)) {
            if (!isShownAsItIs(line)) return "a stream holds what a terminal obeys: " + displayText(line);
        }
    }
    if (hasNotFinite(run.out)) return "it says a number that is not finite: " + run.out;
    if (run.exitCode != 2) return {};
    const std::vector<std::string> lines = linesOf(run.err);
    const auto isSentence = [](const std::string& line) { return line.starts_with("tactooth: "); };
    if (std::ranges::count_if(lines, isSentence) != 1 || !isSentence(lines.back())) {
        return "stderr is not one sentence: " + run.err;
    }
    return lines.back().ends_with('.') ? "" : "the sentence has no full stop: " + run.err;
}

std::string faultOfFiles(const std::filesystem::path& folder) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        const std::string ending = entry.path().extension();
        const bool isText = ending == ".csv" || ending == ".json" || ending == ".toml";
        if (isText && hasNotFinite(readText(entry.path()))) return entry.path().native() + " holds nan or inf";
        constexpr std::uintmax_t kHeadOfStl = 84;  // bytes: an STL file without triangles
        if (ending != ".stl" || entry.file_size() <= kHeadOfStl) continue;
        const auto mesh = loadMesh(entry.path());  // it accepts only finite corners
        if (!mesh) return mesh.error().message();
    }
    return {};
}

}  // namespace tactooth::test
