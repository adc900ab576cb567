// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/dialogs/preferences.h"

#include <QWidget>

#include <optional>
#include <string>

class QBoxLayout;
class QLabel;
class QPushButton;

namespace burin {

class QuantityField;

/// Shows the gains that a test of a device suggests and those in use, and changes them. Changes are stored for the
/// device.
class DeviceGains final : public QWidget {
    Q_OBJECT
public:
    DeviceGains(UserSettings& settings, QWidget* parent); ///< @param settings outlive the object

    /// @param device id; empty: none that can have gains
    void showDevice(const std::string& device);
    /// The results of a test of the device; empty: it was not tested. @param over whether the test has ended
    void showTrial(const std::optional<StylusDescription>& stylus, const std::optional<TrialFigures>& trial, bool over);

signals:
    void edited(); ///< already stored
    void unwritten(const QString& file);

private:
    QuantityField* addField(QBoxLayout& column, const QString& label, QuantityField* field, const char* name,
                            const QString& toolTip);
    void change(const KeptGains& gains);
    void showState();
    std::optional<SuggestedGains> suggested() const;

    UserSettings& settings_;
    std::string device_;
    KeptGains gains_; ///< of the device
    std::optional<StylusDescription> stylus_;
    std::optional<TrialFigures> trial_;
    bool over_ = false;
    QLabel* text_ = nullptr;
    QuantityField *ceiling_ = nullptr, *friction_ = nullptr;
    QPushButton *use_ = nullptr, *restore_ = nullptr;
};

} // namespace burin
