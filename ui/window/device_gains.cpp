// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/device_gains.h"

#include "ui/panels/buttons.h"
#include "ui/panels/device_labels.h"
#include "ui/panels/field_row.h"
#include "ui/panels/quantity_field.h"

#include <QBoxLayout>
#include <QLabel>

namespace burin {

namespace {

constexpr double stiffest = 20'000.0; // N/m, more than any desktop device

} // namespace

DeviceGains::DeviceGains(UserSettings& settings, QWidget* parent) : QWidget(parent), settings_(settings) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    text_ = new QLabel(this);
    text_->setObjectName(QStringLiteral("deviceGains"));
    text_->setWordWrap(true);
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    column->addWidget(text_);
    ceiling_ = addField(*column, tr("Maximum stiffness"), new QuantityField(Quantity::stiffness, this),
                        "deviceStiffnessCeiling",
                        tr("The part never feels stiffer than this, whatever the device allows. 0: as stiff as it "
                           "allows"));
    ceiling_->limit(0.0, stiffest);
    friction_ = addField(*column, tr("Friction of the handle"), new QuantityField(Quantity::force, this),
                         "deviceHandleFriction",
                         tr("Force with which a spring balance just moves the handle while the motors are off. It "
                            "absorbs the steps of the encoders, and limits the suggested stiffness. 0: not measured"));
    friction_->limit(0.0, GainRequest::mostFriction);
    use_ = makeButton(tr("Use the suggested gains"), {}, QStringLiteral("useGainsButton"), this);
    restore_ = makeButton(tr("Previous gains"), {}, QStringLiteral("previousGainsButton"), this);
    auto* row = new QHBoxLayout;
    row->addWidget(use_);
    row->addWidget(restore_);
    row->addStretch(1);
    column->addLayout(row);
    connect(ceiling_, &QuantityField::valueEdited, this, [this](double ceiling) {
        KeptGains gains = gains_;
        gains.request.ceiling = ceiling >= GainLimits::softest ? ceiling : GainLimits::none;
        change(gains);
    });
    connect(friction_, &QuantityField::valueEdited, this, [this](double friction) {
        KeptGains gains = gains_;
        gains.request.friction = friction;
        change(gains);
    });
    connect(use_, &QPushButton::clicked, this, [this] {
        const std::optional<SuggestedGains> suggested = this->suggested();
        if (!suggested) return;
        KeptGains gains = gains_;
        gains.use(suggested->limits());
        change(gains);
    });
    connect(restore_, &QPushButton::clicked, this, [this] {
        KeptGains gains = gains_;
        gains.restore();
        change(gains);
    });
    showState();
}

QuantityField* DeviceGains::addField(QBoxLayout& column, const QString& label, QuantityField* field, const char* name,
                                     const QString& toolTip) {
    field->setObjectName(QLatin1String(name));
    column.addWidget(new FieldRow(label, field, toolTip, this));
    return field;
}

void DeviceGains::showDevice(const std::string& device) {
    device_ = device;
    gains_ = device.empty() ? KeptGains{} : settings_.gains(device);
    showTrial(std::nullopt, std::nullopt, false);
}

void DeviceGains::showTrial(const std::optional<StylusDescription>& stylus, const std::optional<TrialFigures>& trial,
                            bool over) {
    stylus_ = stylus;
    trial_ = trial;
    over_ = over;
    showState();
}

std::optional<SuggestedGains> DeviceGains::suggested() const {
    return stylus_ && trial_ && over_ ? suggestGains(*stylus_, *trial_, gains_.request) : std::nullopt;
}

void DeviceGains::change(const KeptGains& gains) {
    gains_ = gains;
    if (const QString file = settings_.setGains(device_, gains); !file.isEmpty()) emit unwritten(file);
    emit edited();
    showState();
}

void DeviceGains::showState() {
    const std::optional<SuggestedGains> suggested = this->suggested();
    const bool any = !device_.empty();
    QStringList lines;
    if (suggested) lines << gainLines(*suggested, locale());
    if (any) lines << gainsInUse(gains_.inForce(), locale());
    text_->setText(lines.join(QLatin1Char('\n')));
    text_->setVisible(!lines.isEmpty());
    ceiling_->setEnabled(any);
    friction_->setEnabled(any);
    ceiling_->showValue(gains_.request.ceiling < GainLimits::none ? gains_.request.ceiling : 0.0);
    friction_->showValue(gains_.request.friction);
    const bool used = suggested && suggested->limits() == gains_.now;
    enableUnless(use_,
                 !suggested ? tr("Test a device with motors first: its rate and latency are measured for this.")
                 : used     ? tr("The suggested gains are in use.")
                            : QString(),
                 tr("Use the stiffness and damping that the test suggests for this device, the next time you mill. "
                    "“Previous gains” takes it back."));
    enableUnless(restore_, gains_.now == gains_.before ? tr("The gains of this device were not changed.") : QString(),
                 tr("Use the stiffness and damping from before the last change again"));
}

} // namespace burin
