// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTextBrowser>

#include "app/gui/manual/manual_pages.h"

namespace tactooth {

/// Shows one page of the manual, with its pictures, and follows links to other pages and to headings.
class ManualBrowser final : public QTextBrowser {
    Q_OBJECT

public:
    /// `pages` outlives the browser.
    explicit ManualBrowser(const ManualPages& pages, QWidget* parent = nullptr);

    /// Opens a page by its name. `section`: its heading, from 1; 0: the begin.
    void open(const QString& page, int section = 0);
    /// The name of the page.
    [[nodiscard]] QString page() const;
    /// Marks these words on the page; empty: none.
    void mark(const QString& words);

    QVariant loadResource(int type, const QUrl& name) override;

signals:
    /// A page is shown.
    void opened(const QString& page);
    /// A link leads to a page that is not there; a sentence.
    void missed(const QString& sentence);

protected:
    void changeEvent(QEvent* event) override;

private:
    void follow(const QUrl& link);
    void finish(const QUrl& shown);
    void goTo(const QString& anchor);
    void drawTables();
    void showMarks();

    const ManualPages& pages_;
    QStringList marked_;
};

}  // namespace tactooth
