// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QListWidget>
#include <QTimer>
#include <set>
#include <string>
#include <vector>

#include "app/gui/icons/bur_picture.h"
#include "app/gui/model/bur_list.h"

namespace tactooth {

/// Pictures of burs, by groups with a heading each. The pictures that are not drawn yet come one after the other while
/// the grid is in use already. A click or Enter takes a bur; Space, or a click on its star, makes it a favourite.
class BurGrid final : public QListWidget {
    Q_OBJECT

public:
    /// `exercise`: numbers of the burs of the exercise. `pictures` outlive the grid.
    BurGrid(const std::vector<BurItem>& burs, std::set<std::string> favourites, std::set<std::string> exercise,
            BurPictures& pictures);

    /// Shows those that match a search (see matches), or only the favourites among them.
    void filter(const QString& search, bool favouritesOnly);
    void select(int place);
    /// Takes the current bur; nothing if there is none, or it is not allowed.
    void takeCurrent();
    /// Null if no bur is current.
    [[nodiscard]] const BurItem* currentBur() const;
    [[nodiscard]] bool isFavourite(const BurItem& bur) const;
    void toggleFavourite();
    [[nodiscard]] int shownBurs() const;
    /// Those of them that the exercise allows.
    [[nodiscard]] int allowedBurs() const;
    [[nodiscard]] bool isDrawing() const { return drawing_.isActive(); }
    /// The star of the cell of an item, in the frame of the viewport.
    [[nodiscard]] QRect starOf(const QListWidgetItem& item) const;

signals:
    /// Its place in the list of the drill bar.
    void taken(int place);
    void favouritesChanged(const std::set<std::string>& favourites);
    /// Letters that belong into the search.
    void lettersTyped(const QString& letters);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    class Delegate;
    void add(const BurGroup& group);
    void describe(QListWidgetItem& item) const;
    void widenHeadings();
    void drawNext();
    [[nodiscard]] const BurItem* burOf(const QListWidgetItem* item) const;

    std::vector<BurItem> burs_;
    std::set<std::string> favourites_;
    std::set<std::string> exercise_;
    BurPictures& pictures_;
    QTimer drawing_;
};

}  // namespace tactooth
