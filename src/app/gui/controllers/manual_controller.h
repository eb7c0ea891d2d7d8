// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>

class QWidget;

namespace tactooth {

class KeyController;
class ManualWindow;

/// Opens the manual, at the place that fits what has the focus. In a dialog, where the menus get no keys, it listens to
/// the key of the help itself.
class ManualController final : public QObject {
    Q_OBJECT

public:
    /// Both outlive the controller.
    ManualController(QWidget& window, const KeyController& keys);
    ~ManualController() override;

    /// Opens the place that explains the focus.
    void openForFocus();
    /// Null before it is opened for the first time.
    [[nodiscard]] ManualWindow* manual() const { return manual_.get(); }
    void close();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void returnKeyboard();

    QWidget& window_;
    const KeyController& keys_;
    std::unique_ptr<ManualWindow> manual_;
};

}  // namespace tactooth
