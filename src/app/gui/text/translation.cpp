// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/text/translation.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>

#include "assessment/exercise.h"
#include "instruments/messages.h"

namespace tactooth {
namespace {

/// What bears its English name in files and in the settings.
constexpr std::array<const MessageText*, 9> kNames = {
    &msg::kLowerFirstMolar, &msg::kUpperCentralIncisor, &msg::kUpperCanine,
    &msg::kAirTurbine,      &msg::kElectricSpindle,     &msg::kLowSpeedSpindle,
    &msg::kExplorer,        &msg::kPeriodontalProbe,    &msg::kSpoonExcavator,
};

QString asText(std::string_view text) { return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size())); }

}  // namespace

Language windowLanguage() {
    //: The English name of the language of this catalogue.
    const QString language = QCoreApplication::translate("Language", "English");
    return language == "Japanese" ? Language::Japanese : Language::English;
}

QString translated(const Message& message) { return QString::fromStdString(message.in(windowLanguage())); }

QString translated(std::string_view name) {
    const auto* const known = std::ranges::find(kNames, name, &MessageText::english);
    if (known != kNames.end()) return asText((*known)->in(windowLanguage()));
    const auto exercise = std::ranges::find_if(exercises(), [&](const auto& one) { return one->name == name; });
    return exercise != exercises().end() ? exerciseTitle(**exercise) : asText(name);
}

QString exerciseTitle(const Exercise& exercise) { return asText(exercise.words(windowLanguage()).name); }

QString inWindowLanguage(std::string_view english, std::string_view japanese) {
    return asText(windowLanguage() == Language::Japanese ? japanese : english);
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
