// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/menus/appearance_menu.h"

#include <QActionGroup>
#include <algorithm>
#include <utility>

#include "app/gui/icons/line_icon.h"
#include "app/gui/menus/menu_switch.h"
#include "app/gui/settings/window_setup.h"
#include "app/gui/text/language_names.h"

namespace tactooth {

AppearanceMenu::AppearanceMenu(QMenu& menu) : dark_(addSwitch(menu, tr("&Dark colours"), KeyId::Dark)) {
    setLineIcon(*dark_, "dark");
    connect(dark_, &QAction::toggled, this, [this](bool dark) {
        applyColours(dark);
        emit coloursChanged();
    });
    addTextSizes(menu);
    addLanguages(menu);
}

void AppearanceMenu::addTextSizes(QMenu& menu) {
    QMenu* sizes = menu.addMenu(tr("Te&xt size"));
    sizes->setObjectName("textSize");
    setLineIcon(*sizes->menuAction(), "text-size");
    textSizes_ = new QActionGroup(sizes);
    for (const int percent : {100, 125, 150, 200}) {
        QAction* action = sizes->addAction(tr("%1 %").arg(percent));
        action->setCheckable(true);
        action->setData(percent / 100.0);
        textSizes_->addAction(action);
    }
    textSizes_->actions().front()->setChecked(true);
    connect(textSizes_, &QActionGroup::triggered, this,
            [this](QAction* chosen) { setTextScale(chosen->data().toDouble()); });
}

void AppearanceMenu::setTextScale(double scale) {
    textScale_ = std::clamp(scale, kMinTextScale, kMaxTextScale);
    for (QAction* action : textSizes_->actions()) action->setChecked(action->data().toDouble() == textScale_);
    applyTextScale(textScale_);
    emit textScaleChanged();
}

void AppearanceMenu::addLanguages(QMenu& menu) {
    QMenu* names = menu.addMenu(tr("&Language"));
    names->setObjectName("language");
    setLineIcon(*names->menuAction(), "language");
    languages_ = new QActionGroup(names);
    for (const auto& [title, code] : languageNames()) {
        QAction* action = names->addAction(title);
        action->setCheckable(true);
        action->setData(code);
        languages_->addAction(action);
    }
    setLanguage({});
    connect(languages_, &QActionGroup::triggered, this,
            [this](QAction* chosen) { chooseLanguage(chosen->data().toString()); });
}

void AppearanceMenu::chooseLanguage(const QString& code) {
    if (code == language_) return;
    setLanguage(code);
    emit languageChosen();
}

void AppearanceMenu::setLanguage(const QString& code) {
    language_ = code;
    for (QAction* action : languages_->actions()) action->setChecked(action->data().toString() == code);
}

void AppearanceMenu::restore(const WindowSettings& settings) {
    dark_->setChecked(settings.dark);
    setLanguage(QString::fromStdString(settings.language));
    setTextScale(settings.textScale);
}

void AppearanceMenu::store(WindowSettings& settings) const {
    settings.dark = dark_->isChecked();
    settings.language = language_.toStdString();
    settings.textScale = textScale_;
}

}  // namespace tactooth
