// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/model/tick_output.h"

#include <gtest/gtest.h>

#include "live/udp_listener.h"
#include "model/model_scene.h"
#include "session/live/live_stream.h"

namespace tactooth {
namespace {

class TickOutputTest : public testing::Test {
protected:
    [[nodiscard]] LiveRunner::TickListener listener() { return output_.listener(HapticSettings(), BurEdge()); }
    /// A tick of a bur that turns in the tooth, with its pedal down.
    [[nodiscard]] static Tick cutting() {
        Tick tick;
        tick.input.cutting = true;
        tick.input.pedal = 1;
        tick.spindle.speedRpm = HapticSettings().spindle.freeSpeedRpm;
        return tick;
    }
    void streamToListener() {
        auto stream = LiveStream::open(udp_.url());
        ASSERT_TRUE(stream) << stream.error().message();
        output_.streamTo(std::move(*stream));
    }

    const test::UdpListener udp_;
    test::SpySound sound_;
    InstrumentSet instruments_{test::runInline};
    TickOutput output_{sound_, instruments_};
};

TEST_F(TickOutputTest, EachTickIsHeardOnce) {
    const auto send = listener();
    for (int tick = 0; tick < 3; ++tick) send(cutting());
    EXPECT_EQ(sound_.published(), 3);
    EXPECT_GT(sound_.water(), 0);
}

TEST_F(TickOutputTest, InstrumentsThatAreOffAreNotHeard) {
    instruments_.setWater(false);
    listener()(cutting());
    EXPECT_EQ(sound_.water(), 0);
}

TEST_F(TickOutputTest, OnlyListenersThatAreMadeLaterSendToAStream) {
    const auto before = listener();
    streamToListener();
    before(cutting());
    EXPECT_FALSE(udp_.hasDatagram());
    listener()(cutting());
    EXPECT_EQ(udp_.next().size(), kStreamBytes);
}

TEST_F(TickOutputTest, AListenerThatRunsObeysTheProhibition) {
    streamToListener();
    const auto send = listener();
    output_.setStreamAllowed(false);
    send(cutting());
    EXPECT_FALSE(udp_.hasDatagram());
    EXPECT_EQ(sound_.published(), 1) << "it is still heard";
    output_.setStreamAllowed(true);
    send(cutting());
    EXPECT_EQ(udp_.next().size(), kStreamBytes);
}

}  // namespace
}  // namespace tactooth
