// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/guides/guide_reach.h"
#include "core/setup/guide.h"
#include "ui/theme/length_unit.h"

#include <QFrame>

#include <functional>
#include <vector>

class QCheckBox;

namespace burin {

class ChoiceBox;
class NamedSwitch;
class QuantityField;

/// One guide of the hand: its switch, where it is, and whether it holds.
class GuideCard : public QFrame {
    Q_OBJECT
public:
    /// @param place among the guides, from 0: part of the object names ("guide2Switch", "guide2Distance")
    GuideCard(std::size_t place, const Guide& guide, QWidget* parent = nullptr);

    /// Shows values without a signal. The kind must be the one that it was made for. @param zero mm, of the program, in
    /// the setup frame: places are shown from there
    void showGuide(const Guide& guide, const glm::dvec3& zero);
    void showNews(const GuideNews* news, LengthUnit unit); ///< null: nothing is known, as no loop runs
    void setUnit(LengthUnit unit);
    GuideKind kind() const noexcept { return guide_.kind; }

signals:
    void edited(const burin::Guide& guide);
    void removalRequested();

private:
    struct Field {
        QuantityField* field;
        std::function<double&(Guide&)> value;
        int axis; ///< of a place, which is shown from zero; -1: another figure
    };
    void addHead(const QString& name);
    void addDirection(const QString& name, const QString& label);
    QuantityField* addField(const QString& name, const QString& label, const QString& toolTip, QuantityField* field,
                            std::function<double&(Guide&)> value, int axis = -1);
    void addPlace(const QString& name, int axis, const QString& toolTip);
    void addFigures(const QString& name);

    Guide guide_;
    glm::dvec3 zero_{0.0};
    NamedSwitch* switch_ = nullptr;
    QCheckBox* onSurface_ = nullptr;
    ChoiceBox* direction_ = nullptr;
    QString news_; ///< what became of it
    std::vector<Field> fields_;
};

} // namespace burin
