// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/process/hand_process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <vector>

#include "devices/process/messages.h"
#include "devices/process/process_file.h"
#include "geometry/files/file_bytes.h"
#include "geometry/util/number_text.h"
#include "geometry/util/system_reason.h"

extern char** environ;

namespace tactooth {
namespace {

/// The attributes and file actions of posix_spawn. It does not copy the memory tables of this program, as fork does:
/// with gigabytes of locked memory that would stall the servo thread.
class SpawnPlan {
public:
    explicit SpawnPlan(int memoryFile) {
        posix_spawnattr_init(&attributes_);
        posix_spawn_file_actions_init(&files_);
        // Not the priority of the thread that starts it: it takes its own. Not Ctrl+C either: the program ends it.
        posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETPGROUP |
                                                   POSIX_SPAWN_SETSCHEDULER);
        sigset_t signals;
        sigfillset(&signals);
        posix_spawnattr_setsigdefault(&attributes_, &signals);
        sigemptyset(&signals);
        posix_spawnattr_setsigmask(&attributes_, &signals);
        posix_spawnattr_setpgroup(&attributes_, 0);
        posix_spawnattr_setschedpolicy(&attributes_, SCHED_OTHER);
        const sched_param ordinary{};
        posix_spawnattr_setschedparam(&attributes_, &ordinary);
        posix_spawn_file_actions_adddup2(&files_, memoryFile, HandArguments::kLinkFile);
        posix_spawn_file_actions_addclosefrom_np(&files_, HandArguments::kLinkFile + 1);
        // What a vendor's library prints is not output of the program.
        posix_spawn_file_actions_addopen(&files_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_addopen(&files_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    }
    ~SpawnPlan() {
        posix_spawnattr_destroy(&attributes_);
        posix_spawn_file_actions_destroy(&files_);
    }
    SpawnPlan(const SpawnPlan&) = delete;
    SpawnPlan& operator=(const SpawnPlan&) = delete;

    /// 0, or an errno.
    [[nodiscard]] int start(const std::string& program, const std::vector<std::string>& words, pid_t& id) const {
        std::vector<char*> pointers;
        for (const std::string& word : words) pointers.push_back(const_cast<char*>(word.c_str()));
        pointers.push_back(nullptr);
        return posix_spawn(&id, program.c_str(), &files_, &attributes_, pointers.data(), environ);
    }

private:
    posix_spawnattr_t attributes_{};
    posix_spawn_file_actions_t files_{};
};

}  // namespace

std::filesystem::path handProgram() {
    std::error_code ignored;
    const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", ignored);
    // Without /proc there is none: never one that lies in the working folder.
    return (self.is_absolute() ? self.parent_path() : std::filesystem::path("/")) / "tactooth-hand";
}

std::vector<std::string> HandArguments::words(const std::string& name) const {
    return {name, device, leftHanded ? "left" : "right", numberText(rateHz), std::to_string(program), faultLog};
}

std::optional<HandArguments> HandArguments::from(const std::vector<std::string>& words) {
    if (words.size() != kCount || (words[2] != "left" && words[2] != "right")) return std::nullopt;
    const auto rate = toNumber<double>(words[3]);
    const auto program = toNumber<pid_t>(words[4]);
    if (!rate || !(*rate > 0) || !(*rate < 1e6) || !program || *program <= 0) return std::nullopt;
    return HandArguments{words[1], words[2] == "left", *rate, words[5], *program};
}

Expected<std::unique_ptr<HandProcess>> HandProcess::start(const HandRequest& request, const HandMemory& memory) {
    const std::string program = request.program.native();
    const HandArguments arguments{request.device, request.leftHanded, request.rateHz, request.faultLog.native(),
                                  getpid()};
    pid_t id = 0;
    if (const int failed = SpawnPlan(memory.file()).start(program, arguments.words(program), id); failed != 0) {
        return unexpected(msg::kHandProgramMissing, displayName(request.program), systemReason(failed));
    }
    return std::unique_ptr<HandProcess>(new HandProcess(id, openProcessFile(id)));
}

HandProcess::~HandProcess() {
    if (file_ >= 0) ::close(file_);
}

void HandProcess::kill() const {
    if (file_ >= 0) {
        signalProcess(file_, SIGKILL);
    } else {  // some containers refuse pidfd_open(2)
        ::kill(id_, SIGKILL);
    }
}

HandEnd HandProcess::wait() {
    HandEnd end;
    bool wasStopped = false;
    for (;;) {
        siginfo_t info{};
        const int failed = waitid(P_PID, static_cast<id_t>(id_), &info, WEXITED | WSTOPPED);
        if (failed != 0 && errno == EINTR) continue;
        if (failed != 0) return end;  // this program cannot wait for children: how it ended is unknown
        if (info.si_code == CLD_STOPPED || info.si_code == CLD_TRAPPED) {
            wasStopped = true;
            kill();
            continue;
        }
        end.number = info.si_status;
        if (info.si_code != CLD_EXITED) end.cause = wasStopped ? HandFault::HandStopped : HandFault::HandKilled;
        if (info.si_code == CLD_EXITED && end.number == HandArguments::kHung) end.cause = HandFault::HandHangs;
        return end;
    }
}

}  // namespace tactooth
