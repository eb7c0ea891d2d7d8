// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "geometry/util/expected.h"

namespace tactooth {

/// A WebSocket to a service on this machine, for text. All calls from one thread; none takes longer than it is told.
class HaplyConnection {
public:
    enum class ReceiveStatus {
        Message,
        Nothing,  ///< within the time
        Broken,   ///< the other side has closed it, or answers no more
    };

    /// `address`: "host:port". Fails with one sentence that says what to do.
    [[nodiscard]] static Expected<std::unique_ptr<HaplyConnection>> open(const std::string& address, double seconds);
    ~HaplyConnection();
    HaplyConnection(const HaplyConnection&) = delete;
    HaplyConnection& operator=(const HaplyConnection&) = delete;

    /// False if it is broken.
    [[nodiscard]] bool send(std::string_view text, double seconds);
    /// Waits for the next message.
    [[nodiscard]] ReceiveStatus receive(std::string& text, double seconds);
    /// Takes those that have come already: `text` is the newest of them, and `count` goes up by their number. Comes to
    /// an end however fast they come.
    [[nodiscard]] ReceiveStatus receivePending(std::string& text, int& count);

private:
    class Socket;
    explicit HaplyConnection(std::unique_ptr<Socket> socket);
    std::unique_ptr<Socket> socket_;
};

}  // namespace tactooth
