// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/display_server.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>
#include <xcb/xcb.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>

namespace tactooth {
namespace {

// The wire format of Wayland: the object's number, the message's length in bytes and its kind, its arguments.
constexpr std::uint32_t kDisplay = 1, kCallback = 2;  // numbers of objects
constexpr std::uint32_t kSync = 0, kHeaderBytes = 8;  // kind of message
constexpr std::uint32_t kLengthShift = 16;

std::filesystem::path waylandSocket() {
    const auto valueOf = [](const char* name) {
        const char* const value = std::getenv(name);
        return std::filesystem::path(value == nullptr ? "" : value);
    };
    return valueOf("XDG_RUNTIME_DIR") / valueOf("WAYLAND_DISPLAY");  // an absolute name replaces the folder
}

bool readWhole(int socket, void* to, std::size_t bytes) {
    auto* at = static_cast<char*>(to);
    while (bytes > 0) {
        const ssize_t count = ::read(socket, at, bytes);
        if (count <= 0) return false;
        at += count;
        bytes -= static_cast<std::size_t>(count);
    }
    return true;
}

/// Requests a callback after all earlier requests (wl_display.sync), and waits for the first complete message.
void askForSign(int socket) {
    constexpr std::uint32_t kLength = kHeaderBytes + sizeof(std::uint32_t);
    const std::array<std::uint32_t, 3> request = {kDisplay, kLength << kLengthShift | kSync, kCallback};
    if (::send(socket, request.data(), sizeof request, MSG_NOSIGNAL) != sizeof request) return;
    std::array<std::uint32_t, 2> head{};
    if (!readWhole(socket, head.data(), kHeaderBytes)) return;
    std::array<char, 1U << kLengthShift> body;
    const std::size_t length = head[1] >> kLengthShift;
    if (length > kHeaderBytes) (void)readWhole(socket, body.data(), length - kHeaderBytes);
}

}  // namespace

bool xServerAnswers() {
    xcb_connection_t* const connection = xcb_connect(nullptr, nullptr);
    if (xcb_connection_has_error(connection) == 0) {
        std::free(xcb_get_input_focus_reply(connection, xcb_get_input_focus(connection), nullptr));
    }
    xcb_disconnect(connection);
    return true;
}

bool waylandServerAnswers() {
    const std::string path = waylandSocket().string();
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    if (path.size() >= sizeof address.sun_path) return true;  // no server can be there
    std::memcpy(address.sun_path, path.c_str(), path.size());
    const int socket = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (socket < 0) return true;
    if (::connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) askForSign(socket);
    ::close(socket);
    return true;
}

}  // namespace tactooth
