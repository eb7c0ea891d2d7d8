// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/text/language_names.h"

#include <QCoreApplication>

namespace tactooth {

std::vector<LanguageName> languageNames() {
    return {{QCoreApplication::translate("tactooth::AppearanceMenu", "As the system"), ""},
            {QStringLiteral("English"), "en"},
            {QStringLiteral("\u65e5\u672c\u8a9e"), "ja"}};
}

}  // namespace tactooth
