// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/text/error_translation.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>
#include <algorithm>
#include <functional>
#include <iterator>
#include <vector>

#include "app/gui/text/error_messages.h"

namespace tactooth {
namespace {

/// A sentence, ready to be looked for.
struct Known {
    const char* text;
    QRegularExpression pattern;
    qsizetype letters;  // outside of its parts
};

/// A sentence may be a part of another one, which has a full stop of its own.
QString withoutStop(const QString& sentence) {
    const QString stop = QCoreApplication::translate("Error", ".");
    return sentence.endsWith(stop) ? sentence.chopped(stop.size()) : sentence;
}

Known knownOf(const char* text) {
    const QString sentence = QString::fromUtf8(text);
    QStringList between = (sentence.endsWith('.') ? sentence.chopped(1) : sentence).split(QRegularExpression("%\\d"));
    const qsizetype letters = between.join("").size();
    for (QString& words : between) words = QRegularExpression::escape(words);
    return {text,
            QRegularExpression(QRegularExpression::anchoredPattern(between.join("(.*?)")),
                               QRegularExpression::DotMatchesEverythingOption),
            letters};
}

/// Those that say most come first: what fits them fits many a shorter one as well.
const std::vector<Known>& known() {
    static const std::vector<Known> all = [] {
        std::vector<Known> made;
        std::ranges::transform(translatableErrors(), std::back_inserter(made), knownOf);
        std::ranges::stable_sort(made, std::ranges::greater(), &Known::letters);
        return made;
    }();
    return all;
}

QString filled(const QString& sentence, const QStringList& parts) {
    QString result;
    for (qsizetype at = 0; at < sentence.size(); ++at) {
        const bool isPlace = sentence[at] == '%' && at + 1 < sentence.size() && sentence[at + 1].isDigit();
        result += isPlace ? parts.value(sentence[++at].digitValue() - 1) : QString(sentence[at]);
    }
    return result;
}

/// `sentence`, which is without its full stop, in the language of the window.
QString inWords(const QString& sentence) {
    for (const Known& each : known()) {
        const QRegularExpressionMatch match = each.pattern.match(sentence);
        if (!match.hasMatch()) continue;
        QStringList parts = match.capturedTexts().mid(1);
        for (QString& part : parts) part = inWords(part);
        return filled(withoutStop(QCoreApplication::translate("Error", each.text)), parts);
    }
    // Perhaps a sentence behind the name of what it is about.
    const qsizetype colon = sentence.indexOf(": ");
    if (colon < 0) return sentence;
    const QString behind = sentence.mid(colon + 2), words = inWords(behind);
    if (words == behind) return sentence;
    return filled(QCoreApplication::translate("Error", "%1: %2"), {inWords(sentence.left(colon)), words});
}

}  // namespace

std::span<const char* const> translatableErrors() {
    static const std::vector<const char*> all = [] {
        std::vector<const char*> made;
        for (const auto& some : {fileErrors(), textErrors(), deviceErrors()})
            std::ranges::copy(some, std::back_inserter(made));
        return made;
    }();
    return all;
}

QString translatedError(std::string_view message) {
    const QString whole = QString::fromUtf8(message.data(), static_cast<qsizetype>(message.size()));
    if (!whole.endsWith('.')) return inWords(whole);
    const QString sentence = whole.chopped(1);
    const QString words = inWords(sentence);
    return words == sentence ? whole : words + QCoreApplication::translate("Error", ".");
}

}  // namespace tactooth
