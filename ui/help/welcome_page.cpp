// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/help/welcome_page.h"

#include "core/base/file.h"
#include "ui/panels/panel_layout.h"
#include "ui/theme/icon.h"

#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPixmap>
#include <QPushButton>
#include <QVBoxLayout>

namespace burin {

namespace {

constexpr int pictureWidth = 400; // pixels

QLabel* heading(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text.toUpper(), parent);
    label->setProperty("look", "section");
    return label;
}

QLabel* quiet(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setProperty("look", "quiet");
    label->setWordWrap(true);
    return label;
}

/// A picture of the finished sample part. Null if the picture is missing.
QLabel* samplePicture(QWidget* parent) {
    const QString file = QString::fromStdString((resourceDirectory() / "pictures" / "demo.png").string());
    const QPixmap picture(file);
    if (picture.isNull()) return nullptr;
    auto* label = new QLabel(parent);
    label->setObjectName(QStringLiteral("samplePicture"));
    const qreal ratio = label->devicePixelRatioF();
    QPixmap scaled = picture.scaledToWidth(qRound(pictureWidth * ratio), Qt::SmoothTransformation);
    scaled.setDevicePixelRatio(ratio);
    label->setPixmap(scaled);
    label->setToolTip(WelcomePage::tr("The sample part, milled."));
    return label;
}

/// A button with an explanation below it.
QWidget* offer(QPushButton* button, const QString& explanation) {
    auto* box = new QWidget;
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    button->setMinimumHeight(40);
    button->setCursor(Qt::PointingHandCursor);
    layout->addWidget(button);
    layout->addWidget(quiet(explanation, box));
    return box;
}

QPushButton* button(const QString& text, const char* name, const QString& toolTip, const char* icon = nullptr) {
    auto* made = new QPushButton(text);
    if (icon != nullptr) made->setIcon(themedIcon(QString::fromLatin1(icon)));
    made->setObjectName(QString::fromLatin1(name));
    made->setToolTip(toolTip);
    return made;
}

void empty(QVBoxLayout* layout) {
    while (QLayoutItem* item = layout->takeAt(0)) {
        delete item->widget();
        delete item;
    }
}

} // namespace

WelcomePage::WelcomePage(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("welcomePage"));
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(48, 48, 48, 32);
    outer->setSpacing(8);
    outer->addStretch(2);
    auto* centre = new QWidget(this);
    centre->setMaximumWidth(880);
    auto* layout = new QVBoxLayout(centre);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    back_ = button({}, "backButton", tr("Return to the project (Esc)"), "previous");
    connect(back_, &QPushButton::clicked, this, &WelcomePage::backRequested);
    layout->addWidget(back_, 0, Qt::AlignLeft);
    back_->hide();
    auto* title = new QLabel(tr("Burin"), centre);
    title->setProperty("look", "title");
    title->setStyleSheet(QStringLiteral("font-size: 30pt; font-weight: 600;"));
    layout->addWidget(title);
    layout->addWidget(quiet(tr("Mill the part by hand; the machine repeats what your hand did."), centre));
    layout->addSpacing(16);
    layout->addWidget(firstJob());
    layout->addSpacing(16);
    auto* columns = new QHBoxLayout;
    columns->setSpacing(64);
    columns->addWidget(beginnings(), 1);
    columns->addWidget(lately(), 1);
    layout->addLayout(columns);
    auto* row = new QHBoxLayout;
    row->addStretch(1);
    row->addWidget(centre, 20);
    row->addStretch(1);
    outer->addLayout(row);
    outer->addStretch(3);
}

QWidget* WelcomePage::firstJob() {
    auto* box = new QWidget(this);
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(16);
    firstJob_ = button(tr("First job"), "firstJobButton", tr("Start a guide through a complete job, step by step."));
    firstJob_->setMinimumHeight(40);
    firstJob_->setCursor(Qt::PointingHandCursor);
    connect(firstJob_, &QPushButton::clicked, this, &WelcomePage::firstJobRequested);
    row->addWidget(firstJob_);
    row->addWidget(quiet(tr("From the sample part to a checked program: Burin shows what to press next."), box), 1);
    return box;
}

void WelcomePage::setFirstJobFinished(bool finished) {
    setLook(firstJob_, finished ? "" : "primary");
}

