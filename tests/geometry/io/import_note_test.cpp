// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/io/import_note.h"

#include <gtest/gtest.h>

namespace tactooth {
namespace {

TEST(ImportNote, ValuesStandInTheirPlaces) {
    EXPECT_EQ(inWords({ImportNoteTopic::Layers, "%2 before %1, 5% of it", {"a", "b"}}), "b before a, 5% of it");
    EXPECT_EQ(inWords({ImportNoteTopic::Units, "none at all %"}), "none at all %");
}

TEST(ImportNote, NumbersAreRounded) {
    EXPECT_EQ(rounded(1.25951, 2), "1.26");
    EXPECT_EQ(rounded(-3, 0), "-3");
}

}  // namespace
}  // namespace tactooth
