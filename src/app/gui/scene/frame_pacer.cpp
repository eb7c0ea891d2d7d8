// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/frame_pacer.h"

#include <sys/resource.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <string>

namespace tactooth {
namespace {

constexpr double kShortestMs = 30;   // between two pictures: the eye needs about 30 a second
constexpr double kLongestMs = 100;   // with a slower picture the user loses the hand
constexpr double kSpinMs = 120;      // between two pictures of a bur that only spins
constexpr double kShareOfTime = 2;   // the interval between pictures is this many times the drawing time
constexpr double kTooSlowMs = 18;    // slower full pictures are replaced by coarse ones ...
constexpr double kFastEnoughMs = 7;  // ... until a coarse one is faster than this; it has half the pixels
constexpr double kCoarse = 0.7;      // along each side
constexpr double kSmoothing = 0.25;  // share of the newest cost
constexpr double kCardMs = 2;        // a plain picture as fast as this comes from a graphics card ...
constexpr int kCardPictures = 20;    // ... after so many of them; then smooth ones are tried,
constexpr double kSmoothMs = 10;     // and kept if they are as fast as this
constexpr int kNice = 5;             // gives a third of the share of an ordinary thread

}  // namespace

bool FramePacer::isDue(Change change, double ms) const {
    switch (change) {
        case Change::None:
            return false;
        case Change::Spin:
            return ms >= kSpinMs;
        case Change::Motion:
            break;
    }
    return ms >= std::clamp(kShareOfTime * cost_, kShortestMs, kLongestMs);
}

double FramePacer::resolution(Change change) const { return coarse_ && change == Change::Motion ? kCoarse : 1; }

void FramePacer::recordFrame(Change change, double ms) {
    if (change != Change::Motion) return;
    cost_ = cost_ == 0 ? ms : cost_ + kSmoothing * (ms - cost_);
    ++drawn_;
    if (smooth_ == Smooth::NotYet && !coarse_ && cost_ < kCardMs && drawn_ >= kCardPictures) smooth_ = Smooth::Yes;
    if (smooth_ == Smooth::Yes && cost_ > kSmoothMs) {
        smooth_ = Smooth::TooSlow;  // for good: otherwise the pictures would flicker
        cost_ = 0;
        return;
    }
    if (!coarse_ && cost_ > kTooSlowMs) {
        coarse_ = true;
        cost_ *= kCoarse * kCoarse;
    } else if (coarse_ && cost_ < kFastEnoughMs) {
        coarse_ = false;
        cost_ /= kCoarse * kCoarse;
    }
}

void lowerSoftwareRendererPriority() {
    std::error_code none;
    for (const auto& task : std::filesystem::directory_iterator("/proc/self/task", none)) {
        std::string name;
        std::getline(std::ifstream(task.path() / "comm"), name);
        if (!name.starts_with("llvmpipe-")) continue;
        const std::string number = task.path().filename().string();
        id_t thread = 0;
        std::from_chars(number.data(), number.data() + number.size(), thread);
        setpriority(PRIO_PROCESS, thread, kNice);  // on Linux this is for one thread
    }
}

}  // namespace tactooth
