// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "standin_spacenavd.h"

#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstring>
#include <stdexcept>

namespace tactooth::test {
namespace {

constexpr int kPollMs = 10;
constexpr int kPatience = 6000;  // number of polls for which an event waits for a client
constexpr std::int32_t kMotion = 0, kPress = 1, kRelease = 2;

bool readable(int file) {
    pollfd waiting{file, POLLIN, 0};
    return poll(&waiting, 1, kPollMs) > 0;
}

}  // namespace

StandinSpacenavd::StandinSpacenavd(const std::filesystem::path& socket) : socket_(socket) {
    listener_ = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strncpy(address.sun_path, socket.c_str(), sizeof address.sun_path - 1);
    std::filesystem::remove(socket);
    if (bind(listener_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
        listen(listener_, 4) != 0) {
        throw std::runtime_error("no socket at " + socket.string());
    }
    server_ = std::jthread([this](const std::stop_token& stop) { serve(stop); });
}

StandinSpacenavd::~StandinSpacenavd() {
    server_ = {};
    if (client_ >= 0) close(client_);
    close(listener_);
    std::filesystem::remove(socket_);
}

/// Serves one client after the other and sends no replies, like drivers of the first protocol.
void StandinSpacenavd::serve(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        if (client_ < 0) {
            if (readable(listener_)) client_ = accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
            continue;
        }
        if (!readable(client_)) continue;
        std::array<char, 256> words;
        const ssize_t count = read(client_, words.data(), words.size());
        if (count <= 0) close(client_.exchange(-1));
    }
}

bool StandinSpacenavd::send(const std::array<std::int32_t, 8>& event) {
    for (int i = 0; i < kPatience && !hasClient(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(kPollMs));
    return hasClient() && ::send(client_, event.data(), sizeof event, MSG_NOSIGNAL) == sizeof event;
}

bool StandinSpacenavd::move(const std::array<int, 6>& axes) {
    return send({kMotion, axes[0], axes[1], axes[2], axes[3], axes[4], axes[5], 16});
}

bool StandinSpacenavd::button(int number, bool down) { return send({down ? kPress : kRelease, number}); }

}  // namespace tactooth::test
