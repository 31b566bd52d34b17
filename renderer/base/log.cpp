// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/base/log.h"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <memory>

#include "renderer/base/colour.h"

namespace obscura::base::log {

void set_up(bool quiet) {
    auto sink = std::make_shared<spdlog::sinks::stderr_color_sink_mt>();
    if (!shows_colour()) sink->set_color_mode(spdlog::color_mode::never);
    auto logger = std::make_shared<spdlog::logger>("obscura", std::move(sink));
    logger->set_pattern("%^%v%$");
    logger->set_level(quiet ? spdlog::level::warn : spdlog::level::info);
    spdlog::set_default_logger(std::move(logger));
}

void say(Level level, const std::string& line) {
    switch (level) {
        case Level::kInfo:
            return spdlog::default_logger_raw()->log(spdlog::level::info, line);
        case Level::kWarning:
            return spdlog::default_logger_raw()->log(spdlog::level::warn, line);
        case Level::kError:
            return spdlog::default_logger_raw()->log(spdlog::level::err, line);
    }
}

}  // namespace obscura::base::log
