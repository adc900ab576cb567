// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/device_dialog.h"

#include "ui/messages/messages.h"
#include "ui/panels/buttons.h"
#include "ui/panels/device_labels.h"
#include "ui/panels/field_row.h"
#include "ui/panels/notice.h"
#include "ui/panels/quantity_field.h"
#include "ui/panels/row_list.h"
#include "ui/window/axis_dialog.h"
#include "ui/window/device_gains.h"

#include <QBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>

namespace burin {

namespace {

constexpr QSize deviceDialogSize(860, 920);
constexpr int aroundDialog = 100; // pixels of the screen's height that a dialog leaves free
constexpr double mostForce = 4.0; // N: a fifth of the strongest device's force

QLabel* makeText(const QString& name, QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setObjectName(name);
    label->setWordWrap(true);
    label->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    return label;
}

} // namespace

DeviceDialog::DeviceDialog(StylusController& styluses, DeviceTester& tester, AxisTuner& tuner, ViewDevice& view,
                           UserSettings& settings, QWidget* parent)
    : QDialog(parent)
    , styluses_(styluses)
    , tester_(tester)
    , tuner_(tuner)
    , view_(view)
    , settings_(settings)
    , row_(static_cast<int>(styluses.chosen())) {
    setObjectName(QStringLiteral("deviceDialog"));
    setWindowTitle(tr("Devices"));
    layOut();
    resize(
        deviceDialogSize.boundedTo({deviceDialogSize.width(), screen()->availableGeometry().height() - aroundDialog}));
    tester_.forget();
    connect(&styluses_, &StylusController::changed, this, &DeviceDialog::showState);
    connect(&tester_, &DeviceTester::changed, this, &DeviceDialog::showState);
    connect(&view_, &ViewDevice::changed, this, &DeviceDialog::showState);
    tester_.askDrivers();
    showFelt();
    showState();
}

DeviceDialog::~DeviceDialog() {
    tester_.stop();
}

void DeviceDialog::layOut() {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 12);
    column->setSpacing(8);
    auto* halves = new QHBoxLayout;
    halves->setSpacing(16);
    list_ = new RowList(this);
    list_->setObjectName(QStringLiteral("deviceList"));
    list_->setAccessibleName(windowTitle());
    list_->setFillsHeight(true);
    list_->setTextsWrap(true);
    halves->addWidget(list_, 1);
    auto* area = new QScrollArea(this); // a tested device has more to tell than a small screen is high
    area->setObjectName(QStringLiteral("deviceSettings"));
    area->setAccessibleName(windowTitle());
    area->setFrameShape(QFrame::NoFrame);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setWidgetResizable(true);
    auto* settings = new QWidget(area);
    auto* right = new QVBoxLayout(settings);
    right->setContentsMargins(0, 0, 8, 0); // beside the bar
    right->setSpacing(8);
    limits_ = makeText(QStringLiteral("deviceLimits"), this);
    figures_ = makeText(QStringLiteral("deviceFigures"), this);
    right->addWidget(limits_);
    right->addWidget(figures_, 1);
    force_ = new QuantityField(Quantity::force, this);
    force_->setObjectName(QStringLiteral("deviceForce"));
    force_->limit(0.0, mostForce);
    force_->showValue(pushed_);
    right->addWidget(
        new FieldRow(tr("Test force"), force_,
                     tr("The device pushes up with this force while you hold its first button. It fades in "
                        "over one second and is limited to a fifth of the maximum force. 0: motors off"),
                     this));
    share_ =
        addShare(*right, tr("Cutting force felt"), "deviceShare", &FeltCutting::gain,
                 tr("1: a reference cut in the hardest material gives 60 % of the maximum force. 0: only the part is "
                    "felt, not the cutting"));
    friction_ = addShare(*right, tr("Friction felt"), "deviceFriction", &FeltCutting::friction,
                         tr("Friction coefficient where the tool slides without cutting"));
    assist_ = addShare(*right, tr("Strength of the assist"), "deviceAssist", &FeltCutting::assist,
                       tr("Ceiling of a gamepad's vibration or a joystick's force, as a share of its strongest effect. "
                          "Vibration: the strong motor shows how deep you push, the weak one how hard the tool cuts. A "
                          "joystick pushes only while a button is held, in the test the first one. 0: off"));
    addGains(*right);
    addStockDistance(*right);
    area->setWidget(settings);
    halves->addWidget(area, 1);
    column->addLayout(halves, 1);
    notice_ = new Notice(this);
    notice_->setObjectName(QStringLiteral("deviceNotice"));
    column->addWidget(notice_);
    test_ = makeButton(tr("Test"), {}, QStringLiteral("testDeviceButton"), this);
    axes_ = makeButton(tr("Axes and buttons…"), {}, QStringLiteral("deviceAxesButton"), this);
    use_ = makePrimaryButton(tr("Mill with this device"), QStringLiteral("useDeviceButton"), this);
    moveView_ = makeButton({}, {}, QStringLiteral("moveViewButton"), this);
    auto* close = makeButton(tr("Close"), {}, QStringLiteral("closeDevicesButton"), this);
    auto* row = new QHBoxLayout;
    row->addWidget(test_);
    row->addWidget(axes_);
    row->addStretch(1);
    row->addWidget(moveView_);
    row->addWidget(use_);
    row->addWidget(close);
    column->addLayout(row);
    connect(list_, &RowList::rowChosen, this, &DeviceDialog::choose);
    connect(force_, &QuantityField::valueEdited, this, [this](double newtons) { pushed_ = newtons; });
    connect(test_, &QPushButton::clicked, this, &DeviceDialog::testOrStop);
    connect(use_, &QPushButton::clicked, this, [this] { styluses_.choose(static_cast<std::size_t>(row_)); });
    connect(axes_, &QPushButton::clicked, this, &DeviceDialog::assignAxes);
    connect(moveView_, &QPushButton::clicked, this, &DeviceDialog::moveViewOrNot);
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
}

