// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/experiment.h"

#include <gtest/gtest.h>

#include <limits>

#include "geometry/util/number_text.h"
#include "support/test_data.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

TEST(Experiment, NumbersAreShort) {
    EXPECT_EQ(shortNumber(0), "0");
    EXPECT_EQ(shortNumber(1), "1");
    EXPECT_EQ(shortNumber(0.012345), "0.0123");
    EXPECT_EQ(shortNumber(12.345), "12.3");
    EXPECT_EQ(shortNumber(-1234.5), "-1230");
    EXPECT_EQ(shortNumber(99.99), "100");
    EXPECT_EQ(shortNumber(0.001), "0.001");
    EXPECT_EQ(shortNumber(std::numeric_limits<double>::infinity()), "none");
    EXPECT_EQ(numberText(4406), "4406");
    EXPECT_EQ(numberText(0.1), "0.1");
}

TEST(Experiment, CsvHoldsAllRowsAndQuotesText) {
    const test::TemporaryFolder folder;
    Experiment experiment;
    experiment.columns = {"tooth", "ms"};
    experiment.rows = {{"molar", 1.5}, {"first, \"large\"", 0.1}};
    ASSERT_TRUE(writeExperimentCsv(experiment, folder / "x.csv"));
    EXPECT_EQ(test::readText(folder / "x.csv"), "tooth,ms\nmolar,1.5\n\"first, \"\"large\"\"\",0.1\n");
    EXPECT_FALSE(writeExperimentCsv(experiment, folder / "none" / "x.csv"));
}

}  // namespace
}  // namespace tactooth
