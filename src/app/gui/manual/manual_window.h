// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include "app/gui/manual/manual_browser.h"

class QAction;
class QLabel;
class QLineEdit;
class QListWidget;
class QStackedWidget;
class QTreeWidget;
class QTreeWidgetItem;
class QVBoxLayout;

namespace tactooth {

/// The manual in a window of its own, beside the work: contents, search, and one page. Escape closes it.
class ManualWindow final : public QDialog {
    Q_OBJECT

public:
    /// `besides`: the window that it helps with; it gives screen and size, and is no parent, so that its dialogs do not
    /// lock the manual.
    ManualWindow(ManualPages pages, const QWidget& besides);

    /// Shows a page in front. `section`: its heading, from 1; 0: the begin.
    void open(const QString& page, int section = 0);
    [[nodiscard]] const ManualPages& pages() const { return pages_; }
    [[nodiscard]] ManualBrowser& browser() const { return *browser_; }

private:
    void addBar(QVBoxLayout& column);
    QWidget* makeSide();
    void fillContents();
    void goToContents(const QTreeWidgetItem& item);
    void showHits();
    void showPage(const QString& page);

    ManualPages pages_;
    ManualBrowser* browser_;
    QTreeWidget* contents_;
    QListWidget* hits_;
    QStackedWidget* side_;
    QLineEdit* wanted_;
    QLabel* line_;
};

}  // namespace tactooth
