// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/rest_fade.h"

#include <algorithm>
#include <utility>

namespace tactooth {
namespace {

constexpr double kFadeMs = 200;  // long enough for the eye to follow, too short to wait for
constexpr int kFadeStepMs = 25;  // between two pictures of it: eight lead to the last one

}  // namespace

double restFadeShare(double ms) { return std::clamp(ms / kFadeMs, 0.0, 1.0); }

RestFade::RestFade(std::function<void()> redraw) {
    next_.setInterval(kFadeStepMs);
    QObject::connect(&next_, &QTimer::timeout, [this, redraw = std::move(redraw)] {
        if (share() == 1) next_.stop();  // a hidden window does not draw
        redraw();
    });
}

Expected<void> RestFade::prepare(unsigned framebuffer, ImageSize size) {
    stop();
    if (!pictures_) {
        auto made = CrossFade::create();
        if (!made) return Unexpected{made.error()};
        pictures_ = std::move(*made);
    }
    return pictures_->keepFirst(framebuffer, size);
}

Expected<void> RestFade::start(unsigned framebuffer) {
    if (auto done = pictures_->keepLast(framebuffer); !done) return done;
    since_.start();
    next_.start();
    pictures_->draw(framebuffer, 0);
    return {};
}

void RestFade::draw(unsigned framebuffer) {
    if (!isRunning()) return;
    const double now = share();
    pictures_->draw(framebuffer, now);
    if (now == 1) stop();
}

double RestFade::share() const { return restFadeShare(static_cast<double>(since_.elapsed())); }

void RestFade::stop() {
    next_.stop();
    since_.invalidate();
}

void RestFade::forget() {
    stop();
    pictures_.reset();
}

}  // namespace tactooth
