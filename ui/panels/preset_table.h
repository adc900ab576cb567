// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/tool/cutting_preset.h"
#include "core/volume/runs/property_list.h"
#include "ui/panels/quantity.h"

#include <QWidget>

#include <functional>
#include <vector>

class QGridLayout;
class QLineEdit;
class QPushButton;
class QToolButton;

namespace burin {

class ChoiceBox;
class QuantityField;

/// The presets of a tool, one below the other: name, material, coolant, and numbers, which are 0 where they are not
/// stated. A feed and a feed per tooth replace each other. Object names of the fields, with the number of the preset
/// from 0: "presetName0", "presetMaterial0", "presetCoolant0", "presetSpeed0", "presetFeed0", "presetChipLoad0",
/// "presetPlunge0", "presetStepDown0", "presetStepOver0", "raisePreset0", "removePreset0".
class PresetTable final : public QWidget {
    Q_OBJECT
public:
    /// @param materials that a preset can be for
    explicit PresetTable(std::vector<Property> materials, QWidget* parent = nullptr);
    /// Never emits. @param radius, deepestCut of the tool, mm: limits of its steps
    void showPresets(const std::vector<CuttingPreset>& presets, double radius, double deepestCut);
    void setReadOnly(bool readOnly);
    void setUnit(LengthUnit unit);

signals:
    void edited(const std::vector<burin::CuttingPreset>& presets); ///< by the user

private:
    struct Card {
        QWidget* box = nullptr;
        QLineEdit* name = nullptr;
        ChoiceBox *material = nullptr, *coolant = nullptr;
        QuantityField *speed = nullptr, *feed = nullptr, *chipLoad = nullptr, *plunge = nullptr, *stepDown = nullptr,
                      *stepOver = nullptr;
        QToolButton *raise = nullptr, *remove = nullptr;

        std::vector<QuantityField*> numbers() const { return {speed, feed, chipLoad, plunge, stepDown, stepOver}; }
    };
    void addCard();
    void removeCard();
    void addTexts(Card& card, QGridLayout& grid);
    void addNumbers(Card& card, QGridLayout& grid);
    void show(const Card& card, const CuttingPreset& preset);
    void change(std::size_t at, const std::function<void(CuttingPreset&)>& how);
    void offerMaterials(const Card& card, const CuttingPreset& preset);
    void addPreset();
    void removePreset(std::size_t at);
    void raisePreset(std::size_t at);

    std::vector<Property> materials_;
    std::vector<CuttingPreset> presets_;
    std::vector<Card> cards_;
    QPushButton* add_;
    LengthUnit unit_ = LengthUnit::millimetre;
    double radius_ = 0.0, deepestCut_ = 0.0; ///< mm
    bool readOnly_ = false;
};

} // namespace burin
