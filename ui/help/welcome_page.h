// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDateTime>
#include <QString>
#include <QStringList>
#include <QWidget>

#include <vector>

class QPushButton;
class QVBoxLayout;

namespace burin {

/// Work that was not saved when the program ended.
struct LeftWorkRow {
    QString file;
    QDateTime changed;
    friend bool operator==(const LeftWorkRow&, const LeftWorkRow&) = default;
};

/// The first page: how to begin, recent files, unsaved work.
class WelcomePage final : public QWidget {
    Q_OBJECT
public:
    explicit WelcomePage(QWidget* parent = nullptr);

    /// Sets the title of the open project; empty: none, and there is no way back.
    void setProject(const QString& title);
    void setRecentFiles(const QStringList& files);
    void setFirstJobFinished(bool finished); ///< until then it is offered as the primary action
    void setLeftWork(const std::vector<LeftWorkRow>& rows);

signals:
    void backRequested();
    void firstJobRequested();
    void importRequested();
    void sampleRequested();
    void showMeRequested();
    void openRequested();
    void recentChosen(const QString& file);
    void leftWorkChosen(const QString& file);
    void leftWorkForgotten(const QString& file);

private:
    QWidget* firstJob();
    QWidget* beginnings();
    QWidget* lately();

    QPushButton* back_ = nullptr;
    QPushButton* firstJob_ = nullptr;
    QVBoxLayout* recent_ = nullptr;
    QVBoxLayout* left_ = nullptr;
    std::vector<LeftWorkRow> leftRows_; ///< as shown
    QWidget* leftBox_ = nullptr;
    QWidget* recentBox_ = nullptr;
};

} // namespace burin
