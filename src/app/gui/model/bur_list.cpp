// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/model/bur_list.h"

#include <QCoreApplication>
#include <algorithm>

#include "app/gui/text/translation.h"
#include "instruments/bur_title.h"

namespace tactooth {
namespace {

QString shown(const std::string& text) { return QString::fromStdString(text); }

QString words(const char* text) { return QCoreApplication::translate("tactooth::BurList", text); }

QString millimetres(double value) { return QString::number(value, 'f', 1); }

}  // namespace

std::vector<BurGroup> groupedByShape(const std::vector<BurItem>& burs) {
    std::vector<BurGroup> groups;
    BurGroup files{words(QT_TRANSLATE_NOOP("tactooth::BurList", "From files")), {}};
    std::vector<BurKind> kinds;
    for (const BurItem& bur : burs) {
        if (!bur.spec) {
            files.burs.push_back(bur);
            continue;
        }
        const auto known = std::ranges::find(kinds, bur.spec->kind);
        const auto place = static_cast<std::size_t>(known - kinds.begin());
        if (known == kinds.end()) {
            kinds.push_back(bur.spec->kind);
            groups.push_back({translated(burKindTitle(bur.spec->kind)), {}});
        }
        groups[place].burs.push_back(bur);
    }
    if (!files.burs.empty()) groups.push_back(std::move(files));
    return groups;
}

QStringList factsOf(const BurItem& bur) {
    if (!bur.spec) return {};
    return {QString("ISO %1").arg(shown(isoNumber(*bur.spec))),
            words(QT_TRANSLATE_NOOP("tactooth::BurList", "Diameter %1 mm")).arg(millimetres(bur.spec->headDiameter)),
            words(QT_TRANSLATE_NOOP("tactooth::BurList", "Head length %1 mm")).arg(millimetres(bur.spec->headLength))};
}

bool matches(const BurItem& bur, const QString& search) {
    QString text = bur.title;
    if (bur.spec) {
        const QString iso = shown(isoNumber(*bur.spec));
        text += ' ' + shown(bur.spec->name) + ' ' + shown(bur.spec->number) + ' ' + QString(iso).remove(' ') + ' ' +
                factsOf(bur).join(' ');
    }
    const QStringList parts = search.split(' ', Qt::SkipEmptyParts);
    return std::ranges::all_of(parts, [&](const QString& part) { return text.contains(part, Qt::CaseInsensitive); });
}

std::set<std::string> burNumbers(const std::string& text) {
    std::set<std::string> numbers;
    for (const QString& part : shown(text).split(',', Qt::SkipEmptyParts)) {
        const std::string number = part.trimmed().toStdString();
        const auto bur = findBur(number);
        if (bur && bur->number == number) numbers.insert(number);
    }
    return numbers;
}

std::string asText(const std::set<std::string>& burNumbers) {
    QStringList parts;
    for (const std::string& number : burNumbers) parts << shown(number);
    return parts.join(", ").toStdString();
}

}  // namespace tactooth
