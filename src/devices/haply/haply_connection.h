// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "geometry/util/expected.h"

namespace tactooth {

/// A WebSocket connection for text to a service on this machine. One thread makes all calls; none takes longer than its
/// time limit.
class HaplyConnection {
public:
    enum class ReceiveStatus {
        Message,
        Nothing,  ///< no message within the time
        Broken,   ///< the other side has closed the connection or no longer responds
    };

    /// `address`: "host:port". Fails with one sentence that states the remedy.
    [[nodiscard]] static Expected<std::unique_ptr<HaplyConnection>> open(const std::string& address, double seconds);
    ~HaplyConnection();
    HaplyConnection(const HaplyConnection&) = delete;
    HaplyConnection& operator=(const HaplyConnection&) = delete;

    /// False if the connection is broken.
    [[nodiscard]] bool send(std::string_view text, double seconds);
    /// Waits for the next message.
    [[nodiscard]] ReceiveStatus receive(std::string& text, double seconds);
    /// Takes the messages that have already arrived: `text` becomes the newest of them, and `count` increases by their
    /// number. Returns in bounded time, however fast messages arrive.
    [[nodiscard]] ReceiveStatus receivePending(std::string& text, int& count);

private:
    class Socket;
    explicit HaplyConnection(std::unique_ptr<Socket> socket);
    std::unique_ptr<Socket> socket_;
};

}  // namespace tactooth
