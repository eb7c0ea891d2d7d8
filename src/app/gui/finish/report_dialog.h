// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <memory>
#include <vector>

#include "app/gui/finish/finished_work.h"
#include "app/gui/finish/lost_points.h"

class QBoxLayout;
class QLabel;
class QPushButton;
class QTreeWidget;

namespace tactooth {

class ReportPagesView;

/// The report of a finished exercise: its pages, and beside them the mark, what it is made of, and what to do next.
/// Closing it (Escape) emits `rejected`.
class ReportDialog final : public QDialog {
    Q_OBJECT

public:
    ReportDialog(std::shared_ptr<const WorkAssessment> assessment, QWidget* parent);

    /// Shows that it was handed in.
    void showHandedIn(const QString& folder);
    /// The criterion that is selected; null: none.
    [[nodiscard]] const LostPoint* selected() const;

signals:
    void againWanted();
    /// `from`: where the replay of the recording begins, s.
    void replayWanted(double from);
    void handInWanted();
    /// The student wants to go on with the work.
    void continueWanted();

private:
    [[nodiscard]] QWidget* makePages();
    [[nodiscard]] QWidget* makeSummary();
    [[nodiscard]] QWidget* makeMark();
    [[nodiscard]] QTreeWidget* makeList();
    [[nodiscard]] QLayout* makeButtons();
    QPushButton* addButton(QBoxLayout& row, const QString& text, const char* name, const char* icon, const QString& tip,
                           void (ReportDialog::*act)());
    void followSelection();
    void replaySelected();

    std::shared_ptr<const WorkAssessment> assessment_;
    std::vector<LostPoint> points_;
    ReportPagesView* pages_ = nullptr;
    QTreeWidget* list_ = nullptr;
    QPushButton* replay_ = nullptr;
    QLabel* handedIn_ = nullptr;
};

}  // namespace tactooth
