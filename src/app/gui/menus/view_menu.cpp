// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/menus/view_menu.h"

#include <QActionGroup>
#include <QToolBar>
#include <algorithm>
#include <array>

#include "app/common/inspection.h"
#include "app/gui/icons/line_icon.h"
#include "app/gui/menus/menu_switch.h"
#include "app/gui/scene/tooth_view.h"

namespace tactooth {

namespace {

/// Its drawing has the name of the view.
const char* iconOf(StandardView view) { return kStandardViews[static_cast<std::size_t>(view)].first.data(); }

/// The row `place` rows after `first`: the views stand in the table of keys in their order.
KeyId nth(KeyId first, int place) { return static_cast<KeyId>(static_cast<int>(first) + place); }

}  // namespace

ViewMenu::ViewMenu(QMenu& menu, QToolBar& bar, ToothView& view) : menu_(menu), bar_(bar), view_(view) {
    addAction(tr("Dentist's view"), KeyId::DentistView, "dentist", &ToothView::takeDentistView);
    const QStringList titles = addStandardViews();
    addAction(tr("Fit"), KeyId::Fit, "fit", &ToothView::fit);
    addSecondViews(titles);
    menu_.addSeparator();
    bar_.addSeparator();
    mirror_ = addVisibility(tr("Mirror"), KeyId::Mirror, "mirror", &ToothView::setShowsMirror);
    addMirrorPlaces();
    turbine_ = addVisibility(tr("Turbine"), KeyId::Turbine, "handpiece", &ToothView::setShowsTurbine);
    aim_ = addVisibility(tr("Aim"), KeyId::Aim, "aim", &ToothView::setShowsAim);
    aim_->setToolTip(
        tr("Shows where the bur will land, and at its tip the depth, the tooth left over the pulp, and the "
           "force"));
}

void ViewMenu::addMirrorPlaces() {
    connect(&view_, &ToothView::mirrorUsed, mirror_, [this] { mirror_->setChecked(true); });
    QAction* place = menu_.addAction(tr("&Place the mirror"), &view_, &ToothView::placeMirror);
    place->setObjectName("placeMirror");
    bindKey(*place, KeyId::PlaceMirror);
    place->setToolTip(tr("Holds the mirror where it shows the bur from behind"));
    place->setStatusTip(place->toolTip());
    setLineIcon(*place, "mirror");
    QAction* park = menu_.addAction(tr("Put the mirror &back"), &view_, &ToothView::parkMirror);
    park->setObjectName("parkMirror");
    bindKey(*park, KeyId::ParkMirror);
    park->setStatusTip(tr("The mirror waits again behind the tooth"));
    setLineIcon(*park, "reset");
}

void ViewMenu::addAction(const QString& text, KeyId key, const char* icon, void (ToothView::*act)()) {
    QAction* action = menu_.addAction(text, &view_, act);
    setLineIcon(*action, icon);
    bindKey(*action, key);
    bar_.addAction(action);
}

/// Returns the titles of the standard views in their order.
QStringList ViewMenu::addStandardViews() {
    const std::array<std::pair<QString, StandardView>, 5> views = {{{tr("Occlusal"), StandardView::Occlusal},
                                                                    {tr("Buccal"), StandardView::Buccal},
                                                                    {tr("Lingual"), StandardView::Lingual},
                                                                    {tr("Mesial"), StandardView::Mesial},
                                                                    {tr("Distal"), StandardView::Distal}}};
    int place = 0;
    QStringList titles;
    for (const auto& [name, view] : views) {
        titles.append(name);
        QAction* action = menu_.addAction(name, this, [this, view = view] { view_.setView(view); });
        setLineIcon(*action, iconOf(view));
        bindKey(*action, nth(KeyId::Occlusal, place++));
        bar_.addAction(action);
    }
    return titles;
}

void ViewMenu::addSecondViews(const QStringList& titles) {
    QMenu* menu = menu_.addMenu(tr("&Second view"));
    menu->setObjectName("secondView");
    setLineIcon(*menu->menuAction(), "second-view");
    secondViews_ = new QActionGroup(menu);
    const auto add = [&](const QString& title, int place, std::string_view name) {
        QAction* action = addSwitch(*menu, title, nth(KeyId::SecondNone, place));
        action->setData(QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size())));
        setLineIcon(*action, name.data());
        secondViews_->addAction(action);
        return action;
    };
    add(tr("None"), 0, "none")->setChecked(true);
    for (int i = 0; i < titles.size(); ++i) add(titles[i], i + 1, kStandardViews[static_cast<std::size_t>(i)].first);
    connect(secondViews_, &QActionGroup::triggered, this,
            [this](QAction* chosen) { setSecondView(chosen->data().toString()); });
}

QAction* ViewMenu::addVisibility(const QString& text, KeyId key, const char* icon, void (ToothView::*show)(bool)) {
    QAction* action = addSwitch(menu_, text, key);
    setLineIcon(*action, icon);
    action->setChecked(true);
    connect(action, &QAction::toggled, &view_, show);
    bar_.addAction(action);
    return action;
}

/// An unknown name means no second view.
void ViewMenu::setSecondView(const QString& name) {
    const QList<QAction*> actions = secondViews_->actions();
    const auto found = std::find_if(actions.begin() + 1, actions.end(), [&](QAction* a) { return a->data() == name; });
    const auto place = found == actions.end() ? 0 : found - actions.begin();
    actions[place]->setChecked(true);
    if (place == 0) return view_.setSecondView({});
    view_.setSecondView(kStandardViews[static_cast<std::size_t>(place - 1)].second, actions[place]->text());
}

void ViewMenu::restore(const WindowSettings& settings) {
    mirror_->setChecked(settings.showsMirror);
    turbine_->setChecked(settings.showsTurbine);
    aim_->setChecked(settings.showsAim);
    setSecondView(QString::fromStdString(settings.secondView));
}

void ViewMenu::store(WindowSettings& settings) const {
    settings.showsMirror = mirror_->isChecked();
    settings.showsTurbine = turbine_->isChecked();
    settings.showsAim = aim_->isChecked();
    settings.secondView = secondViews_->checkedAction()->data().toString().toStdString();
}

}  // namespace tactooth
