// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/words.h"

#include <gtest/gtest.h>

#include <QTranslator>

#include "devices/haply/haply_message.h"
#include "devices/open_device.h"
#include "devices/openhaptics/hd_library.h"
#include "devices/pose_watch.h"

namespace tactooth {
namespace {

class Words : public ::testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(japanese_.load(":/translations/tactooth_ja.qm")); }
    [[nodiscard]] bool isTranslated(const char* word) const { return !japanese_.translate("Words", word).isEmpty(); }

    QTranslator japanese_;
};

TEST_F(Words, EachKindOfDeviceHasATranslation) {
    for (const DeviceKind& kind : deviceKinds()) EXPECT_TRUE(isTranslated(kind.title)) << kind.title;
}

TEST_F(Words, EachTroubleOfAPenHasATranslation) {
    for (std::uint32_t code = 0; code < 0x1000; ++code) {
        const char* const text = hdErrorText(code);
        ASSERT_TRUE(isTranslated(text)) << text;
    }
}

TEST_F(Words, EachTroubleOfAnInverse3HasATranslation) {
    for (const char* const lack : {"power_supply", "calibrated", "ready"}) {
        const std::string message = R"({"version":"3.1","inverse3":[{"device_id":"049D","status":{")" +
                                    std::string(lack) +
                                    R"(":false},"state":{"cursor_position":{"x":0.01,"y":0.02,"z":0.1}}}]})";
        const Expected<HaplyReading> reading = readHaply(message, {"049D", ""});
        ASSERT_TRUE(reading) << reading.error().message;
        ASSERT_NE(reading->trouble, nullptr) << lack;
        EXPECT_TRUE(isTranslated(reading->trouble)) << reading->trouble;
    }
    const Expected<HaplyReading> nowhere = readHaply(
        R"({"version":"3.1","inverse3":[{"device_id":"049D","state":{"cursor_position":{"x":null}}}]})", {"049D", ""});
    ASSERT_TRUE(nowhere) << nowhere.error().message;
    ASSERT_NE(nowhere->trouble, nullptr);
    EXPECT_TRUE(isTranslated(nowhere->trouble)) << nowhere->trouble;
    for (const char* const text : {"", "{}"}) {
        const Expected<HaplyReading> none = readHaply(text, {"049D", ""});
        ASSERT_FALSE(none);
        EXPECT_TRUE(isTranslated(none.error().message.c_str())) << none.error().message;
    }
}

TEST_F(Words, AHandThatCannotBeThereHasATranslation) {
    PoseWatch watch;
    watch.see(Vec3::Zero(), true, 0.001);
    watch.see(Vec3(50, 0, 0), true, 0.001);
    ASSERT_NE(watch.trouble(), nullptr);
    EXPECT_TRUE(isTranslated(watch.trouble())) << watch.trouble();
    watch.see(Vec3(NAN, 0, 0), true, 0.001);
    EXPECT_TRUE(isTranslated(watch.trouble())) << watch.trouble();
}

}  // namespace
}  // namespace tactooth
