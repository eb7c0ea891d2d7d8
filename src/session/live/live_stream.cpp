// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/live/live_stream.h"

#include <netdb.h>
#include <pthread.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <string_view>
#include <utility>

#include "geometry/util/assert.h"
#include "geometry/util/byte_stream.h"
#include "geometry/util/system_reason.h"
#include "session/live/messages.h"

namespace tactooth {
namespace {

constexpr auto kPeriod = std::chrono::milliseconds(1);
constexpr std::string_view kScheme = "udp://";
constexpr std::string_view kMagic = "TTL1";

/// The host and the port of "HOST:PORT" or "[HOST]:PORT"; an empty port if it has another form.
std::pair<std::string, std::string> hostAndPort(const std::string& text) {
    const std::size_t colon = text.rfind(':');
    if (colon == std::string::npos) return {};
    std::string host = text.substr(0, colon);
    if (host.size() > 2 && host.front() == '[' && host.back() == ']')
        return {host.substr(1, host.size() - 2), text.substr(colon + 1)};
    if (host.find_first_of("[]:/?#@ ") != std::string::npos) return {};
    return {host, text.substr(colon + 1)};
}

}  // namespace

std::array<std::byte, kStreamBytes> streamDatagram(const Tick& tick) {
    ByteWriter out;
    out.putAll(std::span(kMagic.data(), kMagic.size()));
    out.put(tick.number);
    out.put(tick.time);
    for (int axis = 0; axis < 3; ++axis) out.put(tick.contact.proxy.position[axis]);
    for (int i = 0; i < 4; ++i) out.put(tick.contact.proxy.rotation.coeffs()[i]);
    for (int axis = 0; axis < 3; ++axis) out.put(tick.force.wrench.force[axis]);
    for (int axis = 0; axis < 3; ++axis) out.put(tick.force.wrench.torque[axis]);
    for (const double number : {tick.contact.depth, tick.spindle.speedRpm, tick.spindle.load, tick.input.pedal})
        out.put(number);
    out.put(static_cast<std::uint32_t>(tick.contact.triangles));
    out.put(static_cast<std::uint32_t>((tick.input.cutting ? 1 : 0) + (tick.contact.placed ? 2 : 0)));
    TACTOOTH_ASSERT(out.bytes().size() == kStreamBytes);
    std::array<std::byte, kStreamBytes> datagram{};
    std::copy(out.bytes().begin(), out.bytes().end(), datagram.begin());
    return datagram;
}

Expected<StreamAddress> StreamAddress::parse(const std::string& url) {
    if (!url.starts_with(kScheme)) return unexpected(msg::kStreamForm, url);
    const auto [host, port] = hostAndPort(url.substr(kScheme.size()));
    if (port.empty()) return unexpected(msg::kStreamForm, url);
    StreamAddress address{host.empty() ? "127.0.0.1" : host};
    const auto [end, error] = std::from_chars(port.data(), port.data() + port.size(), address.port);
    if (error != std::errc() || end != port.data() + port.size() || address.port == 0) {
        return unexpected(msg::kStreamPort, url);
    }
    return address;
}

Expected<std::unique_ptr<LiveStream>> LiveStream::open(const std::string& url) {
    const Expected<StreamAddress> address = StreamAddress::parse(url);
    if (!address) return Unexpected{address.error()};
    addrinfo hints{};
    hints.ai_socktype = SOCK_DGRAM;
    hints.ai_flags = AI_NUMERICSERV;
    addrinfo* found = nullptr;
    const std::string port = std::to_string(address->port);
    if (const int failure = ::getaddrinfo(address->host.c_str(), port.c_str(), &hints, &found); failure != 0) {
        return unexpected(msg::kStreamHost, url, ::gai_strerror(failure));
    }
    const std::unique_ptr<addrinfo, void (*)(addrinfo*)> places(found, ::freeaddrinfo);
    int reason = EAFNOSUPPORT;
    for (const addrinfo* place = found; place != nullptr; place = place->ai_next) {
        const int socket = ::socket(place->ai_family, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
        // A connected socket sends to this place alone.
        if (socket >= 0 && ::connect(socket, place->ai_addr, place->ai_addrlen) == 0) {
            return std::unique_ptr<LiveStream>(new LiveStream(socket));
        }
        reason = errno;
        if (socket >= 0) ::close(socket);
    }
    return unexpected(msg::kStreamSocket, url, systemReason(reason));
}

LiveStream::LiveStream(int socket) : socket_(socket), thread_([this](const std::stop_token& stop) { run(stop); }) {}

LiveStream::~LiveStream() {
    thread_ = {};  // joins
    ::close(socket_);
}

void LiveStream::run(const std::stop_token& stop) {
    pthread_setname_np(pthread_self(), "stream");  // for debuggers and profilers
    while (!stop.stop_requested()) {
        if (newest_.refresh()) {
            const auto datagram = streamDatagram(newest_.value());
            (void)::send(socket_, datagram.data(), datagram.size(), MSG_NOSIGNAL);  // nobody need listen
        }
        std::this_thread::sleep_for(kPeriod);
    }
}

}  // namespace tactooth
