// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/model/file_writer.h"

#include <gtest/gtest.h>

#include <future>
#include <optional>
#include <string>
#include <vector>

#include "geometry/util/byte_text.h"
#include "support/test_data.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

FileWriter::Write textTo(const fs::path& file, const std::string& text) {
    return [=](const GoesOn& goesOn) { return writeInPieces(file, asBytes(text), goesOn); };
}

/// Holds up the files behind it until it is opened.
class Gate {
public:
    [[nodiscard]] FileWriter::Write write() const {
        return [open = opened_](const GoesOn& goesOn) -> Expected<bool> {
            open.wait();
            return goesOn(1);
        };
    }
    void open() { promise_.set_value(); }

private:
    std::promise<void> promise_;
    std::shared_future<void> opened_{promise_.get_future()};
};

std::size_t filesIn(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(FileWriter, WritesFilesInTheirOrderAndSaysSo) {
    const test::TemporaryFolder folder;
    std::vector<std::string> order;
    FileWriter writer;
    for (const char* const text : {"one", "two", "three"}) {
        writer.write(textTo(folder / "file", text), [&order, text](const Expected<bool>& written) {
            ASSERT_TRUE(written && *written);
            order.emplace_back(text);
        });
    }
    EXPECT_TRUE(writer.isBusy());
    writer.finish();
    EXPECT_FALSE(writer.isBusy());
    EXPECT_EQ(order, (std::vector<std::string>{"one", "two", "three"}));
    EXPECT_EQ(test::readText(folder / "file"), "three");
    EXPECT_EQ(writer.unwritten(), 0u);
}

TEST(FileWriter, OneThatFailsSaysWhyAndTheNextIsWritten) {
    const test::TemporaryFolder folder;
    std::string why;
    FileWriter writer;
    writer.write(textTo(folder / "missing/file", "x"),
                 [&](const Expected<bool>& written) { why = written ? "" : written.error().message(); });
    writer.write(textTo(folder / "file", "x"), {});
    writer.finish();
    EXPECT_NE(why.find("missing"), std::string::npos) << why;
    EXPECT_EQ(test::readText(folder / "file"), "x");
    EXPECT_EQ(writer.unwritten(), 1u);
}

TEST(FileWriter, CancelLeavesTheOlderFilesAndNothingElse) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "file", "older");
    Gate gate;
    std::vector<bool> written;
    const auto note = [&](const Expected<bool>& one) { written.push_back(one.value()); };
    FileWriter writer;
    writer.write(gate.write(), note);
    writer.write(textTo(folder / "file", "newer"), note);
    writer.cancel();
    gate.open();
    writer.finish();
    EXPECT_EQ(written, (std::vector<bool>{false, false}));
    EXPECT_EQ(writer.unwritten(), 2u);
    EXPECT_EQ(test::readText(folder / "file"), "older");
    EXPECT_EQ(filesIn(folder.path()), 1u);
    writer.write(textTo(folder / "file", "newer"), note);  // what comes later is not cancelled
    writer.finish();
    EXPECT_EQ(test::readText(folder / "file"), "newer");
}

TEST(FileWriter, AWriterThatEndsHasWrittenEverything) {
    const test::TemporaryFolder folder;
    Gate gate;
    {
        FileWriter writer;
        writer.write(gate.write(), [](const Expected<bool>&) { FAIL() << "nobody is left to hear it"; });
        writer.write(textTo(folder / "file", "x"), {});
        EXPECT_FALSE(fs::exists(folder / "file"));
        gate.open();
    }
    EXPECT_EQ(test::readText(folder / "file"), "x");
}

TEST(FileWriter, ShowsTheShareOfThePresentFile) {
    FileWriter writer;
    EXPECT_EQ(writer.share(), 0);
    std::promise<void> reached, leave;
    writer.write(
        [&](const GoesOn& goesOn) -> Expected<bool> {
            const bool goes = goesOn(0.25);
            reached.set_value();
            leave.get_future().wait();
            return goes;
        },
        {});
    reached.get_future().wait();
    EXPECT_EQ(writer.share(), 0.25);
    leave.set_value();
    writer.finish();
    EXPECT_EQ(writer.share(), 0);
}

TEST(WriteInPieces, ReportsEachPieceAndCanBeGivenUpAtAny) {
    const test::TemporaryFolder folder;
    const std::string text((std::size_t{3} << 20) + 5, 'x');  // four pieces
    std::vector<double> shares;
    ASSERT_TRUE(writeInPieces(folder / "file", asBytes(text), [&](double share) {
                    shares.push_back(share);
                    return true;
                }).value());
    ASSERT_EQ(shares.size(), 5u);
    EXPECT_TRUE(std::ranges::is_sorted(shares));
    EXPECT_EQ(shares.back(), 1);
    EXPECT_EQ(test::readText(folder / "file"), text);
    for (std::size_t last = 0; last < shares.size(); ++last) {
        std::size_t calls = 0;
        EXPECT_FALSE(writeInPieces(folder / "other", asBytes(text), [&](double) { return calls++ < last; }).value());
        EXPECT_EQ(filesIn(folder.path()), 1u) << last;
    }
}

}  // namespace
}  // namespace tactooth
