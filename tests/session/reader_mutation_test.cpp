// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Whatever a file holds, its reader gives a result or one sentence, and never crashes.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "session/material_file.h"
#include "session/trajectory.h"
#include "support/test_data.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

constexpr int kMutations = 2000;

/// Changes a text in a few places: bytes, pieces left out, doubled or moved, and words that readers trip over.
class Mutator {
public:
    std::string mutated(std::string text) {
        for (int i = 1 + static_cast<int>(below(4)); i > 0; --i) change(text);
        return text;
    }

private:
    std::size_t below(std::size_t limit) { return random_() % limit; }

    void change(std::string& text) {
        const std::size_t at = below(text.size() + 1);
        const std::size_t length = std::min(below(40), text.size() - at);
        switch (below(7)) {
            case 0:
                text.erase(at, length);
                break;
            case 1:
                text.insert(at, text.substr(at, length));
                break;
            case 2:
                text.insert(below(text.size() + 1), text.substr(at, length));
                break;
            case 3:
                text.resize(at);
                break;
            case 4:
                text.insert(at, kWords[below(std::size(kWords))]);
                break;
            default:
                if (at < text.size()) text[at] = static_cast<char>(below(256));
        }
    }

    static constexpr std::string_view kWords[] = {"nan",
                                                  "-inf",
                                                  "1e999",
                                                  "-1",
                                                  "\"",
                                                  "'",
                                                  "\"\"\"",
                                                  "[",
                                                  "]",
                                                  "{",
                                                  "}",
                                                  "=",
                                                  ",",
                                                  "\n",
                                                  "\r",
                                                  "#",
                                                  "0x",
                                                  "\xff",
                                                  "\xEF\xBB\xBF",
                                                  "[[",
                                                  "a.b.c",
                                                  "1979-05-27",
                                                  "true",
                                                  "\\u12",
                                                  "e",
                                                  "[enamel]\n",
                                                  "colour = [1,2]\n",
                                                  "1e-999",
                                                  "+",
                                                  "99999999999999999999"};
    std::mt19937 random_{20260206};
};

void expectASentence(const std::string& message) {
    EXPECT_GT(message.size(), 20U);
    EXPECT_LT(message.size(), 1000U);
    EXPECT_EQ(message.back(), '.') << message;
    EXPECT_EQ(message.find('\n'), message.npos) << message;
}

TEST(ReaderMutation, ATrajectoryIsReadOrRefusedWithASentence) {
    std::string text = "# a touch\nt,x,y,z,qw,qx,qy,qz\n";
    for (int i = 0; i < 20; ++i)
        text += std::to_string(0.001 * i) + ",0.5,-1e-3," + std::to_string(i) + ",0.6,0,0.8,0\n";
    const test::TemporaryFolder folder;
    Mutator mutator;
    int accepted = 0;
    for (int i = 0; i < kMutations; ++i) {
        test::writeText(folder / "m.csv", mutator.mutated(text));
        const auto trajectory = readTrajectory(folder / "m.csv");
        if (!trajectory) {
            expectASentence(trajectory.error().message);
            continue;
        }
        ++accepted;
        ASSERT_FALSE(trajectory->empty());
        for (const TimedPose& pose : *trajectory) {
            ASSERT_TRUE(pose.toolInTooth.position.allFinite() && std::isfinite(pose.time));
            ASSERT_NEAR(pose.toolInTooth.rotation.norm(), 1, 1e-12);
        }
    }
    EXPECT_GT(accepted, kMutations / 100);  // a comma more or less is enough to be refused
    EXPECT_LT(accepted, kMutations * 19 / 20);
}

TEST(ReaderMutation, MaterialsAreReadOrRefusedWithASentence) {
    const std::string text(defaultMaterialsText());
    const std::string body = text.substr(text.find("[enamel]"));
    Mutator mutator;
    int accepted = 0;
    for (int i = 0; i < kMutations; ++i) {
        const auto table = parseMaterials(mutator.mutated(body), "m.toml", {});
        if (!table) {
            expectASentence(table.error().message);
            EXPECT_EQ(table.error().message.rfind("m.toml, line ", 0), 0U) << table.error().message;
            continue;
        }
        ++accepted;
        for (std::size_t m = 0; m < kMaterialCount; ++m) {
            const Material& material = (*table)[static_cast<MaterialId>(m)];
            for (const double value : {material.stiffness, material.damping, material.friction, material.removal,
                                       material.soundCentre, material.soundBrightness}) {
                ASSERT_TRUE(std::isfinite(value) && value >= 0);
            }
        }
    }
    EXPECT_GT(accepted, kMutations / 20);
    EXPECT_LT(accepted, kMutations * 19 / 20);
}

}  // namespace
}  // namespace tactooth
