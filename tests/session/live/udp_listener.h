// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace tactooth::test {

/// A socket on a free port of the loopback.
class UdpListener {
public:
    UdpListener() : socket_(::socket(AF_INET, SOCK_DGRAM, 0)) {
        sockaddr_in place{};
        place.sin_family = AF_INET;
        place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        EXPECT_EQ(::bind(socket_, reinterpret_cast<sockaddr*>(&place), sizeof place), 0);
        socklen_t size = sizeof place;
        EXPECT_EQ(::getsockname(socket_, reinterpret_cast<sockaddr*>(&place), &size), 0);
        port_ = ntohs(place.sin_port);
    }
    ~UdpListener() { ::close(socket_); }
    UdpListener(const UdpListener&) = delete;
    UdpListener& operator=(const UdpListener&) = delete;
    [[nodiscard]] int port() const { return port_; }
    [[nodiscard]] std::string url() const { return "udp://127.0.0.1:" + std::to_string(port_); }
    /// Whether something has come that was not read.
    [[nodiscard]] bool hasDatagram() const {
        pollfd waiting{socket_, POLLIN, 0};
        return ::poll(&waiting, 1, 0) > 0;
    }
    /// Empty if nothing comes within a minute.
    [[nodiscard]] std::vector<std::byte> next() const {
        pollfd waiting{socket_, POLLIN, 0};
        if (::poll(&waiting, 1, 60'000) <= 0) return {};
        std::vector<std::byte> bytes(2048);
        bytes.resize(static_cast<std::size_t>(std::max<ssize_t>(0, ::recv(socket_, bytes.data(), bytes.size(), 0))));
        return bytes;
    }

private:
    int socket_;
    int port_ = 0;
};

}  // namespace tactooth::test
