// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

#include "session/model/work_history.h"

class QListWidget;

namespace tactooth {

/// What the user did with the tooth, one line a step. A click goes back or forward to that state.
class HistoryPanel final : public QWidget {
    Q_OBJECT

public:
    explicit HistoryPanel(QWidget* parent = nullptr);

    void show(const WorkHistory& history);

signals:
    /// The user wants so many steps to be done.
    void chosen(std::size_t position);

private:
    QListWidget* lines_;
    std::optional<std::uint64_t> shown_;  // revision
};

}  // namespace tactooth
