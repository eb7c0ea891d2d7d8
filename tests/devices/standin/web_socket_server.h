// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace tactooth::test {

/// The server's side of one WebSocket (RFC 6455), for text messages in single frames, over an open socket that stays
/// the caller's. Blocking.
class WebSocketServer {
public:
    explicit WebSocketServer(int socket) : socket_(socket) {}

    [[nodiscard]] bool handshakeWith();
    /// Answers as a web server that knows no WebSocket; false, for then there is none.
    [[nodiscard]] bool refuseHandshake();
    [[nodiscard]] bool send(const std::string& text);
    /// The next text; false if the other side has closed.
    [[nodiscard]] bool receive(std::string& text);

private:
    [[nodiscard]] bool readRequest(std::string& request);
    [[nodiscard]] bool readBytes(unsigned char* bytes, std::size_t count);
    [[nodiscard]] bool writeAll(const std::string& bytes);
    int socket_;
};

/// What a server answers to a client's key.
[[nodiscard]] std::string webSocketAnswer(const std::string& key);

}  // namespace tactooth::test
