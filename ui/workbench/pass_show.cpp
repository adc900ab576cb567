// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/pass_show.h"

namespace burin {

namespace {

constexpr int framePeriod = 40; // ms

} // namespace

PassShow::PassShow(const Desk& desk, const PassPreviewer& previewer, QObject* parent)
    : Controller(desk, parent), previewer_(previewer) {
    frames_.setInterval(framePeriod);
    connect(&frames_, &QTimer::timeout, this, &PassShow::advance);
    connect(&previewer_, &Controller::changed, this, &PassShow::followPreview);
}

void PassShow::start() {
    stop();
    waiting_ = true;
    if (!previewer_.busy()) begin();
}

void PassShow::stop() {
    if (!showing()) return;
    frames_.stop();
    film_.reset();
    waiting_ = false;
    emit finished();
}

void PassShow::followPreview() {
    if (!waiting_)
        stop();
    else if (!previewer_.busy())
        begin();
}

void PassShow::begin() {
    const PassPreview* preview = previewer_.preview();
    if (preview == nullptr || preview->strokes.empty()) return stop();
    waiting_ = false;
    film_.emplace(previewer_.leads(), preview->strokes);
    clock_.start();
    frames_.start();
    advance();
}

void PassShow::advance() {
    const double seconds = 0.001 * static_cast<double>(clock_.elapsed());
    if (seconds > film_->duration()) return stop();
    picture_ = film_->at(seconds);
    emit moved();
}

} // namespace burin
