// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <span>
#include <vector>

#include "session/simulation/cut_events.h"

class QTableWidget;

namespace tactooth {

/// A table of the events at the tooth, each with time and place.
class EventPanel final : public QWidget {
    Q_OBJECT

public:
    explicit EventPanel(QWidget* parent = nullptr);

    /// `events`: all so far, in the order of time. Fewer than before means another tooth's.
    void show(std::span<const CutEvent> events);

signals:
    /// A sentence on an event that the student should notice at once.
    void notified(const QString& sentence);
    /// A line has come to the table.
    void added(const CutEvent& event);
    /// The user has chosen an event; `place` in the tooth frame, mm.
    void placeChosen(const Vec3& place);
    void exportRequested();

private:
    void addLine(const CutEvent& event);
    void mark(std::size_t line, bool isTakenBack);

    QTableWidget* lines_;
    QWidget* write_;
    std::vector<Vec3> places_;
    std::vector<bool> isTakenBack_;  // of each line
};

}  // namespace tactooth
