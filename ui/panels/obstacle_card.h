// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/setup_states.h"
#include "ui/theme/length_unit.h"

#include <QFrame>

#include <functional>

class QLabel;
class QToolButton;

namespace burin {

class ChoiceBox;
class NamedSwitch;
class QuantityField;

/// The state of a fixture or limit as text: "holds the tool", …
QString boundNewsText(BoundNews news);

/// One fixture or keep-out volume: its switch, its kind, its position, and the clearance that the tool keeps from it.
class ObstacleCard : public QFrame {
    Q_OBJECT
public:
    /// @param place index of the obstacle, from 0: part of the object names ("obstacle1Switch", "obstacle1SizeX")
    ObstacleCard(std::size_t place, const Obstacle& obstacle, QWidget* parent = nullptr);

    /// Shows values without emitting a signal. The shape must be of the same type as the one passed to the constructor.
    /// @param zero program zero, mm, setup frame: positions are displayed relative to it. @param locked whether only
    /// the switch can be used
    void showRow(const ObstacleRow& row, const glm::dvec3& zero, bool locked);
    void setUnit(LengthUnit unit);
    std::size_t shape() const noexcept { return obstacle_.shape.index(); }
    QString title() const { return QString::fromStdString(obstacle_.name); }

signals:
    void edited(const burin::Obstacle& obstacle);
    void switched(bool on);
    void removalRequested();
    void changeRequested(); ///< to be changed by a dialog, or moved in the view; or its move to be ended

private:
    using Get = std::function<double(const Obstacle&)>;
    using Set = std::function<void(Obstacle&, double)>;
    struct Field {
        QuantityField* field;
        Get get;
        int axis;          ///< of a position, which is displayed relative to zero; -1: any other value
        bool bare = false; ///< one of three fields in a row, whose title shows the unit
    };
    struct Title {
        QLabel* label;
        QString text;
    };
    void addHead();
    void showFit();
    QString changeTip() const;
    void addShape();
    void addMeshPlace();
    QuantityField* addField(const QString& name, const QString& label, int axis, Get get, Set set);
    void addRow(const QString& label, const QString& toolTip, QuantityField* field);
    void addTriple(const QString& name, const QString& label, const QString& toolTip, bool place,
                   const std::function<Get(int)>& get, const std::function<Set(int)>& set);

    QString name_;
    Obstacle obstacle_;
    glm::dvec3 zero_{0.0};
    std::shared_ptr<const Obstacle> shown_; ///< what `obstacle_` is a copy of; null once it was edited
    FixtureFit fit_;
    LengthUnit unit_ = LengthUnit::millimetre;
    NamedSwitch* switch_ = nullptr;
    QToolButton *change_ = nullptr, *remove_ = nullptr;
    ChoiceBox* kind_ = nullptr;
    QLabel* notFitting_ = nullptr;
    QWidget* figures_ = nullptr;
    std::vector<Field> fields_;
    std::vector<Title> titles_; ///< of the rows of three fields
};

} // namespace burin
