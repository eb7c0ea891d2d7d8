// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "hand/run_hand.h"

#include <poll.h>
#include <pthread.h>
#include <sched.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <filesystem>
#include <memory>
#include <thread>

#include "devices/base/monotonic_clock.h"
#include "devices/open_device.h"
#include "devices/process/hand_servo.h"
#include "devices/process/process_file.h"
#include "devices/process/processor.h"
#include "devices/simulated/simulated_driver.h"
#include "geometry/util/number_text.h"
#include "hand/fault_reporter.h"
#include "haptics/real_time.h"

namespace tactooth {
namespace {

constexpr int kCheckPeriodMs = 10;   // between two checks of the program, the device's faults and the loop
constexpr int kHungChecks = 25;      // without a turn of the loop: 0.25 s, which no working loop needs
constexpr unsigned kCloseLimit = 3;  // s for a driver to close its device; then SIGALRM ends this process
constexpr int kFailed = 1;           // exit status: the device did not open, or the program is gone

std::atomic<HandServo*> runningServo{nullptr};  // for the signal handler
pid_t programId = 0;

/// The program ends (the kernel sends this signal in its name, as soon as its thread that waits for this process has
/// ended), or the system shuts down.
void onTermination(int, siginfo_t* info, void*) {
    HandServo* const servo = runningServo.load();
    if (servo == nullptr) _exit(kFailed);  // no device is open
    servo->end(info->si_pid == programId ? HandFault::ProgramEnded : HandFault::None);
}

void installHandlers() {
    struct sigaction action {};
    action.sa_sigaction = onTermination;
    action.sa_flags = SA_RESTART | SA_SIGINFO;
    sigaction(SIGTERM, &action, nullptr);
    for (const int number : {SIGINT, SIGHUP, SIGPIPE}) signal(number, SIG_IGN);  // meant for the program
    // The default would round the ends of its waits up by 50 us where it has no real-time priority.
    prctl(PR_SET_TIMERSLACK, 1);
    prctl(PR_SET_PDEATHSIG, SIGTERM);
}

Expected<std::unique_ptr<HapticDevice>> openHandDevice(const HandArguments& arguments, const SampleListener& listener) {
    if (arguments.device != SimulatedDriver::kName) {
        return openDeviceInProcess(arguments.device, arguments.leftHanded, arguments.rateHz, listener);
    }
    std::unique_ptr<HapticDevice> device = std::make_unique<SimulatedDriver>(arguments.rateHz);
    device->setSampleListener(listener);
    if (const auto opened = device->open(); !opened) return Unexpected{opened.error()};
    return device;
}

/// Where the system allows it, raises the threads that have no real-time priority of their own to the lowest one. A
/// process that is killed closes its connections, and so ends its force, when the last of its threads has run to its
/// end. On a busy machine an ordinary thread would wait for that.
void raiseOrdinaryThreads() {
    sched_param lowest{};
    lowest.sched_priority = sched_get_priority_min(SCHED_FIFO);
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator("/proc/self/task", ignored)) {
        const pid_t thread = toNumber<pid_t>(entry.path().filename().native()).value_or(0);
        if (thread > 0 && sched_getscheduler(thread) == SCHED_OTHER) sched_setscheduler(thread, SCHED_FIFO, &lowest);
    }
}

void setStatus(HandLink& link, HandStatus status) {
    link.status.store(status, std::memory_order_release);
    link.programBell.ring();
}

/// Above the servo of a program, which may hang; else as high as that; else an ordinary thread, with more jitter. True
/// for the first.
bool takeHandPriority() {
    if (!acquireRealTimePriority()) return false;
    sched_param parameters{};
    int policy = 0;
    pthread_getschedparam(pthread_self(), &policy, &parameters);
    ++parameters.sched_priority;
    return pthread_setschedparam(pthread_self(), policy, &parameters) == 0;
}

void runServo(HandServo& servo, HandLink& link) {
    pthread_setname_np(pthread_self(), "hand-servo");  // name for debuggers and profilers
    const bool isFirst = takeHandPriority();
    link.mayShareProcessor.store(isFirst ? 1 : 0, std::memory_order_relaxed);
    std::int32_t processor = -1;
    while (!servo.hasEnded()) {
        const std::uint32_t rings = link.handBell.rings();
        servo.turn(monotonicSeconds());
        const std::int32_t wanted = link.servoProcessor.load(std::memory_order_relaxed);
        if (isFirst && wanted != processor) (void)keepOnProcessor(processor = wanted);
        link.handBell.wait(rings, servo.nextTurn());
    }
}

/// Ends this process where its loop does not turn any more: the program then starts another one.
class LoopCheck {
public:
    explicit LoopCheck(const HandServo& servo) : servo_(servo) {}

