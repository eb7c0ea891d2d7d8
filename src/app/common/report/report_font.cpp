// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/report/report_font.h"

#include <QFontDatabase>
#include <QStringList>

#include "app/common/offscreen_application.h"
#include "app/common/report/messages.h"

namespace tactooth {

Expected<QString> reportFont(Language language) {
    if (language == Language::English) return QStringLiteral("Noto Sans");  // or what stands in for it
    const OffscreenApplication application;
    const QStringList families = QFontDatabase::families(QFontDatabase::Japanese);
    if (families.isEmpty()) return unexpected(msg::kNoJapaneseFont);
    for (const char* wanted :
         {"Noto Sans CJK JP", "Noto Sans JP", "Hiragino Sans", "Yu Gothic", "IPAexGothic", "IPAPGothic", "IPAGothic"}) {
        if (families.contains(QLatin1String(wanted))) return QString(QLatin1String(wanted));
    }
    return families.first();
}

}  // namespace tactooth
