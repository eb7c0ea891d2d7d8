// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/images/contact_sheet.h"

#include <QPainter>

#include "app/common/images/image_view.h"
#include "app/common/offscreen_application.h"

namespace tactooth {
namespace {

constexpr int kWordHeight = 18;  // pixels below each picture

}  // namespace

ContactSheet::ContactSheet(int columns, int rows, ImageSize tile)
    : tile_(tile), sheet_(columns * tile.width, rows * (tile.height + kWordHeight), QImage::Format_RGB32) {
    sheet_.fill(QColor(52, 60, 70));
}

void ContactSheet::place(int column, int row, const Image& picture, const std::string& word) {
    const QImage tile = viewOf(picture);
    const int x = column * tile_.width, y = row * (tile_.height + kWordHeight);
    QPainter painter(&sheet_);
    painter.drawImage(x, y, tile);
    painter.setPen(QColor(225, 228, 232));
    painter.setFont(QFont("DejaVu Sans", 9));
    painter.drawText(QRect(x, y + tile_.height, tile_.width, kWordHeight), Qt::AlignCenter,
                     QString::fromStdString(word));
}

Expected<void> ContactSheet::save(const std::filesystem::path& png) const { return savePng(sheet_, png); }

}  // namespace tactooth
