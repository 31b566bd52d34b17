// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/base/log.h"

#include <spdlog/sinks/stdout_color_sinks.h>

#include <memory>

namespace obscura::base {

void set_up_log(bool quiet) {
    auto sink = std::make_shared<spdlog::sinks::stderr_color_sink_mt>();
    auto logger = std::make_shared<spdlog::logger>("obscura", std::move(sink));
    logger->set_pattern("%^%v%$");
    logger->set_level(quiet ? spdlog::level::warn : spdlog::level::info);
    spdlog::set_default_logger(std::move(logger));
}

}  // namespace obscura::base
