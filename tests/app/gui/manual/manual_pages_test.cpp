// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/manual/manual_pages.h"

#include <gmock/gmock.h>

#include <QFile>
#include <QRegularExpression>
#include <QUrl>

#include "app/gui/keys/key_page.h"
#include "app/gui/manual/context_help.h"

namespace tactooth {
namespace {

constexpr std::array kLanguages = {Language::English, Language::Japanese};

ManualPages pagesIn(Language language) {
    return {language, [language] { return ownKeyPage({}, language); }};
}

std::string named(const QString& text) { return text.toStdString(); }

/// The targets of links or pictures, as the page has them.
QStringList targets(const QString& text, const char* pattern) {
    QStringList result;
    auto found = QRegularExpression(pattern).globalMatch(text);
    while (found.hasNext()) result << found.next().captured(1);
    return result;
}

/// The path of `target` in the manual, seen from a page.
QString resolved(const QString& page, const QString& target) {
    return QUrl("qrc:/manual/" + page).resolved(QUrl(target)).path().mid(8).replace(".ja.md", ".md");
}

TEST(ManualPages, BeginWithThePageForNewUsersAndHaveAllOthers) {
    const ManualPages pages = pagesIn(Language::English);
    ASSERT_GE(pages.names().size(), 6 + 4);
    EXPECT_EQ(named(pages.names().front()), "user/first-ten-minutes.md");
    for (const char* name : {"user/keys.md", "user/commands.md", "user/metrics.md", "user/replay.md",
                             "user/examinations.md", "haptics.md", "cases.md"}) {
        EXPECT_TRUE(pages.has(name)) << name;
    }
    for (const QString& name : pages.names()) EXPECT_NE(named(pages.title(name)), named(name));
}

TEST(ManualPages, LinksLeadToPagesAndHeadings) {
    for (const Language language : kLanguages) {
        const ManualPages pages = pagesIn(language);
        int checked = 0;
        for (const QString& name : pages.names()) {
            for (const QString& target : targets(pages.text(name), R"(\]\(([^)\s]*\.md[^)\s]*)\))")) {
                const QString page = resolved(name, target);
                const QString anchor = QUrl(target).fragment();
                const bool mustBeThere = name.startsWith("user/");
                EXPECT_TRUE(!mustBeThere || pages.has(page)) << named(name) << ": " << named(target);
                if (!pages.has(page) || anchor.isEmpty()) continue;
                QStringList anchors;
                for (const QString& heading : targets(pages.text(page), R"((?m)^#+ (.*)$)")) {
                    anchors << anchorOf(heading);
                }
                EXPECT_TRUE(anchors.contains(anchor)) << named(name) << ": " << named(target);
                ++checked;
            }
        }
        EXPECT_GT(checked, 1);
    }
}

TEST(ManualPages, PicturesAreInTheProgram) {
    int checked = 0;
    for (const Language language : kLanguages) {
        const ManualPages pages = pagesIn(language);
        for (const QString& name : pages.names()) {
            for (const QString& target : targets(pages.text(name), R"(\(([^)\s]*\.png)\))")) {
                EXPECT_TRUE(QFile::exists(":/manual/" + resolved(name, target))) << named(name) << named(target);
                ++checked;
            }
        }
    }
    EXPECT_GT(checked, 10);
}

TEST(ManualPages, JapanesePagesHaveTheSectionsOfTheEnglishOnes) {
    const ManualPages english = pagesIn(Language::English), japanese = pagesIn(Language::Japanese);
    int translatedPages = 0;
    for (const QString& name : english.names()) {
        EXPECT_EQ(english.sections(name).size(), japanese.sections(name).size()) << named(name);
        const bool isTranslated = named(english.title(name)) != named(japanese.title(name));
        translatedPages += isTranslated ? 1 : 0;
        EXPECT_NE(isTranslated, japanese.text(name).startsWith("*このページはまだ英語だけです。*")) << named(name);
    }
    EXPECT_GE(translatedPages, 2);
}

TEST(ManualPages, AllPlacesOfTheHelpAreThere) {
    const ManualPages pages = pagesIn(Language::Japanese);
    for (const ManualPlace& place : manualPlaces()) {
        ASSERT_TRUE(pages.has(place.page)) << named(place.page);
        EXPECT_LE(place.section, pages.sections(place.page).size()) << named(place.page);
    }
}

TEST(ManualPages, AnchorsAreThoseOfTheRepository) {
    EXPECT_EQ(named(anchorOf("6. An exercise")), "6-an-exercise");
    EXPECT_EQ(named(anchorOf("Start (the first time: some minutes)")), "start-the-first-time-some-minutes");
}

}  // namespace
}  // namespace tactooth
