// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace tactooth::test {

/// Faults of the stand-in service.
enum class HaplyFault {
    None,
    Drop,        ///< the connection is closed; new ones are accepted
    Slow,        ///< every answer comes 20 ms late
    Hiccup,      ///< only the next answer comes 20 ms late
    Mute,        ///< no answer at all
    Malformed,   ///< text that is not JSON
    Version,     ///< messages of another version
    Units,       ///< positions in millimetres
    NotANumber,  ///< a position that is not a number
    Jump,        ///< the position jumps by 50 mm, to and fro
    Gone,        ///< the device is missing from the list
    NoPower,     ///< the status reports no power
    NotCalibrated,
    NotReady,
    Double,           ///< two answers to each message
    Twenty,           ///< twenty answers to each message
    Flood,            ///< 20,000 unrequested answers a second
    InvalidRotation,  ///< the grip reports four numbers that are not a rotation
    NegatedTurn,      ///< the same rotation, with all four signs changed in every other message: not a fault
    FlippingTurn,     ///< a quarter rotation, to and fro
    Jitter,           ///< the position jumps by 4.9 mm, to and fro
    Drift,            ///< the position drifts at 3 m/s
};

/// The Haply Inverse Service without a device, on a free port of this machine: its own WebSocket server, and for each
/// Inverse3 a hand on a spring that advances by a millisecond with each message.
class StandinHaply {
public:
    StandinHaply();
    ~StandinHaply();
    StandinHaply(const StandinHaply&) = delete;
    StandinHaply& operator=(const StandinHaply&) = delete;

    static constexpr const char* kFirst = "049D";
    static constexpr const char* kSecond = "0B1C";

    [[nodiscard]] std::string address() const { return "localhost:" + std::to_string(port_); }

    void setFault(HaplyFault fault);
    /// Target position of the hands, m.
    void wantPosition(double x, double y, double z);
    /// Sets the first device's grip: w, x, y, z and one bit for each button.
    void setGrip(std::array<double, 4> orientation, unsigned buttons);
    /// Whether the service lists the grip.
    void setGripThere(bool there);
    /// Replaces the text of the first message; empty: the usual text.
    void setFirstMessage(std::string text);
    /// Makes the service answer as a web server instead of a WebSocket server.
    void setForeign(bool foreign);

    /// Magnitude of the last force that the first device received, N; zero without a connection.
    [[nodiscard]] double force() const;
    /// When that force became zero, s of the monotonic clock; 0 while there is one.
    [[nodiscard]] double zeroAt() const;
    /// Magnitude of the last force that the first device received, N, also after the connection was closed.
    [[nodiscard]] double lastForceReceived() const;
    /// Number of messages to the first device since the fault was set.
    [[nodiscard]] long messagesSinceFault() const;
    /// Number of the last of these messages with a force; 0: none. The answer before the first message was still
    /// correct.
    [[nodiscard]] long lastForceSinceFault() const;
    [[nodiscard]] long messages() const;
    [[nodiscard]] int connections() const;

private:
    struct Hand {
        const char* id;
        std::array<double, 3> position{}, speed{}, force{};  // mm, mm/s, N
    };
    void accept(const std::stop_token& stop);
    void serve(int socket, const std::stop_token& stop);
    void take(const std::string& message);
    void noteZero(bool hadForce);
    [[nodiscard]] std::string state(bool isFirst);
    [[nodiscard]] std::string placeOf(const Hand& hand) const;
    [[nodiscard]] std::string turnOfGrip() const;
    [[nodiscard]] double aside() const;
    [[nodiscard]] int answersToAMessage() const;
    [[nodiscard]] HaplyFault fault() const;
    [[nodiscard]] bool isLate() const;

    int listener_ = -1;
    int port_ = 0;
    mutable std::mutex mutex_;  // protects all members below
    HaplyFault fault_ = HaplyFault::None;
    std::array<Hand, 2> hands_{{{kFirst}, {kSecond}}};
    std::array<double, 3> wanted_{};  // mm
    std::array<double, 4> grip_{1, 0, 0, 0};
    unsigned buttons_ = 0;
    bool gripThere_ = true;
    std::string firstMessage_;
    bool foreign_ = false;
    long messages_ = 0, sinceFault_ = 0, lastForce_ = 0;
    double lastForceReceived_ = 0;
    double zeroAt_ = 0;
    int connections_ = 0;
    std::vector<std::jthread> servers_;
    std::jthread acceptor_;
};

}  // namespace tactooth::test
