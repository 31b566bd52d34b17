// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/base/interrupt.h"

#include <atomic>

namespace obscura::base {
namespace {

std::atomic<bool> g_interrupted = false;  // set by a signal handler, which has no other way

}  // namespace

StopOnInterrupt::StopOnInterrupt() {
    g_interrupted = false;
    struct sigaction action = {};
    action.sa_handler = [](int) { g_interrupted = true; };
    action.sa_flags = SA_RESETHAND;
    ::sigaction(SIGINT, &action, &before_);
}

StopOnInterrupt::~StopOnInterrupt() { ::sigaction(SIGINT, &before_, nullptr); }

bool StopOnInterrupt::asked() const { return g_interrupted; }

}  // namespace obscura::base
