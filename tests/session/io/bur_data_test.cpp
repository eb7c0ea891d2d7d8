// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// CMake makes the catalogue of burs from data/burs.toml; here the program's reader of TOML reads the same file.
#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <set>

#include "instruments/bur_catalogue.h"
#include "session/cases/messages.h"
#include "session/io/limited_toml.h"
#include "session/io/toml_reader.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

class BurData : public ::testing::Test {
protected:
    void SetUp() override {
        auto read = readToml(test::sourceFolder() / "data/burs.toml");
        ASSERT_TRUE(read) << read.error().message();
        root_ = std::move(*read);
        rows_ = toml_.tables(root_, "bur");
    }

    TomlReader toml_{"data/burs.toml"};
    toml::table root_;
    std::vector<const toml::table*> rows_;
};

/// The kind of a word of the file; nothing for an unknown one.
std::optional<BurKind> kindOf(const std::string& word) {
    static const std::map<std::string, BurKind> kinds = {{"round", BurKind::Round},
                                                         {"inverted-cone", BurKind::InvertedCone},
                                                         {"straight-fissure", BurKind::StraightFissure},
                                                         {"dome-fissure", BurKind::DomeFissure},
                                                         {"tapered-fissure", BurKind::TaperedFissure},
                                                         {"round-end-taper", BurKind::RoundEndTaper},
                                                         {"pear", BurKind::Pear},
                                                         {"flame", BurKind::Flame},
                                                         {"football", BurKind::Football},
                                                         {"torpedo", BurKind::Torpedo},
                                                         {"needle", BurKind::Needle},
                                                         {"wheel", BurKind::Wheel}};
    const auto found = kinds.find(word);
    return found == kinds.end() ? std::nullopt : std::optional(found->second);
}

TEST_F(BurData, HasNoKeyThatTheCatalogueDoesNotRead) {
    static constexpr MessageText kTheFile{"the_file", "the file", "ファイル"};
    toml_.allow(root_, kTheFile, {"bur"});
    for (const toml::table* row : rows_) {
        toml_.allow(*row, msg::kABur,
                    {"number", "shape", "kind", "iso", "diameter", "length", "taper", "blades", "contact_blades",
                     "notches", "grit_um"});
        const bool isDiamond = row->get("grit_um") != nullptr;
        EXPECT_NE(isDiamond, row->get("blades") != nullptr) << toml_.text(*row, "number", true);
    }
    EXPECT_FALSE(toml_.error()) << toml_.error()->message();
}

TEST_F(BurData, EachRowIsABurOfTheCatalogueInTheSameOrder) {
    ASSERT_EQ(rows_.size(), burCatalogue().size());
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const BurSpec& bur = burCatalogue()[i];
        SCOPED_TRACE(bur.number);
        const toml::table& row = *rows_[i];
        EXPECT_EQ(bur.number, toml_.text(row, "number", true));
        EXPECT_TRUE(bur.name.starts_with(toml_.text(row, "shape", true) + " ")) << bur.name;
        EXPECT_EQ(kindOf(toml_.text(row, "kind", true)), bur.kind);
        EXPECT_EQ(bur.isoShape, toml_.integer(row, "iso", -1, 1, 999));
        EXPECT_EQ(bur.headDiameter, toml_.number(row, "diameter", -1, 0.1, 10));
        EXPECT_EQ(bur.headLength, toml_.number(row, "length", -1, 0.1, 20));
        EXPECT_EQ(bur.taperDegrees, toml_.number(row, "taper", 0, -45, 45));
        EXPECT_EQ(bur.flutes, toml_.integer(row, "blades", 0, 1, 60));
        EXPECT_EQ(bur.crossCut, toml_.integer(row, "notches", 0, 1, 1) == 1);
        EXPECT_EQ(bur.gritMicrometres, toml_.number(row, "grit_um", 0, 1, 500));
        EXPECT_EQ(bur.material == BurMaterial::Diamond, bur.gritMicrometres > 0);
    }
    EXPECT_FALSE(toml_.error()) << toml_.error()->message();
}

TEST_F(BurData, NoNumberStandsThereTwice) {
    std::set<std::string> numbers;
    for (const BurSpec& bur : burCatalogue()) EXPECT_TRUE(numbers.insert(bur.number).second) << bur.number;
}

}  // namespace
}  // namespace tactooth
