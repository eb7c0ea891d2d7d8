// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <functional>
#include <future>
#include <optional>

#include "geometry/util/expected.h"

namespace tactooth {

/// One piece of long work at a time, done by another thread while the window goes on. Of wishes that come while it
/// works only the last one counts. Used from one thread; going away waits for the work to end.
template <class T>
class Errand {
public:
    using Work = std::function<Expected<T>()>;

    void start(Work work) {
        if (isBusy()) {
            next_ = std::move(work);
        } else {
            running_ = std::async(std::launch::async, std::move(work));
        }
    }

    [[nodiscard]] bool isBusy() const { return running_.valid(); }

    /// Nobody wants what is being done any more: its result will not be delivered.
    void forget() {
        next_ = nullptr;
        isUnwanted_ = isBusy();
    }

    /// The result, once, when the last wish is done.
    [[nodiscard]] std::optional<Expected<T>> poll() {
        if (!isBusy() || running_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return std::nullopt;
        Expected<T> result = running_.get();
        const bool isUnwanted = std::exchange(isUnwanted_, false);
        if (next_) {
            start(std::exchange(next_, nullptr));
            return std::nullopt;
        }
        if (isUnwanted) return std::nullopt;
        return result;
    }

private:
    std::future<Expected<T>> running_;
    Work next_;
    bool isUnwanted_ = false;  // what is running
};

}  // namespace tactooth
