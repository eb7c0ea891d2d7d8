// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <optional>

#include "app/gui/keys/key_map.h"

class QLabel;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace tactooth {

/// Lists what keys do, and takes another key for a row by pressing it. A key that has another meaning is refused with a
/// sentence that names it.
class KeyEditor final : public QDialog {
    Q_OBJECT

public:
    KeyEditor(KeyMap map, QWidget* parent);

    [[nodiscard]] const KeyMap& map() const { return map_; }
    /// The next key is the new one of a row.
    [[nodiscard]] bool isListening() const { return listening_.has_value(); }

signals:
    void changed();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void addRows();
    void addButtons();
    void showKeys();
    [[nodiscard]] std::optional<KeyId> chosen() const;
    void listen();
    void stopListening();
    void take(const Keys& wanted);
    void resetChosen();
    void resetAll();

    KeyMap map_;
    QTreeWidget* list_;
    QLabel* line_;
    QPushButton* change_ = nullptr;
    QPushButton* reset_ = nullptr;
    std::optional<KeyId> listening_;  // the row whose key is to be pressed
};

}  // namespace tactooth
