// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/util/expected.h"
#include "session/model/session_model.h"
#include "session/model/task.h"

namespace tactooth {

/// Makes or reads teeth and burs in the background and installs them in a session.
class SessionLoader {
public:
    /// `model` outlives the loader.
    explicit SessionLoader(SessionModel& model, const TaskExecutor& executor = runInThread)
        : model_(model), tooth_(executor), bur_(executor) {}

    void load(Task<SessionTooth>::Function tooth) { tooth_.start(std::move(tooth)); }
    void load(Task<SessionBur>::Function bur) { bur_.start(std::move(bur)); }
    [[nodiscard]] bool isBusy() const { return tooth_.isAwaited() || bur_.isAwaited(); }
    /// What is being loaded will not be installed.
    void cancel() {
        tooth_.cancel();
        bur_.cancel();
    }

    /// Installs what is ready. Returns an error if loading has failed; the session then keeps its tooth and bur.
    [[nodiscard]] std::optional<Error> poll();

private:
    SessionModel& model_;
    Task<SessionTooth> tooth_;
    Task<SessionBur> bur_;
};

}  // namespace tactooth
