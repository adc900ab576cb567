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

/// One guide (virtual fixture): its switch, its position, and whether it currently constrains the hand.
class GuideCard : public QFrame {
    Q_OBJECT
public:
    /// @param place index of the guide, from 0: part of the object names ("guide2Switch", "guide2Distance")
    GuideCard(std::size_t place, const Guide& guide, QWidget* parent = nullptr);

    /// Shows values without emitting a signal. The guide must be of the same kind as the one passed to the constructor.
    /// @param zero program zero, mm, setup frame: positions are displayed relative to it
    void showGuide(const Guide& guide, const glm::dvec3& zero);
    void showNews(const GuideNews* news, LengthUnit unit); ///< null: no state is known because no haptic loop runs
    void setUnit(LengthUnit unit);
    GuideKind kind() const noexcept { return guide_.kind; }

signals:
    void edited(const burin::Guide& guide);
    void removalRequested();

private:
    struct Field {
        QuantityField* field;
        std::function<double&(Guide&)> value;
        int axis; ///< of a position, which is displayed relative to zero; -1: any other value
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
    QString news_; ///< the state of the guide
    std::vector<Field> fields_;
};

} // namespace burin