    [[nodiscard]] bool isHung() {
        const std::uint32_t turns = servo_.turns();
        checks_ = turns == turns_ ? checks_ + 1 : 0;
        turns_ = turns;
        return checks_ >= kHungChecks;
    }

private:
    const HandServo& servo_;
    std::uint32_t turns_ = 0;
    int checks_ = 0;
};

/// What is not urgent, on the first thread, beside the loop: the faults of the device go to the program and those of
/// the watchdog to the log; the program is watched, and the loop.
class HandHousekeeping {
public:
    HandHousekeeping(const HapticDevice& device, HandLink& link, HandServo& servo, const std::string& faultLog)
        : device_(device),
          servo_(servo),
          texts_(link.faults),
          reporter_(device.info().rendersForce ? faultLog : std::string(), device.info().name),
          loop_(servo),
          program_(openProcessFile(programId)) {}
    ~HandHousekeeping() {
        if (program_ >= 0) close(program_);
    }
    HandHousekeeping(const HandHousekeeping&) = delete;
    HandHousekeeping& operator=(const HandHousekeeping&) = delete;

    void run() {
        while (!servo_.hasEnded()) {
            if (waitForProgram()) servo_.end(HandFault::ProgramEnded);
            publishFault();
            report();
            reporter_.step(monotonicSeconds(), programState());
            if (loop_.isHung()) _exit(HandArguments::kHung);  // the program logs it
        }
        report();
        reporter_.finish(programState());
    }

private:
    /// Waits for a moment; true once, as soon as the program has ended.
    [[nodiscard]] bool waitForProgram() {
        pollfd end{isGone_ ? -1 : program_, POLLIN, 0};
        const bool hasEnded = poll(&end, 1, isGone_ ? 1 : kCheckPeriodMs) > 0 && (end.revents & POLLIN) != 0;
        isGone_ |= hasEnded;
        return hasEnded;
    }
    [[nodiscard]] ProgramState programState() const {
        return isGone_ || getppid() != programId ? ProgramState::Gone : stateOfProcess(programId);
    }
    void publishFault() {
        const Message* const fault = device_.faultMessage();
        if (fault == fault_) return;
        fault_ = fault;
        texts_.write(fault != nullptr ? handTextOf(*fault) : HandText{});
    }
    void report() {
        for (ForceCut cut; servo_.fetchCut(cut);) reporter_.add(cut);
    }

    const HapticDevice& device_;
    HandServo& servo_;
    SlotWriter<HandText> texts_;
    FaultReporter reporter_;
    LoopCheck loop_;
    int program_;  // its pidfd
    bool isGone_ = false;
    const Message* fault_ = nullptr;
};

}  // namespace

int runHand(const HandArguments& arguments) {
    programId = arguments.program;
    installHandlers();
    if (getppid() != programId) return kFailed;  // it has ended before the kernel could notify this process
    const std::unique_ptr<HandMemory> memory = HandMemory::open(HandArguments::kLinkFile);
    if (memory == nullptr) return HandArguments::kOtherVersion;
    HandLink& link = memory->link();
    (void)lockMemory();
    SampleSignal signal(link.handBell);
    auto device = openHandDevice(arguments, signal.listener());
    if (!device) {
        link.failure = handTextOf(device.error());
        setStatus(link, HandStatus::Failed);
        return kFailed;
    }
    link.description = descriptionOf(**device);
    HandServo servo(**device, link, signal, arguments.rateHz);
    runningServo.store(&servo);
    std::jthread loop([&] { runServo(servo, link); });
    raiseOrdinaryThreads();
    setStatus(link, HandStatus::Open);
    HandHousekeeping(**device, link, servo, arguments.faultLog).run();
    loop.join();
    runningServo.store(nullptr);
    alarm(kCloseLimit);
    (*device)->close();
    return 0;
}

}  // namespace tactooth
