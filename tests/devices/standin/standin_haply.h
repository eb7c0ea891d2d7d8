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

/// What goes wrong in the stand-in service.
enum class HaplyFault {
    None,
    Drop,        ///< the connection is closed; new ones are taken
    Slow,        ///< every answer comes 20 ms late
    Hiccup,      ///< the next one does
    Mute,        ///< no answer at all
    Malformed,   ///< text that is no JSON
    Version,     ///< messages of another version
    Units,       ///< places in millimetres
    NotANumber,  ///< a place that is no number
    Jump,        ///< of 50 mm, to and fro
    Gone,        ///< the device is not in the list
    NoPower,     ///< its status says so
    NotCalibrated,
    NotReady,
    Double,           ///< two answers to each message
    Twenty,           ///< twenty
    Flood,            ///< 20,000 answers a second that nobody has asked for
    InvalidRotation,  ///< the grip tells four numbers that are no turn
    NegatedTurn,      ///< the same turn, with all four signs changed at every other message: no fault
    FlippingTurn,     ///< a quarter turn to and fro
    Jitter,           ///< of 4.9 mm, to and fro
    Drift,            ///< of 3 m/s
};

/// The Haply Inverse Service without a device, on a free port of this machine: a WebSocket server of its own, and for
/// each Inverse3 a hand on a spring that moves by a millisecond with each message.
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
    /// Where the hands want to be, m.
    void wantPosition(double x, double y, double z);
    /// Of the first device's grip: w, x, y, z and a bit a button.
    void setGrip(std::array<double, 4> orientation, unsigned buttons);
    /// Whether the service lists the grip.
    void setGripThere(bool there);
    /// Text of the first message instead of the usual one; empty: the usual one.
    void setFirstMessage(std::string text);
    /// Instead of WebSocket it answers as a web server does.
    void setForeign(bool foreign);

    /// The length of the force that the first device was told last, N; zero without a connection.
    [[nodiscard]] double force() const;
    /// The same, whether or not there is a connection still.
    [[nodiscard]] double lastTold() const;
    /// How many messages to the first device have come since the fault was set.
    [[nodiscard]] long messagesSinceFault() const;
    /// Which of these was the last one with a force; 0: none. The answer before the first one was still a good one.
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
    [[nodiscard]] std::string state(bool isFirst);
    [[nodiscard]] std::string placeOf(const Hand& hand) const;
    [[nodiscard]] std::string turnOfGrip() const;
    [[nodiscard]] double aside() const;
    [[nodiscard]] int answersToAMessage() const;
    [[nodiscard]] HaplyFault fault() const;
    [[nodiscard]] bool isLate() const;

    int listener_ = -1;
    int port_ = 0;
    mutable std::mutex validator_;  // of everything below
    HaplyFault fault_ = HaplyFault::None;
    std::array<Hand, 2> hands_{{{kFirst}, {kSecond}}};
    std::array<double, 3> wanted_{};  // mm
    std::array<double, 4> grip_{1, 0, 0, 0};
    unsigned buttons_ = 0;
    bool gripThere_ = true;
    std::string firstMessage_;
    bool foreign_ = false;
    long messages_ = 0, sinceFault_ = 0, lastForce_ = 0;
    double lastTold_ = 0;
    int connections_ = 0;
    std::vector<std::jthread> servers_;
    std::jthread acceptor_;
};

}  // namespace tactooth::test
