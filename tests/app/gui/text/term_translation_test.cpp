// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/text/term_translation.h"

#include <gtest/gtest.h>

#include <QTranslator>

#include "devices/probe/device_backend.h"

namespace tactooth {
namespace {

class Words : public ::testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(japanese_.load(":/translations/tactooth_ja.qm")); }
    [[nodiscard]] bool isTranslated(const char* word) const { return !japanese_.translate("Words", word).isEmpty(); }

    QTranslator japanese_;
};

TEST_F(Words, EachKindOfDeviceHasATranslation) {
    for (const DeviceBackend& kind : deviceBackends()) EXPECT_TRUE(isTranslated(kind.title)) << kind.title;
}

}  // namespace
}  // namespace tactooth
