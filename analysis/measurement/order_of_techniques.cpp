// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/measurement/order_of_techniques.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace obscura::analysis {
namespace {

/// From the least to the most accurate by assumption, with the papers' samples.
struct Assumed {
    const char* technique;
    int samples;
};
constexpr std::array kAssumed{Assumed{"crytek", 24}, Assumed{"blizzard", 24},
                              Assumed{"raymarch", 30}};

const MeasurementRow* find_row(const std::vector<MeasurementRow>& rows, const MeasurementRow& view,
                               const Assumed& wanted, const std::string& denoise, bool fitted) {
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const MeasurementRow& row) {
        return same_view(row, view) && row.technique == wanted.technique &&
               row.samples == wanted.samples && row.denoise == denoise && row.fitted == fitted &&
               row.options == view.options && row.error.has_value();
    });
    return found == rows.end() ? nullptr : &*found;
}

/// False where one of the three has no row.
bool fill(OrderOfTechniques& order, const std::vector<MeasurementRow>& rows,
          const MeasurementRow& view, const std::string& denoise) {
    std::vector<std::pair<double, std::string>> found;
    for (const Assumed& wanted : kAssumed) {
        const MeasurementRow* row = find_row(rows, view, wanted, denoise, order.fitted);
        if (row == nullptr) return false;
        found.emplace_back(row->error->rmse, row->variant);
    }
    order.as_assumed = found[2].first <= found[1].first && found[1].first <= found[0].first;
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::string listed;
    for (const auto& [rmse, variant] : found) {
        order.by_error.push_back(variant);
        order.rmse.push_back(rmse);
        listed += fmt::format("{}{} ({:.4f})", listed.empty() ? "" : ", ", variant, rmse);
    }
    order.sentence = fmt::format(
        "{}, {}: from the smallest RMSE {}; this is {}the order that the thesis assumes.",
        order.view, order.fitted ? "fitted" : "as published", listed,
        order.as_assumed ? "" : "not ");
    return true;
}

}  // namespace

std::vector<OrderOfTechniques> orders_of_techniques(const std::vector<MeasurementRow>& rows,
                                                    const std::string& denoise) {
    std::vector<OrderOfTechniques> orders;
    for (auto row = rows.begin(); row != rows.end(); ++row) {
        const bool seen = std::any_of(rows.begin(), row, [&](const MeasurementRow& before) {
            return same_view(before, *row);
        });
        if (seen) continue;
        for (const bool fitted : {false, true}) {
            OrderOfTechniques order;
            order.view = view_name(*row);
            order.fitted = fitted;
            if (fill(order, rows, *row, denoise)) orders.push_back(std::move(order));
        }
    }
    return orders;
}

std::string order_in_a_sentence(const std::vector<OrderOfTechniques>& orders) {
    const auto said = [&orders](bool fitted) {
        const auto of_kind = [fitted](const auto& order) { return order.fitted == fitted; };
        const auto all = std::count_if(orders.begin(), orders.end(), of_kind);
        const auto held = std::count_if(orders.begin(), orders.end(), [&](const auto& order) {
            return of_kind(order) && order.as_assumed;
        });
        if (all == 0) return std::string("was not measured");
        return fmt::format("holds in {} of {} view{}", held, all, all == 1 ? "" : "s");
    };
    return fmt::format(
        "The thesis assumes that accuracy rises from Crytek24 over Blizzard24 to RayMarching30. "
        "Measured against the ray-traced truth, this order {} as published, and {} when each is "
        "fitted.",
        said(false), said(true));
}

}  // namespace obscura::analysis
