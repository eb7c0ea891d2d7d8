// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace tactooth::test {

/// The server side of one WebSocket connection (RFC 6455), for text messages in single frames, over an open socket that
/// the caller owns. Blocking.
class WebSocketServer {
public:
    explicit WebSocketServer(int socket) : socket_(socket) {}

    [[nodiscard]] bool handshakeWith();
    /// Answers as a web server without WebSocket support; returns false, because there is no connection then.
    [[nodiscard]] bool refuseHandshake();
    [[nodiscard]] bool send(const std::string& text);
    /// Receives the next text; false if the other side has closed the connection.
    [[nodiscard]] bool receive(std::string& text);

private:
    [[nodiscard]] bool readRequest(std::string& request);
    [[nodiscard]] bool readBytes(unsigned char* bytes, std::size_t count);
    [[nodiscard]] bool writeAll(const std::string& bytes);
    int socket_;
};

/// The server's answer to a client's key.
[[nodiscard]] std::string webSocketAnswer(const std::string& key);

}  // namespace tactooth::test
