// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <thread>

#include "geometry/util/expected.h"
#include "geometry/util/triple_buffer.h"
#include "haptics/haptic_simulation.h"

namespace tactooth {

/// Bytes of a datagram (docs/live-stream.md).
inline constexpr std::size_t kStreamBytes = 160;
[[nodiscard]] std::array<std::byte, kStreamBytes> streamDatagram(const Tick& tick);

/// Where a stream goes.
struct StreamAddress {
    std::string host;  ///< a name or a number; 127.0.0.1 if none was given
    std::uint16_t port = 0;

    /// Reads "udp://HOST:PORT"; an IPv6 number stands in brackets. Fails with one sentence for all else.
    [[nodiscard]] static Expected<StreamAddress> parse(const std::string& url);
};

/// Sends the newest tick by UDP, at most a thousand times a second, from a thread of its own.
class LiveStream {
public:
    /// Fails with one sentence if `url` is no address of a stream, or if its host is not found.
    [[nodiscard]] static Expected<std::unique_ptr<LiveStream>> open(const std::string& url);
    ~LiveStream();
    LiveStream(const LiveStream&) = delete;
    LiveStream& operator=(const LiveStream&) = delete;

    /// One thread, the servo's; wait-free. A tick that nobody has sent yet is replaced.
    void write(const Tick& tick) { newest_.write(tick); }

private:
    explicit LiveStream(int socket);
    void run(const std::stop_token& stop);

    int socket_;
    TripleBuffer<Tick> newest_;
    std::jthread thread_;  // last: it uses the members above
};

}  // namespace tactooth