QWidget* WelcomePage::beginnings() {
    auto* box = new QWidget(this);
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(16);
    layout->addWidget(heading(tr("Begin"), box));
    auto* part = button(tr("Open a part…"), "openPartButton",
                        tr("Read a part from a CAD file (STEP, IGES, BREP) or a mesh (STL, 3MF, OBJ, PLY, AMF, OFF)."),
                        "import");
    connect(part, &QPushButton::clicked, this, &WelcomePage::importRequested);
    layout->addWidget(
        offer(part, tr("STEP, IGES, BREP, or a mesh (STL, 3MF, OBJ …). Dropping a file on the window does the same.")));
    auto* sample = button(tr("Try the sample part"), "samplePartButton",
                          tr("Import the part that Burin is shipped with."), "part");
    connect(sample, &QPushButton::clicked, this, &WelcomePage::sampleRequested);
    layout->addWidget(offer(sample, tr("A computer mouse, 110 mm long, ready to be milled.")));
    auto* show =
        button(tr("Show me"), "welcomeShowMeButton", tr("Watch a virtual operator mill the sample part."), "play");
    connect(show, &QPushButton::clicked, this, &WelcomePage::showMeRequested);
    layout->addWidget(offer(show, tr("A virtual operator mills the sample part before your eyes, eight times as fast "
                                     "as a hand.")));
    auto* project = button(tr("Open a project…"), "openProjectButton", tr("Open a .burin file."), "open");
    connect(project, &QPushButton::clicked, this, &WelcomePage::openRequested);
    layout->addWidget(offer(project, tr("Go on with a project that was saved.")));
    layout->addStretch(1);
    return box;
}

QWidget* WelcomePage::lately() {
    auto* box = new QWidget(this);
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    if (QLabel* picture = samplePicture(box)) {
        layout->addWidget(picture);
        layout->addSpacing(16);
    }
    leftBox_ = new QWidget(box);
    auto* left = new QVBoxLayout(leftBox_);
    left->setContentsMargins(0, 0, 0, 24);
    left->setSpacing(8);
    left->addWidget(heading(tr("Not saved"), leftBox_));
    left->addWidget(quiet(tr("Burin ended before this work was saved. Nothing of it is lost."), leftBox_));
    left_ = new QVBoxLayout;
    left_->setSpacing(4);
    left->addLayout(left_);
    leftBox_->hide();
    layout->addWidget(leftBox_);
    recentBox_ = new QWidget(box);
    auto* recent = new QVBoxLayout(recentBox_);
    recent->setContentsMargins(0, 0, 0, 0);
    recent->setSpacing(8);
    recent->addWidget(heading(tr("Recent projects"), recentBox_));
    recent_ = new QVBoxLayout;
    recent_->setSpacing(4);
    recent->addLayout(recent_);
    layout->addWidget(recentBox_);
    layout->addStretch(1);
    setRecentFiles({});
    return box;
}

void WelcomePage::setProject(const QString& title) {
    back_->setText(tr("Back to %1").arg(title));
    back_->setVisible(!title.isEmpty());
}

void WelcomePage::setRecentFiles(const QStringList& files) {
    empty(recent_);
    if (files.isEmpty()) recent_->addWidget(quiet(tr("Projects that you save are listed here."), recentBox_));
    for (const QString& file : files) {
        const QFileInfo info(file);
        auto* row = button(info.completeBaseName(), "recentFileButton", QDir::toNativeSeparators(file));
        row->setIcon(themedIcon(QStringLiteral("recent"), &Palette::quietText));
        row->setStyleSheet(QStringLiteral("text-align: left;"));
        connect(row, &QPushButton::clicked, this, [this, file] { emit recentChosen(file); });
        recent_->addWidget(row);
    }
}

void WelcomePage::setLeftWork(const std::vector<LeftWorkRow>& rows) {
    if (rows == leftRows_) return; // keeps the focus
    leftRows_ = rows;
    empty(left_);
    leftBox_->setVisible(!rows.empty());
    for (const LeftWorkRow& work : rows) {
        auto* row = new QWidget(leftBox_);
        auto* layout = new QHBoxLayout(row);
        layout->setContentsMargins(0, 0, 0, 0);
        layout->setSpacing(8);
        const QString changed = QLocale().toString(work.changed, QLocale::ShortFormat);
        layout->addWidget(new QLabel(changed, row), 1);
        auto* recover = button(tr("Recover"), "recoverButton", tr("Go on with this work."));
        connect(recover, &QPushButton::clicked, this, [this, work] { emit leftWorkChosen(work.file); });
        auto* forget = button(tr("Delete"), "forgetButton", tr("Delete this work for good."));
        forget->setFlat(true);
        connect(forget, &QPushButton::clicked, this, [this, work] { emit leftWorkForgotten(work.file); });
        for (QPushButton* each : {recover, forget}) {
            each->setAccessibleName(each->text() + QStringLiteral(", ") + changed);
            layout->addWidget(each);
        }
        left_->addWidget(row);
    }
}

} // namespace burin
