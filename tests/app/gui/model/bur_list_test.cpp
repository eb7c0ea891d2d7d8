// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/model/bur_list.h"

#include <gtest/gtest.h>

namespace tactooth {
namespace {

std::vector<BurItem> allBurs() {
    std::vector<BurItem> all;
    for (const BurSpec& spec : burCatalogue()) {
        all.push_back({static_cast<int>(all.size()), QString::fromStdString(spec.name), spec});
    }
    all.push_back({static_cast<int>(all.size()), "my own.toml", std::nullopt});
    return all;
}

BurItem item(const char* number) {
    for (const BurItem& bur : allBurs()) {
        if (bur.spec && bur.spec->number == number) return bur;
    }
    ADD_FAILURE() << number;
    return {};
}

TEST(BurList, EachBurIsInTheGroupOfItsShape) {
    std::size_t count = 0;
    for (const BurGroup& group : groupedByShape(allBurs())) {
        ASSERT_FALSE(group.burs.empty());
        for (const BurItem& bur : group.burs) {
            EXPECT_EQ(bur.spec.has_value(), group.burs.front().spec.has_value());
            if (bur.spec) {
                EXPECT_EQ(bur.spec->kind, group.burs.front().spec->kind) << bur.spec->name;
            }
            ++count;
        }
    }
    EXPECT_EQ(count, burCatalogue().size() + 1);
    const auto groups = groupedByShape(allBurs());
    EXPECT_EQ(groups.size(), 13U);  // twelve shapes, and files
    EXPECT_EQ(groups.front().title.toStdString(), "Round");
    EXPECT_EQ(groups.back().title.toStdString(), "From files");
}

TEST(BurList, IsSearchedByWordsNumbersAndSizes) {
    EXPECT_TRUE(matches(item("4"), ""));
    EXPECT_TRUE(matches(item("4"), "round"));
    EXPECT_TRUE(matches(item("4"), "CARBIDE 1.4"));
    EXPECT_FALSE(matches(item("4"), "round diamond"));
    EXPECT_TRUE(matches(item("245"), "245"));
    EXPECT_FALSE(matches(item("4"), "245"));
    EXPECT_TRUE(matches(item("4"), QString::fromStdString(isoNumber(*findBur("4")))));
    EXPECT_TRUE(matches(item("4"), "500314001001014"));
    EXPECT_FALSE(matches(item("4"), "500314001001023"));
    EXPECT_TRUE(matches(allBurs().back(), "own"));
    EXPECT_FALSE(matches(allBurs().back(), "round"));
}

TEST(BurList, TheFactsAreIsoNumberDiameterAndLength) {
    EXPECT_EQ(factsOf(item("4")).join("; ").toStdString(),
              "ISO 500 314 001 001 014; Diameter 1.4 mm; Head length 1.1 mm");
    EXPECT_TRUE(factsOf(allBurs().back()).isEmpty());
}

TEST(BurList, NumbersAreKeptAsATextAndUnknownOnesForgotten) {
    EXPECT_EQ(burNumbers("4, 245,33-1/2 , nothing,, 999"), (std::set<std::string>{"245", "33-1/2", "4"}));
    EXPECT_TRUE(burNumbers("").empty());
    for (const char* text : {"", "4", "245, 33-1/2, 4"}) EXPECT_EQ(asText(burNumbers(text)), text);
    EXPECT_TRUE(burNumbers("500 314 001 001 014").empty());  // only as the catalogue writes them
}

}  // namespace
}  // namespace tactooth
