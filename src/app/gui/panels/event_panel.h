// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <span>
#include <vector>

#include "session/simulation/cut_events.h"

class QTableWidget;

namespace tactooth {

/// What has happened to the tooth, with time and place: a line each.
class EventPanel final : public QWidget {
    Q_OBJECT

public:
    explicit EventPanel(QWidget* parent = nullptr);

    /// All of them, those shown before first; fewer than before: another tooth's.
    void show(std::span<const CutEvent> events);

signals:
    /// Something that a student should hear of at once: a sentence.
    void notified(const QString& sentence);
    /// A line was chosen: its place in the tooth, mm.
    void placeChosen(const Vec3& place);
    void exportRequested();

private:
    void addLine(const CutEvent& event);

    QTableWidget* lines_;
    QWidget* write_;
    std::vector<Vec3> places_;
};

}  // namespace tactooth
