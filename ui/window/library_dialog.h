// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <QDialog>

#include <functional>
#include <string>
#include <vector>

class QBoxLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace burin {

class Notice;
class RowList;

/// Lets the user browse a library of small files, shipped with Burin or the user's own: search, copy, change, delete
/// and add. Changes take effect when saved. Derived classes provide the contents of the library and the form for an
/// item.
class LibraryDialog : public QDialog {
    Q_OBJECT
public:
    void reject() override; ///< asks about unsaved changes

protected:
    struct Entry {
        std::string id;
        QString name;
        bool shipped = false;
        bool inUse = false;
        QString detail{}; ///< below the name; empty: the id
    };
    struct Texts {
        QString kind; ///< in object names: "Machine" gives machineList, copyMachineButton, …
        QString title;
        QString shippedBadge;
        QString copyTip, addTip, deleteTip, notDeletable;
        QString known; ///< message that an ID exists already: %1
    };

    LibraryDialog(Texts texts, QSize size, QWidget* parent);

    // For constructors of derived classes: first their own buttons, then `start`.
    QPushButton* addListButton(const QString& text, const QString& icon, const QString& name, const QKeySequence& key,
                               const QString& toolTip);
    void addBelowList(QWidget* widget);
    void addAboveList(QWidget* widget); ///< above the search
    QPushButton* addFootButton(const QString& text, const QString& icon, const QString& name);
    /// @param page the form, or its scroll area; owned by the dialog. @param nameField object name of the field in
    /// which a copy is renamed
    void start(QWidget* page, const QString& nameField, const std::string& id);

    const std::string& shownId() const noexcept { return id_; }
    void showEntry(const std::string& id); ///< if it no longer exists, one in use, or the first of the list
    void showListed();                     ///< the first of the list, unless the shown one is in it
    void refresh();                        ///< the library has changed; unsaved values stay in the fields
    void follow();                         ///< the fields were edited
    void fail(const Error& error);
    void warn(const QString& text);
    bool leaveChanges(); ///< true if nothing is unsaved or the user discards it

    virtual std::vector<Entry> entries() const = 0;
    /// Whether it is in the part of the library that is listed.
    virtual bool listed(const Entry&) const { return true; }
    virtual void fill(const std::string& id, bool shipped) = 0; ///< shows that item in the form
    virtual bool edited() const = 0;               ///< whether the values in the form differ from those of `shownId`
    virtual QString problem() const { return {}; } ///< why the form's values can't be saved
    virtual QString about(bool shipped) const = 0; ///< sentence above the form
    virtual std::string copy(const std::string& id) = 0; ///< @return id of the copy
    virtual void erase(const std::string& id) = 0;
    virtual Result<void> keep() = 0; ///< saves the values of the form
    virtual QString askFile() = 0;   ///< empty: none
    /// An item that was read from a file and is not in the library yet.
    struct Incoming {
        std::string id;
        std::function<void()> keep;
        QString notes; ///< notes for the user
    };
    virtual Result<Incoming> read(const std::string& file) = 0;
    virtual void followFoot() {} ///< updates the derived class's own buttons

private:
    void layOut();
    QWidget* makeList();
    QWidget* makeFoot();
    QString named(const char* before, const char* after) const;
    void refreshList();
    bool lists(const std::string& id) const;
    std::vector<Entry> foundEntries() const; ///< those that match the search
    void choose(int row);
    void copyShown();
    void removeShown();
    void addFromFile();
    void saveChanges();

    Texts texts_;
    std::string id_;       ///< of the shown item
    bool shipped_ = false; ///< whether the shown item is shipped
    QString nameField_;
    QWidget* page_ = nullptr;
    QLineEdit* search_ = nullptr;
    RowList* list_ = nullptr;
    QBoxLayout *listButtons_ = nullptr, *footButtons_ = nullptr, *pageColumn_ = nullptr;
    QLabel* title_ = nullptr;
    Notice* notice_ = nullptr;
    QPushButton *remove_ = nullptr, *save_ = nullptr, *revert_ = nullptr;
};

} // namespace burin
