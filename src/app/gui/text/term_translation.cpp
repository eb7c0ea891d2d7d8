// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/text/term_translation.h"

#include <QCoreApplication>
#include <algorithm>
#include <iterator>
#include <utility>

namespace tactooth {
namespace {

/// Its translation is the code of the window's language, "ja": the titles of materials stand in data files.
constexpr const char* kLanguage = QT_TRANSLATE_NOOP("Words", "en");

constexpr const char* kWords[] = {
    QT_TRANSLATE_NOOP("Words", "Lower first molar (46)"),
    QT_TRANSLATE_NOOP("Words", "Upper central incisor (11)"),
    QT_TRANSLATE_NOOP("Words", "Upper canine (13)"),
    QT_TRANSLATE_NOOP("Words", "Pit in the molar"),
    QT_TRANSLATE_NOOP("Words",
                      "Open the central pit 1.5 mm deep, as wide as the bur: down and up again without going aside."),
    QT_TRANSLATE_NOOP("Words", "Class I cavity in the molar"),
    QT_TRANSLATE_NOOP(
        "Words",
        "Follow the central fissure, 1.5 mm deep and 1.2 mm wide with a flat floor; leave 2 mm of both ridges."),
    QT_TRANSLATE_NOOP("Words", "Class V cavity at the neck of the canine"),
    QT_TRANSLATE_NOOP("Words",
                      "At the buccal neck, 1.1 mm deep everywhere: the floor follows the surface of the tooth."),
    QT_TRANSLATE_NOOP("Words", "Round"),
    QT_TRANSLATE_NOOP("Words", "Inverted cone"),
    QT_TRANSLATE_NOOP("Words", "Pear"),
    QT_TRANSLATE_NOOP("Words", "Long pear"),
    QT_TRANSLATE_NOOP("Words", "Straight fissure"),
    QT_TRANSLATE_NOOP("Words", "Cross-cut straight fissure"),
    QT_TRANSLATE_NOOP("Words", "Dome-end fissure"),
    QT_TRANSLATE_NOOP("Words", "Tapered fissure"),
    QT_TRANSLATE_NOOP("Words", "Cross-cut tapered fissure"),
    QT_TRANSLATE_NOOP("Words", "Long tapered fissure"),
    QT_TRANSLATE_NOOP("Words", "Round-end tapered fissure"),
    QT_TRANSLATE_NOOP("Words", "Dome-end tapered fissure"),
    QT_TRANSLATE_NOOP("Words", "Ball finishing"),
    QT_TRANSLATE_NOOP("Words", "Egg finishing"),
    QT_TRANSLATE_NOOP("Words", "Needle finishing"),
    QT_TRANSLATE_NOOP("Words", "Football"),
    QT_TRANSLATE_NOOP("Words", "Flat-end cylinder"),
    QT_TRANSLATE_NOOP("Words", "Flat-end taper"),
    QT_TRANSLATE_NOOP("Words", "Round-end taper"),
    QT_TRANSLATE_NOOP("Words", "Needle"),
    QT_TRANSLATE_NOOP("Words", "Flame"),
    QT_TRANSLATE_NOOP("Words", "Torpedo"),
    QT_TRANSLATE_NOOP("Words", "Torpedo taper"),
    QT_TRANSLATE_NOOP("Words", "Round-end cylinder"),
    QT_TRANSLATE_NOOP("Words", "Wheel"),
    QT_TRANSLATE_NOOP("Words", "%1 carbide No. %2, %3"),
    QT_TRANSLATE_NOOP("Words", "%1 diamond %2, %3"),
    QT_TRANSLATE_NOOP("Words", "Air turbine, 400,000 rev/min"),
    QT_TRANSLATE_NOOP("Words", "Electric 1:5, 200,000 rev/min"),
    QT_TRANSLATE_NOOP("Words", "Low-speed contra-angle, 25,000 rev/min"),
    kLanguage,
    QT_TRANSLATE_NOOP("Words", "Mouse and keyboard"),
    QT_TRANSLATE_NOOP("Words", "Haptic pen (OpenHaptics)"),
    QT_TRANSLATE_NOOP("Words", "Gamepad"),
    QT_TRANSLATE_NOOP("Words", "SpaceMouse"),
    QT_TRANSLATE_NOOP("Words", "Haply Inverse3"),
    QT_TRANSLATE_NOOP("Words", "first contact"),
    QT_TRANSLATE_NOOP("Words", "dentin reached"),
    QT_TRANSLATE_NOOP("Words", "pulp exposed"),
    QT_TRANSLATE_NOOP("Words", "neighbour touched"),
    QT_TRANSLATE_NOOP("Words", "gum or bone touched"),
    QT_TRANSLATE_NOOP("Words", "cut beside the tooth"),
    QT_TRANSLATE_NOOP("Words", "bur stalled"),
    QT_TRANSLATE_NOOP("Words", "piece came loose"),
    QT_TRANSLATE_NOOP("Words", "outer"),
    QT_TRANSLATE_NOOP("Words", "sound starting"),
    QT_TRANSLATE_NOOP("Words", "sound on"),
    QT_TRANSLATE_NOOP("Words", "no sound card: silent"),
};

QString plain(std::string_view word) { return QString::fromUtf8(word.data(), static_cast<qsizetype>(word.size())); }

/// "Round carbide No. 4, 1.4 mm" of the catalogue by its parts: shape, number and width.
QString translatedBur(std::string_view name) {
    for (const auto& [between, pattern] :
         {std::pair{" carbide No. ", "%1 carbide No. %2, %3"}, std::pair{" diamond ", "%1 diamond %2, %3"}}) {
        const std::string_view material = between;
        const std::size_t at = name.find(material);
        const std::size_t comma = name.find(", ");
        if (at == std::string_view::npos || comma == std::string_view::npos || comma < at) continue;
        const std::string_view number = name.substr(at + material.size(), comma - at - material.size());
        return QCoreApplication::translate("Words", pattern)
            .arg(translated(name.substr(0, at)), plain(number), plain(name.substr(comma + 2)));
    }
    return plain(name);
}

}  // namespace

QString translated(std::string_view word) {
    const auto* const known =
        std::find_if(std::begin(kWords), std::end(kWords), [&](const char* each) { return each == word; });
    if (known != std::end(kWords)) return QCoreApplication::translate("Words", *known);
    if (const auto material = builtinMaterials().find(word)) return materialTitle(builtinMaterials()[*material]);
    return translatedBur(word);
}

QString inWindowLanguage(std::string_view english, std::string_view japanese) {
    const bool isJapanese = QCoreApplication::translate("Words", kLanguage) == "ja";
    const std::string_view text = isJapanese ? japanese : english;
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

QString materialTitle(const MaterialDefinition& material) {
    return inWindowLanguage(material.titleEn, material.titleJa);
}

QString materialLabel(const MaterialDefinition& material) {
    QString label = materialTitle(material);
    if (!label.isEmpty()) label[0] = label[0].toUpper();
    return label;
}

}  // namespace tactooth
