// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/words.h"

#include <QCoreApplication>
#include <algorithm>
#include <iterator>

namespace tactooth {
namespace {

constexpr const char* kWords[] = {
    QT_TRANSLATE_NOOP("Words", "Lower first molar (46)"),
    QT_TRANSLATE_NOOP("Words", "Upper central incisor (11)"),
    QT_TRANSLATE_NOOP("Words", "Upper canine (13)"),
    QT_TRANSLATE_NOOP("Words", "Round carbide No. 2, 1.0 mm"),
    QT_TRANSLATE_NOOP("Words", "Round carbide No. 4, 1.4 mm"),
    QT_TRANSLATE_NOOP("Words", "Round carbide No. 6, 1.8 mm"),
    QT_TRANSLATE_NOOP("Words", "Straight fissure carbide No. 57, 1.0 mm"),
    QT_TRANSLATE_NOOP("Words", "Straight fissure carbide No. 58, 1.2 mm"),
    QT_TRANSLATE_NOOP("Words", "Pear carbide No. 330, 0.8 mm"),
    QT_TRANSLATE_NOOP("Words", "Long pear carbide No. 245, 0.8 mm"),
    QT_TRANSLATE_NOOP("Words", "Round diamond 801-014, 1.4 mm"),
    QT_TRANSLATE_NOOP("Words", "Round-end taper diamond 856-016, 1.6 mm"),
    QT_TRANSLATE_NOOP("Words", "Air turbine, 400,000 rev/min"),
    QT_TRANSLATE_NOOP("Words", "Electric 1:5, 200,000 rev/min"),
    QT_TRANSLATE_NOOP("Words", "Low-speed contra-angle, 25,000 rev/min"),
    QT_TRANSLATE_NOOP("Words", "enamel"),
    QT_TRANSLATE_NOOP("Words", "dentin"),
    QT_TRANSLATE_NOOP("Words", "pulp"),
    QT_TRANSLATE_NOOP("Words", "caries"),
    QT_TRANSLATE_NOOP("Words", "restoration"),
    QT_TRANSLATE_NOOP("Words", "other"),
    QT_TRANSLATE_NOOP("Words", "outer"),
    QT_TRANSLATE_NOOP("Words", "sound starting"),
    QT_TRANSLATE_NOOP("Words", "sound on"),
    QT_TRANSLATE_NOOP("Words", "no sound card: silent"),
};

}  // namespace

QString translated(std::string_view word) {
    const auto* const known =
        std::find_if(std::begin(kWords), std::end(kWords), [&](const char* each) { return each == word; });
    if (known != std::end(kWords)) return QCoreApplication::translate("Words", *known);
    return QString::fromUtf8(word.data(), static_cast<qsizetype>(word.size()));
}

}  // namespace tactooth
