// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStyleOptionViewItem>

class QPainter;

namespace tactooth {

/// Lists of pictures, of burs and of exercises, look alike: headings in bold, and cells that light up.
inline constexpr int kCellPad = 5;      ///< pixels inside a cell
inline constexpr int kCellSpacing = 4;  ///< pixels between cells

/// A heading in bold letters, at the bottom of its row.
void paintHeading(QPainter& painter, const QStyleOptionViewItem& option, const QString& text);
/// The ground of a cell: stronger, and with a border, where it is current, than where it is under the mouse.
void paintCellGround(QPainter& painter, const QStyleOptionViewItem& option, bool isCurrent);
[[nodiscard]] bool isUnderMouse(const QStyleOptionViewItem& option);

}  // namespace tactooth
