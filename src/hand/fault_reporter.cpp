// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "hand/fault_reporter.h"

#include <chrono>
#include <fstream>
#include <utility>

#include "devices/base/monotonic_clock.h"

namespace tactooth {
namespace {

constexpr double kReasonDelay = 1;  // s: on a busy machine, a program that was killed takes long to be gone

HandFault causeOf(HandFault cause, ProgramState program) {
    if (cause != HandFault::NoForce || program == ProgramState::Runs) return cause;
    return program == ProgramState::Stopped ? HandFault::ProgramStopped : HandFault::ProgramEnded;
}

}  // namespace

ProgramState stateOfProcess(int process) {
    std::ifstream file("/proc/" + std::to_string(process) + "/stat");
    std::string text;
    std::getline(file, text);
    const std::size_t name = text.rfind(')');  // "42 (a name) S 1 ...": the name may hold anything
    const char state = name != std::string::npos && name + 2 < text.size() ? text[name + 2] : 'X';
    if (state == 'T' || state == 't') return ProgramState::Stopped;
    return state == 'X' || state == 'Z' ? ProgramState::Gone : ProgramState::Runs;
}

void FaultReporter::write(const ForceCut& cut) const {
    const auto ago = std::chrono::duration_cast<std::chrono::system_clock::duration>(
        std::chrono::duration<double>(monotonicSeconds() - cut.at));
    appendFault(file_, {std::chrono::system_clock::now() - ago, cut.cause, device_, cut.force, cut.toZero});
}

void FaultReporter::add(const ForceCut& cut) {
    if (waiting_ && cut.isAfterCut && cut.cause == HandFault::ProgramEnded) {  // that was the reason
        waiting_->cause = cut.cause;
        return;
    }
    if (waiting_) write(*std::exchange(waiting_, std::nullopt));
    if (cut.cause == HandFault::NoForce) {
        waiting_ = cut;
    } else {
        write(cut);
    }
}

void FaultReporter::step(double now, ProgramState program) {
    if (waiting_ && (now > waiting_->at + kReasonDelay || program != ProgramState::Runs)) finish(program);
}

void FaultReporter::finish(ProgramState program) {
    if (!waiting_) return;
    ForceCut cut = *std::exchange(waiting_, std::nullopt);
    cut.cause = causeOf(cut.cause, program);
    write(cut);
}

}  // namespace tactooth
