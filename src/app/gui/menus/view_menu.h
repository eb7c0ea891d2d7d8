// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QStringList>

#include "app/gui/keys/key_table.h"
#include "app/gui/settings/window_settings.h"

class QAction;
class QActionGroup;
class QMenu;
class QToolBar;

namespace tactooth {

class ToothView;

/// The views of the tooth, the second view, and the switches of mirror and turbine, in a menu and a tool bar.
class ViewMenu final : public QObject {
    Q_OBJECT

public:
    /// Adds its actions to `menu` and `bar`; `view` outlives them.
    ViewMenu(QMenu& menu, QToolBar& bar, ToothView& view);

    void restore(const WindowSettings& settings);
    void store(WindowSettings& settings) const;

private:
    void addAction(const QString& text, KeyId key, const char* icon, void (ToothView::*act)());
    [[nodiscard]] QStringList addStandardViews();
    void addSecondViews(const QStringList& titles);
    QAction* addVisibility(const QString& text, KeyId key, const char* icon, void (ToothView::*show)(bool));
    void setSecondView(const QString& name);
    void addMirrorPlaces();

    QMenu& menu_;
    QToolBar& bar_;
    ToothView& view_;
    QActionGroup* secondViews_ = nullptr;
    QAction* mirror_;
    QAction* turbine_;
    QAction* aim_;
};

}  // namespace tactooth
