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

/// A Haply Inverse3 with the VerseGrip on it, accessed through the Haply Inverse Service of this machine.
///
/// A separate thread communicates with the service: each message carries the newest force, each answer the newest pose.
/// The servo thread runs at its own rate and only exchanges the newest values with it. If an answer is late, the device
/// counts as lost, and the thread sends a zero force by itself; it also sends a zero force if the servo thread is late.
/// If several answers have arrived, the newest one counts. More answers than messages also make the device count as
/// lost, because the time at which their content was valid is unknown. The thread retries a broken connection every
/// second.
class HaplyDevice final : public HapticDevice {
public:
    /// `device`: its name in the service, four letters and digits; empty: the first device. `address`: "host:port".
    explicit HaplyDevice(std::string device, std::string address = defaultAddress());
    ~HaplyDevice() override;

    /// $TACTOOTH_HAPLY, else the service's default: localhost:10001.
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

    // Used only by the thread.
    std::unique_ptr<HaplyConnection> connection_;
    std::string text_;
    double faultSetAt_ = 0;         // s
    int outstanding_ = 0;           // number of sent messages without an answer yet
    double surplusAnswerAt_ = -1;   // s: time of the last surplus answer
    Quat turn_ = Quat::Identity();  // last rotation that the grip reported
    /// s: times of the last late answers. Three within a second are reported: a single one is a brief delay of the
    /// machine.
    std::array<double, 3> lateAnswers_ = {-1, -1, -1};

    // Shared between the threads.
    TripleBuffer<HaplyReading> reading_;      // to the servo
    TripleBuffer<Vec3> force_{Vec3::Zero()};  // from the servo, N
    sem_t wake_;                              // posted by the servo thread after each force
    std::atomic<const Message*> faultMessage_{nullptr};

    std::jthread thread_;  // last member: it uses all of the above
};

}  // namespace tactooth
