// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QListWidget>
#include <QPixmap>

namespace tactooth {

/// Cards with a picture, a title and a line below it, in rows, under headings. A click, Enter or a gamepad's button
/// takes one.
class CardList final : public QListWidget {
    Q_OBJECT

public:
    struct Card {
        QPixmap picture;   ///< three to two; null: `icon` in its place
        const char* icon;  ///< see lineIcon
        QString title;
        QString facts;  ///< a short line
        QString tip;
    };

    explicit CardList(const QString& name);

    void addHeading(const QString& text);
    /// Returns its number, which `taken` names.
    int addCard(const Card& card);
    [[nodiscard]] int cards() const { return cards_; }
    /// The item of a card, to find it in the list.
    [[nodiscard]] QListWidgetItem* itemOf(int card) const;
    /// Height that shows this many rows of cards without a heading, in pixels.
    [[nodiscard]] int heightOf(int rows) const;
    /// Width that shows this many cards beside each other, in pixels.
    [[nodiscard]] int widthOf(int columns) const;

signals:
    void taken(int card);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;

private:
    class Delegate;
    [[nodiscard]] QSize pictureSize() const;
    [[nodiscard]] QSize cardSize() const;
    void take(const QListWidgetItem* item);
    void widenHeadings();

    int cards_ = 0;
};

}  // namespace tactooth