void DeviceDialog::addGains(QBoxLayout& column) {
    gains_ = new DeviceGains(settings_, this);
    column.addWidget(gains_);
    connect(gains_, &DeviceGains::edited, this, &DeviceDialog::gainsEdited);
    connect(gains_, &DeviceGains::unwritten, this, [this](const QString& file) {
        notice_->tell(Notice::Kind::error,
                      Messages::sentence({ErrorCode::fileNotWritable, file.toStdString(), {}, {}}));
    });
}

void DeviceDialog::addStockDistance(QBoxLayout& column) {
    auto* field = new QuantityField(Quantity::length, this);
    field->setObjectName(QStringLiteral("stockDistance"));
    field->setLengthUnit(settings_.preferences().unit);
    field->limit(StockLayer::distances.low, StockLayer::distances.high);
    field->showValue(settings_.stockLayer().distance);
    column.addWidget(new FieldRow(tr("Distance from the stock"), field,
                                  tr("Distance that shank and holder keep from the stock, counted from the centres of "
                                     "its voxels, with every stylus, while “Keep from the stock” is on in the menu "
                                     "Mill. A change restarts milling."),
                                  this));
    connect(field, &QuantityField::valueEdited, this, [this](double distance) {
        settings_.setStockLayer({distance, settings_.stockLayer().on});
        emit stockLayerEdited();
    });
}

QuantityField* DeviceDialog::addShare(QBoxLayout& column, const QString& label, const char* name,
                                      double FeltCutting::*value, const QString& toolTip) {
    auto* field = new QuantityField(Quantity::ratio, this);
    field->setObjectName(QLatin1String(name));
    field->limit(0.0, 1.0);
    column.addWidget(new FieldRow(label, field, toolTip, this));
    connect(field, &QuantityField::valueEdited, this, [this, value](double edited) {
        felt_.*value = edited;
        keepFelt();
    });
    return field;
}

/// For the device of the selected row.
void DeviceDialog::showFelt() {
    const StylusController::Choice* device = current();
    const bool felt = device != nullptr && !device->id.empty();
    felt_ = felt ? settings_.felt(device->id) : FeltCutting{};
    share_->setEnabled(felt);
    friction_->setEnabled(felt);
    assist_->setEnabled(felt);
    gains_->showDevice(felt ? device->id : std::string());
    share_->showValue(felt_.gain);
    friction_->showValue(felt_.friction);
    assist_->showValue(felt_.assist);
}

void DeviceDialog::keepFelt() {
    const StylusController::Choice* device = current();
    if (device == nullptr || device->id.empty()) return;
    settings_.setFelt(device->id, felt_);
    emit feltEdited();
}

/// The device of the selected row; null: a driver without its library.
const StylusController::Choice* DeviceDialog::current() const {
    const auto& choices = styluses_.choices();
    const auto place = static_cast<std::size_t>(row_);
    return row_ >= 0 && place < choices.size() ? &choices[place] : nullptr;
}

