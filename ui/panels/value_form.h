// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/number_range.h"
#include "ui/panels/quantity_field.h"

#include <QWidget>

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

class QGridLayout;
class QLineEdit;

namespace burin {

/// Rows of fields for the values of a file: label, numbers or a choice or text, and the source of the value. The source
/// of a value that the user changes is the user, until they state another one. Object names of the fields: the key in
/// the file, with "0", "1", "2" if it has several numbers; for the source: the key with "Source".
class ValueForm : public QWidget {
    Q_OBJECT
public:
    void setUnit(LengthUnit unit);

signals:
    void edited(); ///< by the user

protected:
    /// One number of a key, in the internal unit of its quantity.
    struct NumberField {
        Quantity quantity = Quantity::length;
        NumberRange range;
        bool optional = false; ///< whether 0 means "not stated"
        std::function<double()> get;
        std::function<void(double)> set;
        std::function<bool()> used{}; ///< whether it has a value that can be changed; empty: always
    };
    struct ChoiceField {
        QStringList texts;
        std::function<int()> get;
        std::function<void(int)> set;
    };
    struct TextField {
        std::function<std::string()> get;
        std::function<void(std::string)> set;
    };

    /// @param sourcePlaceholder shown where a value states no source of its own
    ValueForm(const QString& sourcePlaceholder, QWidget* parent);

    void addTitle(const QString& text);
    /// @param label label of the buddy, which the caller places. @return the row
    int beginRow(const QString& label, QWidget* buddy, const QString& toolTip);
    /// Places a widget in the column of the first field, as wide as three fields.
    void placeWide(QWidget* field, int row);
    /// Places a widget from the column of the first field to the end of the row.
    void placeToEnd(QWidget* field, int row);
    void addNumberFields(const char* key, const QString& label, const QString& toolTip,
                         std::vector<NumberField> numbers, bool withSource);
    void addChoiceField(const char* key, const QString& label, const QString& toolTip, ChoiceField choice,
                        bool withSource);
    QLineEdit* addTextField(const char* name, const QString& label, const QString& toolTip, TextField text);
    void addSource(const char* key, const QString& label, int row);
    void closeRows(); ///< to be called after the last row
    void onRefresh(std::function<void()> show) { refreshers_.push_back(std::move(show)); }
    void lock(bool locked); ///< makes the values read-only
    void changed(const std::string& key);
    void refresh();

    virtual std::map<std::string, std::string>& sources() = 0; ///< by key
    /// Updates the values that depend on a value that the user changed.
    virtual void settle(const std::string&) {}

private:
    LengthUnit unit_ = LengthUnit::millimetre;
    bool locked_ = false;
    QString sourcePlaceholder_;
    QGridLayout* grid_;
    std::vector<std::function<void()>> refreshers_;
    std::vector<QWidget*> fields_;
    std::vector<QuantityField*> numbers_;
};

/// The form for one kind of file whose values are stored in a record.
template <class Record>
class RecordForm : public ValueForm {
protected:
    using ValueForm::ValueForm;

    struct Number {
        Quantity quantity = Quantity::length;
        NumberRange range;
        bool optional = false;
        std::function<double(const Record&)> get;
        std::function<void(Record&, double)> set;
        std::function<bool(const Record&)> used{};
    };
    struct Choice {
        QStringList texts;
        std::function<int(const Record&)> get;
        std::function<void(Record&, int)> set;
    };

    void addNumbers(const char* key, const QString& label, const QString& toolTip, std::vector<Number> numbers,
                    bool withSource = true) {
        std::vector<NumberField> fields;
        for (Number& number : numbers) {
            NumberField field{number.quantity, number.range, number.optional,
                              [this, get = number.get] { return get(record_); },
                              [this, set = number.set](double value) { set(record_, value); }};
            if (number.used) field.used = [this, used = number.used] { return used(record_); };
            fields.push_back(std::move(field));
        }
        addNumberFields(key, label, toolTip, std::move(fields), withSource);
    }
    void addChoice(const char* key, const QString& label, const QString& toolTip, const Choice& choice,
                   bool withSource = true) {
        addChoiceField(key, label, toolTip,
                       {choice.texts, [this, get = choice.get] { return get(record_); },
                        [this, set = choice.set](int index) { set(record_, index); }},
                       withSource);
    }
    QLineEdit* addText(const char* name, const QString& label, const QString& toolTip, std::string Record::*text) {
        return addTextField(name, label, toolTip,
                            {[this, text] { return record_.*text; },
                             [this, text](std::string typed) { record_.*text = std::move(typed); }});
    }
    std::map<std::string, std::string>& sources() override { return record_.sources; }

    Record record_;
};

} // namespace burin
