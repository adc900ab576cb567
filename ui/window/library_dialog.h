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

/// Lets the user look through a library of small files, those that Burin is shipped with and the user's own, search,
/// copy, change, delete and add one. What is changed counts when it is saved. What a library holds, and the form that
/// shows one of it, is up to the class of its kind.
class LibraryDialog : public QDialog {
    Q_OBJECT
public:
    void reject() override; ///< asks about changes that are not saved

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
        QString known; ///< an ID that is there already: %1
    };

    LibraryDialog(Texts texts, QSize size, QWidget* parent);

    // In the constructor of a kind: the buttons of its own, then the rest.
    QPushButton* addListButton(const QString& text, const QString& icon, const QString& name, const QKeySequence& key,
                               const QString& toolTip);
    void addBelowList(QWidget* widget);
    QPushButton* addFootButton(const QString& text, const QString& icon, const QString& name);
    /// @param page the form, or the area that it scrolls in; the dialog takes it. @param nameField object name of the
    /// field that a copy is renamed in
    void start(QWidget* page, const QString& nameField, const std::string& id);

    const std::string& shownId() const noexcept { return id_; }
    void showEntry(const std::string& id); ///< the first one in use, or the first, where that one is not there any more
    void refresh();                        ///< the library changed; what is not saved stays in the fields
    void follow();                         ///< the fields were edited
    void fail(const Error& error);
    void warn(const QString& text);
    bool leaveChanges(); ///< nothing is unsaved, or the user gives it up

    virtual std::vector<Entry> entries() const = 0;
    virtual void fill(const std::string& id, bool shipped) = 0; ///< the form shows that one
    virtual bool edited() const = 0;                            ///< the form holds other values than `shownId` has
    virtual QString problem() const { return {}; }              ///< why the form's values can't be kept
    virtual QString about(bool shipped) const = 0;              ///< a sentence above the form
    virtual std::string copy(const std::string& id) = 0;        ///< @return id of the copy
    virtual void erase(const std::string& id) = 0;
    virtual Result<void> keep() = 0; ///< what the form holds
    virtual QString askFile() = 0;   ///< empty: none
    /// A file of the kind that has been read and is not in the library yet.
    struct Incoming {
        std::string id;
        std::function<void()> keep;
        QString notes; ///< what the user should know of it
    };
    virtual Result<Incoming> read(const std::string& file) = 0;
    virtual void followFoot() {} ///< states of the kind's own buttons

private:
    void layOut();
    QWidget* makeList();
    QWidget* makeFoot();
    QString named(const char* before, const char* after) const;
    void refreshList();
    std::vector<Entry> foundEntries() const; ///< those that the user searches for
    void choose(int row);
    void copyShown();
    void removeShown();
    void addFromFile();
    void saveChanges();

    Texts texts_;
    std::string id_;       ///< of what is shown
    bool shipped_ = false; ///< what is shown
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
