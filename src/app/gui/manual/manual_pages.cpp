// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/manual/manual_pages.h"

#include <QDir>
#include <QFile>
#include <QTextBlock>
#include <QTextDocument>
#include <algorithm>
#include <utility>

#include "app/gui/manual/messages.h"

namespace tactooth {
namespace {

constexpr const char* kFolder = ":/manual/";
constexpr const char* kKeys = "user/keys.md";
constexpr const char* kEnding = ".md";
constexpr const char* kJapanese = ".ja.md";

/// The first pages of the contents list; the others follow by their names.
const QStringList& firstPages() {
    static const QStringList kFirst = {"user/first-ten-minutes.md",
                                       kKeys,
                                       "user/finish.md",
                                       "user/editor.md",
                                       "user/examinations.md",
                                       "user/replay.md",
                                       "user/metrics.md"};
    return kFirst;
}

QString read(const QString& name) {
    QFile file(kFolder + name);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

QString japaneseName(const QString& name) { return name.chopped(QString(kEnding).size()) + kJapanese; }

/// The lines that begin with `mark`, without it, outside of code.
QStringList headings(const QString& text, const QString& mark) {
    QStringList result;
    bool isCode = false;
    for (const QString& line : text.split('\n')) {
        if (line.startsWith("```")) isCode = !isCode;
        if (!isCode && line.startsWith(mark)) result << line.mid(mark.size()).remove('`').trimmed();
    }
    return result;
}

/// A part of the text around `at` that is short enough for a list.
QString excerpt(const QString& text, qsizetype at) {
    constexpr qsizetype kBefore = 30, kLength = 110;
    const qsizetype begin = std::max<qsizetype>(0, at - kBefore);
    const QString part = text.mid(begin, kLength).trimmed();
    return (begin > 0 ? "…" : "") + part + (begin + kLength < text.size() ? "…" : "");
}

}  // namespace

ManualPages::ManualPages(Language language, std::function<std::string()> keyPage)
    : language_(language), keyPage_(std::move(keyPage)) {
    for (const QString& page : firstPages()) {
        if (QFile::exists(kFolder + page)) names_ << page;
    }
    for (const char* folder : {"user/", ""}) {
        for (const QString& file : QDir(QString(kFolder) + folder).entryList({"*.md"}, QDir::Files, QDir::Name)) {
            if (!file.endsWith(kJapanese) && !names_.contains(folder + file)) names_ << folder + file;
        }
    }
}

QString ManualPages::text(const QString& name) const {
    if (name == kKeys) return QString::fromStdString(keyPage_());
    if (language_ == Language::English) return read(name);
    const QString own = japaneseName(name);
    if (QFile::exists(kFolder + own)) return read(own);
    const std::string_view note = msg::kManualOnlyEnglish.in(language_);
    return "*" + QString::fromUtf8(note.data(), static_cast<qsizetype>(note.size())) + "*\n\n" + read(name);
}

QString ManualPages::title(const QString& name) const {
    const QStringList titles = headings(text(name), "# ");
    return titles.isEmpty() ? name : titles.front();
}

QStringList ManualPages::sections(const QString& name) const { return headings(text(name), "## "); }

/// What a reader sees of the page, without the marks of Markdown.
const std::vector<ManualPages::Block>& ManualPages::blocks(const QString& name) const {
    const auto known = blocks_.find(name);
    if (known != blocks_.end() && name != kKeys) return known->second;
    std::vector<Block> found;
    QTextDocument page;
    page.setMarkdown(text(name));
    int section = 0;
    for (QTextBlock block = page.begin(); block.isValid(); block = block.next()) {
        if (block.blockFormat().headingLevel() == 2) ++section;
        const QString words = block.text().simplified().remove(QChar::ObjectReplacementCharacter);
        if (!words.isEmpty()) found.push_back({section, words});
    }
    return blocks_[name] = std::move(found);
}

std::vector<ManualPages::Hit> ManualPages::search(const QString& wanted, std::size_t most) const {
    const QStringList words = wanted.simplified().split(' ', Qt::SkipEmptyParts);
    std::vector<Hit> hits;
    if (words.isEmpty()) return hits;
    for (const QString& name : names_) {
        for (const Block& block : blocks(name)) {
            const bool hasAll = std::ranges::all_of(
                words, [&](const QString& word) { return block.text.contains(word, Qt::CaseInsensitive); });
            if (!hasAll) continue;
            if (hits.size() == most) return hits;
            hits.push_back(
                {name, block.section, excerpt(block.text, block.text.indexOf(words.front(), 0, Qt::CaseInsensitive))});
        }
    }
    return hits;
}

QString anchorOf(const QString& heading) {
    QString anchor;
    for (const QChar sign : heading.toLower()) {
        if (sign.isLetterOrNumber() || sign == '-' || sign == '_') anchor += sign;
        if (sign.isSpace()) anchor += '-';
    }
    return anchor;
}

}  // namespace tactooth
