// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

class QWidget;

namespace tactooth {

/// A place in the manual.
struct ManualPlace {
    QString page;
    int section = 0;  ///< its heading, from 1; 0: the begin of the page

    bool operator==(const ManualPlace&) const = default;
};

/// What the manual says about the widget that has the focus, or about the panel or dialog around it. Without such a
/// place, and for null: the first page.
[[nodiscard]] ManualPlace manualPlaceFor(const QWidget* focus);

/// All places to which that leads.
[[nodiscard]] std::vector<ManualPlace> manualPlaces();

}  // namespace tactooth
