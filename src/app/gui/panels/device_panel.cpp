// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/panels/device_panel.h"

#include <QGridLayout>
#include <QSignalBlocker>

#include "app/gui/icons/line_icon.h"
#include "app/gui/keys/key_binding.h"
#include "app/gui/text/translation.h"
#include "devices/open_device.h"

namespace tactooth {
namespace {

constexpr int kMaxButtons = 8;      // no device has more buttons within reach of the fingers
constexpr int kDeviceLetters = 17;  // that fit into the lists of devices
constexpr std::array<double, 4> kRates = {kMinRate, 1000, 2000, kMaxRate};  // Hz

/// The title of a device among several of its kind ("pen:Left") in the lists.
/// Of "pen:NAME" and the like: the kind's title and the name.
QString titleOf(const QString& name) {
    const qsizetype colon = name.indexOf(':');
    const DeviceBackend* const kind = colon < 0 ? nullptr : findDeviceBackend(name.left(colon).toStdString());
    if (kind == nullptr || kind->unitTitle == nullptr) return name;
    return translated(Message(*kind->unitTitle, name.mid(colon + 1).toStdString()));
}

}  // namespace

Qt::Key pedalKeyOf(const DeviceSettings& settings) {
    const QKeySequence keys(QString::fromStdString(settings.pedalKey), QKeySequence::PortableText);
    const Qt::Key key = keys.isEmpty() ? Qt::Key_unknown : keys[0].key();
    return key == Qt::Key_unknown ? Qt::Key_Space : key;
}

QString forceStateText(ForceState state) {
    switch (state) {
        case ForceState::On:
            return DevicePanel::tr("The force is on.");
        case ForceState::Off:
            return DevicePanel::tr("The force is off.");
        case ForceState::AwaitsFreeSpace:
            return DevicePanel::tr("The force waits until the bur is free: lift it off the tooth.");
        case ForceState::Warm:
            return DevicePanel::tr("The motors are warm: the force is weaker.");
        case ForceState::Fault:
            return DevicePanel::tr("No force: the device is not there or its reading is wrong.");
    }
    return {};
}

DevicePanel::DevicePanel(QWidget* parent)
    : QWidget(parent),
      devices_(new QComboBox),
      seconds_(new QComboBox),
      state_(new QLabel),
      secondDeviceState_(new QLabel),
      fit_(new QCheckBox(tr("Fit to the tooth"))),
      fitNote_(new QLabel),
      rate_(new QComboBox),
      clutch_(new QPushButton(tr("Hold the bur"))),
      clutchAction_(new QAction(tr("Hold the bur"), this)),
      leftHanded_(new QCheckBox(tr("Left-handed"))),
      pedal_(new QLabel),
      calibrate_(new QPushButton(tr("Teach…"))),
      key_(new QKeySequenceEdit(QKeySequence(Qt::Key_Space))) {
    auto* grid = new QGridLayout(this);
    addDevices(*grid);
    addHold(*grid);
    addMotionScaling(*grid);
    addRate(*grid);
    addButtons(*grid);
    addPedal(*grid);
    grid->setRowStretch(grid->rowCount(), 1);
    connect(motionScaling_, &NumberRow::changed, this, &DevicePanel::changed);
    connect(fit_, &QCheckBox::toggled, this, [this](bool fits) {
        motionScaling_->setEnabled(!fits);
        emit changed();
    });
    connect(rate_, &QComboBox::currentIndexChanged, this, &DevicePanel::changed);
    connect(clutch_, &QPushButton::toggled, this, &DevicePanel::changed);
    connect(leftHanded_, &QCheckBox::toggled, this, &DevicePanel::changed);
    connect(key_, &QKeySequenceEdit::editingFinished, this, &DevicePanel::changed);
    connect(calibrate_, &QPushButton::toggled, this, &DevicePanel::calibratingChanged);
    connect(devices_, &QComboBox::activated, this,
            [this](int index) { emit deviceChosen(devices_->itemData(index).toString()); });
    connect(seconds_, &QComboBox::activated, this,
            [this](int index) { emit secondDeviceChosen(seconds_->itemData(index).toString()); });
    set({});
}

void DevicePanel::addDevices(QGridLayout& grid) {
    seconds_->addItem(tr("empty"), QString("none"));
    for (const DeviceBackend& kind : deviceBackends()) {
        devices_->addItem(translated(kind.title), QString(kind.name));
        if (&kind != &deviceBackends().front()) seconds_->addItem(translated(kind.title), QString(kind.name));
        if (kind.units != nullptr) addUnits(kind);
    }
    for (QComboBox* box : {devices_, seconds_}) {  // the user's names must not widen the panel
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(kDeviceLetters);
    }
    seconds_->setObjectName("secondDevices");
    seconds_->setToolTip(tr("A second device, which begins with the mirror; a button exchanges what the hands hold"));
    devices_->setObjectName("devices");
    devices_->setToolTip(tr("What moves the bur. Plug it in before you choose it."));
    state_->setObjectName("deviceState");
    state_->setWordWrap(true);
    state_->setMinimumHeight(
        2 * state_->fontMetrics().lineSpacing());  // the panel keeps its height when the sentence changes
    grid.addWidget(new QLabel(tr("Device")), 0, 0);
    grid.addWidget(devices_, 0, 1, 1, 2);
    grid.addWidget(state_, 1, 0, 1, 3);
    grid.addWidget(new QLabel(tr("Other hand")), 2, 0);
    grid.addWidget(seconds_, 2, 1, 1, 2);
    secondDeviceState_->setObjectName("secondDeviceState");
    secondDeviceState_->setWordWrap(true);
    secondDeviceState_->hide();  // most users have one device
    grid.addWidget(secondDeviceState_, 3, 0, 1, 3);
}

/// Adds the pens that the vendor's setup program knows now. The user can still name another one.
void DevicePanel::addUnits(const DeviceBackend& kind) {
    for (const std::string& unit : kind.units()) {
        const QString name = QString::fromStdString(std::string(kind.name) + ':' + unit);
        for (QComboBox* box : {devices_, seconds_}) box->addItem(titleOf(name), name);
    }
}

void DevicePanel::addHold(QGridLayout& grid) {
    clutch_->setCheckable(true);
    clutch_->setObjectName("clutch");
    clutchAction_->setCheckable(true);
    setLineIcon(*clutchAction_, "hold");
    bindKey(*clutchAction_, KeyId::Hold);
    connect(clutchAction_, &QAction::toggled, clutch_, &QPushButton::setChecked);
    connect(clutch_, &QPushButton::toggled, clutchAction_, &QAction::setChecked);
    clutch_->setToolTip(
        tr("The bur stays while the hand goes back to a comfortable place; a key or a button of the "
           "device does the same"));
    leftHanded_->setObjectName("leftHanded");
    leftHanded_->setToolTip(tr("Handles point to the other side, and the two sides of a gamepad are swapped"));
    const int row = grid.rowCount();
    grid.addWidget(clutch_, row, 1);
    grid.addWidget(leftHanded_, row, 2);
}

void DevicePanel::addMotionScaling(QGridLayout& grid) {
    motionScaling_ = new NumberRow(grid, tr("Motion scaling"),
                                   {kMinMotionScaling, kMaxMotionScaling, 0.1, 1, tr(" : 1")}, kMinMotionScaling,
                                   tr("How far the device moves for each millimetre of the bur: 3 : 1 for fine work"));
    fit_->setObjectName("fitMotionScaling");
    fit_->setToolTip(tr("As fine as possible while the device still reaches all of the tooth"));
    fitNote_->setObjectName("fitNote");
    fitNote_->setWordWrap(true);
    fitNote_->hide();  // few devices need the note
    const int row = grid.rowCount();
    grid.addWidget(fit_, row, 1, 1, 2);
    grid.addWidget(fitNote_, row + 1, 0, 1, 3);
}

void DevicePanel::showFit(const std::optional<WorkspaceFit>& fit) {
    fitNote_->setVisible(fit_->isChecked() && !(fit && fit->coversBox));
    if (!fit_->isChecked()) return;
    const QSignalBlocker quiet(motionScaling_);
    motionScaling_->setValue(fit ? fit->motionScaling : kMinMotionScaling);
    fitNote_->setText(fit ? tr("The tooth is larger than the device's workspace: hold the bur (%1) to reach all of it.")
                                .arg(keyOf(*clutchAction_))
                          : tr("No device here has a known workspace: 1 : 1."));
}

void DevicePanel::addRate(QGridLayout& grid) {
    rate_->setObjectName("rate");
    rate_->setToolTip(
        tr("How often the force is computed: 500 Hz for a slow machine, where walls feel half as stiff; more than "
           "1000 Hz for a smoother force, if the device's driver allows it"));
    for (const double rate : kRates) rate_->addItem(tr("%1 Hz").arg(rate), rate);
    const int row = grid.rowCount();
    grid.addWidget(new QLabel(tr("Rate")), row, 0);
    grid.addWidget(rate_, row, 1, 1, 2);
}

void DevicePanel::addButtons(QGridLayout& grid) {
    const std::array<std::pair<QString, const char*>, 3> rows = {
        {{tr("Turbine or mirror"), "swapButton"}, {tr("Touch or cut"), "cutButton"}, {tr("Hold"), "clutchButton"}}};
    for (std::size_t i = 0; i < rows.size(); ++i) {
        QComboBox* box = buttons_[i] = new QComboBox;
        box->setObjectName(rows[i].second);
        box->addItem(tr("no button"));
        for (int number = 1; number <= kMaxButtons; ++number) box->addItem(tr("button %1").arg(number));
        const int row = grid.rowCount();
        grid.addWidget(new QLabel(rows[i].first), row, 0);
        grid.addWidget(box, row, 1, 1, 2);
        connect(box, &QComboBox::currentIndexChanged, this, &DevicePanel::changed);
    }
}

void DevicePanel::addPedal(QGridLayout& grid) {
    pedal_->setObjectName("pedalSource");
    pedal_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    calibrate_->setCheckable(true);
    calibrate_->setObjectName("teachPedal");
    calibrate_->setToolTip(tr("Any axis or button of a joystick can be the pedal: press it fully and let it go"));
    key_->setObjectName("pedalKey");
    key_->setToolTip(tr("The key that is the pedal as long as it is held"));
    const int row = grid.rowCount();
    grid.addWidget(new QLabel(tr("Foot pedal")), row, 0);
    grid.addWidget(pedal_, row, 1);
    grid.addWidget(calibrate_, row, 2);
    grid.addWidget(new QLabel(tr("Pedal key")), row + 1, 0);
    grid.addWidget(key_, row + 1, 1, 1, 2);
}

DeviceSettings DevicePanel::settings() const {
    const auto button = [this](std::size_t which) { return static_cast<double>(buttons_[which]->currentIndex()); };
    const QKeySequence keys = key_->keySequence();
    const QKeySequence first = keys.isEmpty() ? QKeySequence(Qt::Key_Space) : QKeySequence(keys[0]);
    return {.device = devices_->currentData().toString().toStdString(),
            .secondDevice = seconds_->currentData().toString().toStdString(),
            .motionScaling = fit_->isChecked() ? kAutoScaling : motionScaling_->value(),
            .rate = rate_->currentData().toDouble(),
            .leftHanded = leftHanded_->isChecked(),
            .swapButton = button(0),
            .cutButton = button(1),
            .clutchButton = button(2),
            .pedal = pedalText_,
            .pedalUp = pedalUp_,
            .pedalDown = pedalDown_,
            .pedalKey = first.toString(QKeySequence::PortableText).toStdString()};
}

void DevicePanel::set(const DeviceSettings& settings) {
    {
        const QSignalBlocker quiet(this);  // one `changed` for all controls
        showDevice(QString::fromStdString(settings.device));
        showSecondDevice(QString::fromStdString(settings.secondDevice));
        fit_->setChecked(settings.motionScaling == kAutoScaling);
        if (settings.motionScaling != kAutoScaling) motionScaling_->setValue(settings.motionScaling);
        showRate(settings.rate);
        leftHanded_->setChecked(settings.leftHanded);
        const std::array<double, 3> numbers = {settings.swapButton, settings.cutButton, settings.clutchButton};
        for (std::size_t i = 0; i < numbers.size(); ++i) buttons_[i]->setCurrentIndex(static_cast<int>(numbers[i]));
        showPedal(settings.pedal, settings.pedalUp, settings.pedalDown);
        key_->setKeySequence(QKeySequence(pedalKeyOf(settings)));
    }
    emit changed();
}

void DevicePanel::setPedalKey(const QKeySequence& key) {
    if (key_->keySequence() == key) return;
    key_->setKeySequence(key);
    emit changed();
}

/// A device among several of its kind ("pen:Left") gets an entry of its own.
void DevicePanel::showChosen(QComboBox& box, const QString& name) {
    int place = box.findData(name);
    if (place < 0 && name.contains(':')) {
        place = box.count();
        box.addItem(titleOf(name), name);
    }
    box.setCurrentIndex(std::max(place, 0));
}

void DevicePanel::showRate(double rate) {
    int place = rate_->findData(rate);
    if (place < 0) {
        place = rate_->count();
        rate_->addItem(tr("%1 Hz").arg(rate), rate);
    }
    rate_->setCurrentIndex(place);
}

void DevicePanel::showPedal(const std::string& pedal, double up, double down) {
    pedalText_ = pedal;
    pedalUp_ = up;
    pedalDown_ = down;
    const QString text = pedal.empty() ? tr("key and slider") : QString::fromStdString(pedal);
    pedal_->setText(text);
    pedal_->setToolTip(text);
}

ButtonMap DevicePanel::buttons() const {
    const auto bit = [this](std::size_t which) { return buttons_[which]->currentIndex() - 1; };  // none: kNone
    static_assert(ButtonMap::kNone == -1);
    return {bit(0), bit(1), bit(2)};
}

void DevicePanel::showState(const QString& device, ForceState force, const Message* faultMessage) {
    if (device.isEmpty()) return state_->setText(tr("The mouse steers; the meter shows what a hand would feel."));
    state_->setText(device + ": " + (faultMessage != nullptr ? translated(*faultMessage) : forceStateText(force)));
}

void DevicePanel::showSecondState(const QString& device, const Message* faultMessage) {
    secondDeviceState_->setVisible(!device.isEmpty());
    const QString state = faultMessage != nullptr ? translated(*faultMessage) : tr("ready");
    secondDeviceState_->setText(device.isEmpty() ? QString() : device + ": " + state);
}

}  // namespace tactooth
