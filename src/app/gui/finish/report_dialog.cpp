// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/finish/report_dialog.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QShortcut>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "app/common/report/report_pages.h"
#include "app/gui/finish/report_pages_view.h"
#include "app/gui/icons/line_icon.h"
#include "app/gui/text/translation.h"
#include "assessment/report/next_steps.h"
#include "geometry/util/display_text.h"

namespace tactooth {
namespace {

constexpr auto kGood = "#2f9e44", kBad = "#d04030";  // legible on light and on dark ground

QString shown(const std::string& text) { return QString::fromStdString(displayText(text)); }

/// "−12.3", and that it limits the mark.
QString lostText(const LostPoint& point, const QLocale& locale) {
    const double lost = point.score->lost;
    const QString points = lost > 0 ? QStringLiteral("−") + locale.toString(lost, 'f', 1) : QStringLiteral("–");
    return point.limitsMark ? ReportDialog::tr("limit, %1").arg(points) : points;
}

QString valueText(const LostPoint& point, Language language) {
    const Measured& measured = point.score->measured;
    if (!measured.value) return ReportDialog::tr("not measurable");
    return shown(tactooth::valueText(*point.score->criterion->metric, *measured.value, language));
}

/// All that is known of a criterion, for the tool tip.
QString factsOf(const AssessmentReport& report, const LostPoint& point) {
    const Language language = report.language;
    const CriterionScore& score = *point.score;
    QStringList lines{shown(score.criterion->titleIn(language))};
    if (score.score) lines << ReportDialog::tr("Score %1 of 100").arg(*score.score, 0, 'f', 0);
    if (score.level) lines << translated(Message(levelText(*score.level)));
    if (!score.measured.value && score.measured.reason != nullptr) {
        lines << translated(Message(*score.measured.reason));
    }
    if (point.limitsMark) lines << ReportDialog::tr("The mark is no better because of this.");
    if (const std::string cause = causeText(report, score, language); !cause.empty()) lines << shown(cause);
    return lines.join('\n');
}

QLabel* heading(const QString& text) {
    auto* label = new QLabel(text);
    QFont font = label->font();
    font.setBold(true);
    label->setFont(font);
    return label;
}

}  // namespace

ReportDialog::ReportDialog(std::shared_ptr<const WorkAssessment> assessment, QWidget* parent)
    : QDialog(parent), assessment_(std::move(assessment)), points_(lostPoints(assessment_->report.mark)) {
    setObjectName("report");
    setWindowTitle(tr("Report: %1").arg(exerciseTitle(*assessment_->work.exercise)));
    auto* both = new QHBoxLayout;
    constexpr int kPages = 5, kSummary = 4;  // shares of the width
    both->addWidget(makePages(), kPages);
    both->addWidget(makeSummary(), kSummary);
    auto* column = new QVBoxLayout(this);
    column->addLayout(both, 1);
    column->addLayout(makeButtons());
    constexpr double kShare = 0.96;  // of the window
    resize(kShare * parent->window()->size());
    followSelection();
    list_->setFocus();
}

QWidget* ReportDialog::makePages() {
    pages_ =
        new ReportPagesView([assessment = assessment_](int width) { return reportPages(assessment->report, width); });
    auto* all = new QWidget;
    auto* column = new QVBoxLayout(all);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(pages_, 1);
    auto* row = new QHBoxLayout;
    const auto add = [&](const QString& text, const QString& tip, const QKeySequence& key, const auto& act) {
        auto* button = new QToolButton;
        button->setText(text);
        button->setToolTip(QString("%1 (%2)").arg(tip, key.toString(QKeySequence::NativeText)));
        button->setAccessibleName(tip);
        row->addWidget(button);
        connect(button, &QToolButton::clicked, pages_, act);
        connect(new QShortcut(key, this), &QShortcut::activated, pages_, act);
    };
    add("−", tr("Smaller pages"), QKeySequence::ZoomOut, &ReportPagesView::zoomOut);
    add("+", tr("Larger pages"), QKeySequence::ZoomIn, &ReportPagesView::zoomIn);
    add(tr("Fit width"), tr("Pages as wide as the view"), QKeySequence("Ctrl+0"), &ReportPagesView::fitWidth);
    row->addStretch();
    column->addLayout(row);
    return all;
}

QWidget* ReportDialog::makeMark() {
    const Mark& mark = assessment_->report.mark;
    auto* box = new QWidget;
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    auto* number = new QLabel(mark.value ? locale().toString(*mark.value, 'f', 1) : QStringLiteral("–"));
    number->setObjectName("mark");
    number->setAccessibleName(tr("Mark of 100"));
    QFont large = number->font();
    constexpr double kLarge = 2.8;
    large.setPointSizeF(kLarge * large.pointSizeF());
    large.setBold(true);
    number->setFont(large);
    number->setStyleSheet(QString("color: %1").arg(mark.passes ? kGood : kBad));
    auto* result = new QLabel;
    result->setObjectName("result");
    result->setTextFormat(Qt::RichText);
    const QString word = mark.passes ? tr("Passed") : tr("Not passed");
    const QString rest = tr("of 100; pass mark %1").arg(assessment_->rubric.passMark, 0, 'f', 0);
    result->setText(QString("<b style=\"color:%1\">%2</b><br>%3")
                        .arg(mark.passes ? kGood : kBad, word.toHtmlEscaped(), rest.toHtmlEscaped()));
    row->addWidget(number);
    row->addSpacing(12);
    row->addWidget(result, 1);
    return box;
}

QTreeWidget* ReportDialog::makeList() {
    auto* list = new QTreeWidget;
    list->setObjectName("lostPoints");
    list->setAccessibleName(tr("What the mark is made of"));
    list->setRootIsDecorated(false);
    list->setAlternatingRowColors(true);
    list->setHeaderLabels({tr("Points"), tr("Criterion"), tr("Measured"), tr("Where, when")});
    const Language language = assessment_->report.language;
    constexpr double kTall = 1.6;  // lines of text: a row is easy to hit
    const int row = static_cast<int>(kTall * list->fontMetrics().height());
    for (const LostPoint& point : points_) {
        auto* item = new QTreeWidgetItem(list);
        item->setText(0, lostText(point, locale()));
        item->setText(1, shown(point.score->criterion->titleIn(language)));
        item->setText(2, valueText(point, language));
        item->setText(3, shown(placeAndMomentText(assessment_->report, point.score->measured)));
        item->setSizeHint(1, {0, row});
        for (const int column : {0, 2}) item->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
        const QString facts = factsOf(assessment_->report, point);
        for (int column = 0; column < list->columnCount(); ++column) item->setToolTip(column, facts);
        const bool costs = point.limitsMark || point.score->lost > 0;
        if (costs) item->setForeground(0, QColor(kBad));
    }
    list->header()->setStretchLastSection(false);
    for (const int column : {0, 2}) list->header()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
    list->header()->setSectionResizeMode(1, QHeaderView::Stretch);
    list->header()->setSectionResizeMode(3, QHeaderView::ResizeToContents);
    if (list->topLevelItemCount() > 0) list->setCurrentItem(list->topLevelItem(0));
    constexpr int kFewRows = 4;  // they are always in sight, and no row is cut off
    const int frame = 2 * list->frameWidth() + list->header()->sizeHint().height();
    list->setMinimumHeight(frame + kFewRows * row);
    list->setMaximumHeight(frame + (list->topLevelItemCount() + 1) * row);
    connect(list, &QTreeWidget::currentItemChanged, this, &ReportDialog::followSelection);
    connect(list, &QTreeWidget::itemActivated, this, &ReportDialog::replaySelected);
    return list;
}

QWidget* ReportDialog::makeSummary() {
    auto* summary = new QWidget;
    auto* column = new QVBoxLayout(summary);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(makeMark());
    column->addWidget(heading(tr("What the mark is made of")));
    list_ = makeList();
    column->addWidget(list_, 1);
    column->addSpacing(6);
    column->addWidget(heading(tr("What to do next")));
    for (const std::string& step : nextSteps(assessment_->report)) {
        auto* label = new QLabel(shown(step));
        label->setWordWrap(true);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
        column->addWidget(label);
    }
    column->addStretch();
    return summary;
}

QPushButton* ReportDialog::addButton(QBoxLayout& row, const QString& text, const char* name, const char* icon,
                                     const QString& tip, void (ReportDialog::*act)()) {
    auto* button = new QPushButton(lineIcon(icon), text);
    button->setObjectName(name);
    button->setToolTip(tip);
    button->setAutoDefault(false);  // Enter in the list replays
    connect(button, &QPushButton::clicked, this, act);
    row.addWidget(button);
    return button;
}

QLayout* ReportDialog::makeButtons() {
    auto* row = new QHBoxLayout;
    addButton(*row, tr("&Again"), "reportAgain", "reset", tr("The same exercise from the start"),
              &ReportDialog::againWanted);
    replay_ = addButton(*row, tr("&Replay the error"), "reportReplay", "recording", {}, &ReportDialog::replaySelected);
    addButton(*row, tr("&Hand in…"), "reportHandIn", "export",
              tr("Writes the report, the tooth and the recording into a folder; nothing is sent"),
              &ReportDialog::handInWanted);
    handedIn_ = new QLabel;
    handedIn_->setObjectName("handedIn");
    handedIn_->setWordWrap(true);
    handedIn_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    row->addWidget(handedIn_, 1);
    addButton(*row, tr("&Continue"), "reportContinue", "forward", tr("Goes on with the work, and so does the time"),
              &ReportDialog::continueWanted);
    addButton(*row, tr("C&lose"), "reportClose", "tooth",
              tr("Leads back to the tooth; the time stands still until you choose Continue"), &QDialog::reject);
    return row;
}

const LostPoint* ReportDialog::selected() const {
    const int row = list_->indexOfTopLevelItem(list_->currentItem());
    return row < 0 ? nullptr : &points_[static_cast<std::size_t>(row)];
}

void ReportDialog::followSelection() {
    const LostPoint* const point = selected();
    const ErrorReplay can = point != nullptr ? errorReplay(*point, assessment_->canReplay) : ErrorReplay::NoMoment;
    replay_->setEnabled(can == ErrorReplay::Possible);
    switch (can) {
        case ErrorReplay::Possible:
            return replay_->setToolTip(tr("Shows the recording of this work, from shortly before the error on"));
        case ErrorReplay::NoRecording:
            return replay_->setToolTip(tr("There is no recording of this work: see Recordings in the menu File"));
        case ErrorReplay::NoMoment:
            return replay_->setToolTip(tr("This criterion has no single moment: choose one with a time"));
    }
}

void ReportDialog::replaySelected() {
    if (replay_->isEnabled()) emit replayWanted(replayStart(*selected()->score->measured.moment));
}

void ReportDialog::showHandedIn(const QString& folder) { handedIn_->setText(tr("Handed in: %1").arg(folder)); }

}  // namespace tactooth
