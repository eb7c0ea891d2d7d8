// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/haply/haply_connection.h"

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <optional>

#include "devices/base/messages.h"
#include "devices/base/monotonic_clock.h"

namespace tactooth {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = boost::beast::websocket;
using asio::ip::tcp;
using Failure = boost::system::error_code;

constexpr std::size_t kLongestMessage = 1U << 20U;  // bytes: two devices need less than ten thousand
constexpr double kMaxDrainTime = 0.001;             // s for taking messages that came unrequested

}  // namespace

/// Every call starts its operation and runs it until it is done or the time is up. Only a read of a message that has
/// not arrived yet stays pending from one call to the next.
class HaplyConnection::Socket {
public:
    Socket() : stream_(io_) {}

    [[nodiscard]] bool connect(const std::string& host, const std::string& port, MonotonicClock::time_point end) {
        Failure failure;
        tcp::resolver resolver(io_);
        const auto found = resolver.resolve(host, port, failure);  // of this machine: no query to a name server
        if (failure) return false;
        auto& tcpStream = beast::get_lowest_layer(stream_);
        if (!run(end, [&](auto done) {
                tcpStream.async_connect(found, [done](Failure error, const tcp::endpoint&) mutable { done(error); });
            })) {
            return false;
        }
        tcpStream.socket().set_option(tcp::no_delay(true), failure);
        return true;
    }
    /// True if the other side speaks WebSocket.
    [[nodiscard]] bool handshakeWith(const std::string& address, MonotonicClock::time_point end) {
        stream_.read_message_max(kLongestMessage);
        return run(end, [&](auto done) { stream_.async_handshake(address, "/", done); });
    }
    [[nodiscard]] bool send(std::string_view text, MonotonicClock::time_point end) {
        stream_.text(true);
        return run(end, [&](auto done) {
            stream_.async_write(asio::buffer(text), [done](Failure error, std::size_t) mutable { done(error); });
        });
    }
    [[nodiscard]] ReceiveStatus receive(std::string& text, MonotonicClock::time_point end) {
        await();
        if (!heard_ && !runUntil(end, heard_)) return ReceiveStatus::Nothing;
        return take(text);
    }
    /// Checks without waiting whether a message has arrived.
    [[nodiscard]] ReceiveStatus poll(std::string& text) {
        await();
        io_.restart();
        while (!heard_ && io_.poll_one() > 0) {
        }
        return heard_ ? take(text) : ReceiveStatus::Nothing;
    }
    /// Cancels pending operations, so that no handler remains that could be called later.
    void abandon() {
        Failure ignored;
        beast::get_lowest_layer(stream_).socket().close(ignored);
        io_.restart();
        io_.run();
    }

private:
    void await() {
        if (awaited_) return;
        awaited_ = true;
        heard_.reset();
        stream_.async_read(buffer_, [this](Failure error, std::size_t) { heard_ = error; });
    }
    [[nodiscard]] ReceiveStatus take(std::string& text) {
        awaited_ = false;
        if (*heard_) return ReceiveStatus::Broken;
        text = beast::buffers_to_string(buffer_.data());
        buffer_.consume(buffer_.size());
        return ReceiveStatus::Message;
    }
    bool runUntil(MonotonicClock::time_point end, const std::optional<Failure>& result) {
        io_.restart();
        while (!result && io_.run_one_until(end) > 0) {
        }
        return result.has_value();
    }
    /// True if the operation that `start` begins succeeds in time; otherwise it is cancelled completely.
    template <class Start>
    bool run(MonotonicClock::time_point end, const Start& start) {
        std::optional<Failure> result;
        start([&result](Failure error) { result = error; });
        if (runUntil(end, result)) return !*result;
        abandon();
        return false;
    }

    asio::io_context io_;
    websocket::stream<beast::tcp_stream> stream_;
    beast::flat_buffer buffer_;
    bool awaited_ = false;  // a read is pending
    std::optional<Failure> heard_;
};

Expected<std::unique_ptr<HaplyConnection>> HaplyConnection::open(const std::string& address, double seconds) {
    const std::size_t colon = address.rfind(':');
    const std::string host = address.substr(0, colon);
    const std::string port = colon == std::string::npos ? "" : address.substr(colon + 1);
    auto socket = std::make_unique<Socket>();
    const MonotonicClock::time_point end = secondsFromNow(seconds);
    if (!socket->connect(host, port, end)) {
        return unexpected(msg::kHaplyNotThere, address);
    }
    if (!socket->handshakeWith(address, end)) {
        return unexpected(msg::kHaplyIsAnother, address);
    }
    return std::unique_ptr<HaplyConnection>(new HaplyConnection(std::move(socket)));
}

HaplyConnection::HaplyConnection(std::unique_ptr<Socket> socket) : socket_(std::move(socket)) {}
HaplyConnection::~HaplyConnection() { socket_->abandon(); }

bool HaplyConnection::send(std::string_view text, double seconds) {
    return socket_->send(text, secondsFromNow(seconds));
}
HaplyConnection::ReceiveStatus HaplyConnection::receive(std::string& text, double seconds) {
    return socket_->receive(text, secondsFromNow(seconds));
}

HaplyConnection::ReceiveStatus HaplyConnection::receivePending(std::string& text, int& count) {
    const MonotonicClock::time_point end = secondsFromNow(kMaxDrainTime);
    ReceiveStatus status = socket_->poll(text);
    if (status != ReceiveStatus::Message) return status;
    while (status == ReceiveStatus::Message) {
        ++count;
        if (MonotonicClock::now() > end) break;
        status = socket_->poll(text);
    }
    return status == ReceiveStatus::Broken ? ReceiveStatus::Broken : ReceiveStatus::Message;
}

}  // namespace tactooth
