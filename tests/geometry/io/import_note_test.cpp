// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/io/import_note.h"

#include <gtest/gtest.h>

namespace tactooth {
namespace {

TEST(ImportNote, NumbersAreRounded) {
    EXPECT_EQ(rounded(1.25951, 2), "1.26");
    EXPECT_EQ(rounded(-3, 0), "-3");
}

}  // namespace
}  // namespace tactooth
