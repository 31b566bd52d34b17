// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "renderer/gl/handles.h"

namespace obscura::renderer::gl {

/// Moments of the GPU's own clock (GL_TIMESTAMP), in the order in which they were marked. Needs a
/// current context for as long as it lives.
class TimestampQueries {
  public:
    explicit TimestampQueries(std::size_t count) { queries_.reserve(count); }

    void mark() {
        queries_.push_back(Query::make(static_cast<GLenum>(GL_TIMESTAMP)));
        glQueryCounter(queries_.back().name(), GL_TIMESTAMP);
    }

    /// From one mark to a later one; waits until the GPU has passed both.
    [[nodiscard]] double milliseconds(std::size_t from, std::size_t to) const {
        return (nanoseconds(to) - nanoseconds(from)) * 1e-6;
    }

  private:
    [[nodiscard]] double nanoseconds(std::size_t index) const {
        GLuint64 value = 0;
        glGetQueryObjectui64v(queries_.at(index).name(), GL_QUERY_RESULT, &value);
        return static_cast<double>(value);
    }

    std::vector<Query> queries_;
};

}  // namespace obscura::renderer::gl