void DeviceDialog::choose(int row) {
    if (row == row_) return;
    tester_.stop();
    tester_.forget();
    row_ = row;
    showFelt();
    showState();
}

void DeviceDialog::testOrStop() {
    if (tester_.testing()) return tester_.stop();
    if (const StylusController::Choice* device = current()) tester_.test(*device, pushed_, felt_.assist);
}

void DeviceDialog::moveViewOrNot() {
    const StylusController::Choice* device = current();
    if (device != nullptr) view_.choose(device->id == view_.chosen() ? std::string() : device->id);
}

void DeviceDialog::assignAxes() {
    const StylusController::Choice* current = this->current();
    if (current == nullptr) return;
    const StylusController::Choice device = *current; // the list may change meanwhile
    AxisDialog dialog(tuner_, device, styluses_.axisMap(device.id), this);
    if (dialog.exec() != QDialog::Accepted) return;
    if (const QString unwritten = settings_.setAxisMap(device.id, dialog.kept()); !unwritten.isEmpty())
        notice_->tell(Notice::Kind::error,
                      Messages::sentence({ErrorCode::fileNotWritable, unwritten.toStdString(), {}, {}}));
    view_.assignAxes(device.id);
}

void DeviceDialog::showState() {
    showRows();
    showUses();
    showTest();
}

void DeviceDialog::showRows() {
    std::vector<ListRow> rows;
    for (std::size_t i = 0; i < styluses_.choices().size(); ++i) {
        const StylusController::Choice& choice = styluses_.choices()[i];
        ListRow row;
        row.title = choice.name;
        row.value = i == styluses_.chosen() ? tr("selected") : QString();
        if (!choice.id.empty() && choice.id == view_.chosen()) row.badge = tr("moves the view");
        row.detail = choice.id.empty() ? tr("Mouse and keyboard, always there")
                     : choice.there    ? tr("Found")
                                       : tr("Not plugged in");
        rows.push_back(row);
    }
    for (const DriverState& driver : tester_.drivers()) {
        if (!driver.missing) continue;
        ListRow row;
        row.title = QString::fromStdString(driver.name);
        row.badge = tr("library missing");
        row.detail = Messages::sentence(*driver.missing);
        rows.push_back(row);
    }
    list_->setRows(rows);
    list_->setChosen(row_);
}

/// Updates the buttons for the possible uses of the selected device.
void DeviceDialog::showUses() {
    const StylusController::Choice* device = current();
    enableUnless(use_, device == nullptr ? tr("Select a device or the mouse.") : QString(),
                 tr("Use this device the next time you start milling"));
    const bool moves = device != nullptr && !device->id.empty() && device->id == view_.chosen();
    const bool suits = moves || (device != nullptr && view_.suits(device->id));
    moveView_->setText(moves ? tr("Stop moving the view") : tr("Move the view with this device"));
    enableUnless(
        moveView_, suits ? QString() : tr("Select a 3D mouse, gamepad or joystick."),
        tr("Pan, zoom and rotate the view with this device, beside the stylus. Its first button fits the view. "
           "While it moves the tool, the view stays"));
}

void DeviceDialog::showTest() {
    const StylusController::Choice* device = current();
    const bool testable = device != nullptr && !device->id.empty() && device->there;
    const QString none = testable ? QString() : tr("Select a device that is plugged in.");
    const QString reason = tester_.testing() || tester_.possible() ? none : tr("Stop milling first.");
    test_->setText(tester_.testing() ? tr("Stop the test") : tr("Test"));
    enableUnless(axes_, tester_.testing() ? tr("Stop the test first.") : reason,
                 tr("What the axes and buttons of a gamepad, joystick, tablet or 3D mouse do, and their calibration"));
    enableUnless(test_, tester_.testing() ? QString() : reason,
                 tr("Read the device while you move it: rate, position, buttons"));
    force_->setEnabled(!tester_.testing());
    limits_->setText(tester_.description() ? limitLines(*tester_.description(), locale()).join(QLatin1Char('\n'))
                                           : QString());
    figures_->setText(tester_.figures() ? trialLines(*tester_.figures(), locale()).join(QLatin1Char('\n')) : QString());
    gains_->showTrial(tester_.description(), tester_.figures(), !tester_.testing());
    if (tester_.fault())
        notice_->tell(Notice::Kind::error, Messages::sentence(*tester_.fault()));
    else if (tester_.testing())
        notice_->tell(Notice::Kind::information,
                      tr("Move the device through its whole workspace and press every button."));
    else
        notice_->clear();
}

} // namespace burin
