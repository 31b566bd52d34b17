// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace obscura::app::explorer {

/// A value with what it was before and, after going back, what it was later. Changes that follow
/// each other under one name (a slider that is dragged) count as one, until settle() is called.
template <typename Value>
class History {
  public:
    static constexpr std::size_t kMost = 500;  ///< the oldest are forgotten

    explicit History(Value first) : values_{std::move(first)} {}

    [[nodiscard]] const Value& now() const { return values_[at_]; }
    [[nodiscard]] bool can_go_back() const { return at_ > 0; }
    [[nodiscard]] bool can_go_forward() const { return at_ + 1 < values_.size(); }

    /// Nothing where it equals what there is.
    void change(Value to, const std::string& name) {
        if (to == now()) return;
        values_.erase(values_.begin() + static_cast<std::ptrdiff_t>(at_) + 1, values_.end());
        if (!name.empty() && name == name_ && at_ > 0) {
            values_[at_] = std::move(to);
            return;
        }
        name_ = name;
        values_.push_back(std::move(to));
        if (values_.size() > kMost) values_.erase(values_.begin());
        at_ = values_.size() - 1;
    }
    void settle() { name_.clear(); }
    void go_back() {
        if (can_go_back()) --at_;
        settle();
    }
    void go_forward() {
        if (can_go_forward()) ++at_;
        settle();
    }

  private:
    std::vector<Value> values_;
    std::size_t at_ = 0;
    std::string name_;  ///< of the change that made what there is
};

}  // namespace obscura::app::explorer
