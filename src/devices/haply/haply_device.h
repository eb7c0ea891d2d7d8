// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <semaphore.h>

#include <array>
#include <atomic>
#include <memory>
#include <string>
#include <thread>

#include "devices/base/haptic_device.h"
#include "devices/haply/haply_connection.h"
#include "devices/haply/haply_message.h"
#include "geometry/util/triple_buffer.h"

namespace tactooth {

/// A Haply Inverse3 with the VerseGrip on it, through the Haply Inverse Service of this machine.
///
/// A thread of its own talks to the service: one message with the newest force, one answer with the newest place. The
/// servo thread follows its own clock and only exchanges the newest values with it. An answer that is late makes the
/// device count as lost, and the thread sends a zero force of its own accord; so it does when the servo is late. Of
/// several answers that have come the newest one counts, but more answers than messages make the device count as lost,
/// too: nobody knows when what they tell was true. A connection that broke is tried again every second.
class HaplyDevice final : public HapticDevice {
public:
    /// `device`: its name with the service, four letters and digits; empty: the first. `address`: "host:port".
    explicit HaplyDevice(std::string device, std::string address = defaultAddress());
    ~HaplyDevice() override;

    /// $TACTOOTH_HAPLY, else the service's own: localhost:10001.
    [[nodiscard]] static std::string defaultAddress();

    [[nodiscard]] const DeviceInfo& info() const override { return info_; }
    [[nodiscard]] Expected<void> open() override;
    void close() override;
    [[nodiscard]] DeviceSample read(double elapsed) override;
    void write(const SafeWrench& wrench) override;
    [[nodiscard]] const Message* faultMessage() const override;

private:
    [[nodiscard]] Expected<std::unique_ptr<HaplyConnection>> handshake(const std::string& wanted);
    void describe();
    void run(const std::stop_token& stop);
    [[nodiscard]] bool exchange(const std::stop_token& stop);
    [[nodiscard]] bool waitForLateAnswer(const std::stop_token& stop);
    [[nodiscard]] bool isRepeatedlyLate(double now);
    [[nodiscard]] bool waitForForce();
    [[nodiscard]] bool drainPending();
    [[nodiscard]] bool receiveAnswers();
    void countAnswers(int answers);
    [[nodiscard]] bool isConnectionValid() const;
    void parseAnswer();
    void setFault(const Message& message);
    void clearOldFault();

    std::string wanted_;
    std::string address_;
    DeviceInfo info_;
    HaplyNames names_;

    // The thread's own.
    std::unique_ptr<HaplyConnection> connection_;
    std::string text_;
    double faultSetAt_ = 0;         // s
    int outstanding_ = 0;           // answers to messages that were sent
    double surplusAnswerAt_ = -1;   // s: when an answer too many came last
    Quat turn_ = Quat::Identity();  // that the grip told last
    /// s: when the last answers were late. Three within a second are told: one alone is a hiccup of the machine.
    std::array<double, 3> lateAnswers_ = {-1, -1, -1};

    // Between the threads.
    TripleBuffer<HaplyReading> reading_;      // to the servo
    TripleBuffer<Vec3> force_{Vec3::Zero()};  // from the servo, N
    sem_t wake_;                              // posted by the servo after each force
    std::atomic<const Message*> faultMessage_{nullptr};

    std::jthread thread_;  // last: it uses all of the above
};

}  // namespace tactooth
