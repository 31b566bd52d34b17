// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/canvas.h"

#include <epoxy/gl.h>
#include <imgui.h>
// After epoxy, which brings the OpenGL declarations.
#include <backends/imgui_impl_opengl3.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string_view>

namespace obscura::app::explorer {
namespace {

using Area = Canvas::Area;

[[nodiscard]] Area both(const Area& a, const Area& b) {
    return {glm::max(a.low, b.low), glm::min(a.high, b.high)};
}

/// Of a command, whole pixels.
[[nodiscard]] Area area_of(const ImVec4& clip, float scale) {
    return {glm::ivec2(glm::floor(scale * glm::vec2(clip.x, clip.y))),
            glm::ivec2(glm::ceil(scale * glm::vec2(clip.z, clip.w)))};
}

[[nodiscard]] ImVec4 clip_of(const Area& area, float scale) {
    const glm::vec2 low = glm::vec2(area.low) / scale;
    const glm::vec2 high = glm::vec2(area.high) / scale;
    return {low.x, low.y, high.x, high.y};
}

void add(std::size_t& hash, const void* bytes, std::size_t count) {
    const std::string_view text(static_cast<const char*>(bytes), count);
    hash = hash * 1099511628211U ^ std::hash<std::string_view>{}(text);
}

[[nodiscard]] Canvas::Drawn drawn_of(const ImDrawList& list, float scale, glm::ivec2 size_px) {
    Canvas::Drawn drawn;
    drawn.name = list._OwnerName != nullptr ? list._OwnerName : "";
    add(drawn.looks, list.VtxBuffer.Data, static_cast<std::size_t>(list.VtxBuffer.size_in_bytes()));
    add(drawn.looks, list.IdxBuffer.Data, static_cast<std::size_t>(list.IdxBuffer.size_in_bytes()));
    bool any = false;
    for (const ImDrawCmd& command : list.CmdBuffer) {
        add(drawn.looks, &command.ClipRect, sizeof command.ClipRect);
        add(drawn.looks, &command.ElemCount, sizeof command.ElemCount);
        if (command.UserCallback != nullptr) drawn.pictures = true;
        if (command.UserCallback != nullptr || command.ElemCount == 0) continue;
        if (command.TextureId != ImGui::GetIO().Fonts->TexID) drawn.pictures = true;
        const Area area = both(area_of(command.ClipRect, scale), {{0, 0}, size_px});
        if (area.empty()) continue;
        drawn.area =
            any ? Area{glm::min(drawn.area.low, area.low), glm::max(drawn.area.high, area.high)}
                : area;
        any = true;
    }
    return drawn;
}

/// All lists, where they are within the area.
void draw_within(ImDrawData& data, const Area& area, int height_px, const glm::vec3& ground) {
    const float scale = data.FramebufferScale.x;
    glEnable(GL_SCISSOR_TEST);
    glScissor(area.low.x, height_px - area.high.y, area.high.x - area.low.x,
              area.high.y - area.low.y);
    glClearColor(ground.r, ground.g, ground.b, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
    std::vector<ImVec4> clips;
    for (int i = 0; i < data.CmdListsCount; ++i) {
        for (ImDrawCmd& command : data.CmdLists[i]->CmdBuffer) {
            clips.push_back(command.ClipRect);
            command.ClipRect = clip_of(both(area_of(command.ClipRect, scale), area), scale);
        }
    }
    ImGui_ImplOpenGL3_RenderDrawData(&data);
    auto clip = clips.begin();
    for (int i = 0; i < data.CmdListsCount; ++i) {
        for (ImDrawCmd& command : data.CmdLists[i]->CmdBuffer) command.ClipRect = *clip++;
    }
}

}  // namespace

std::vector<Area> Canvas::changed(const std::vector<Drawn>& before, const std::vector<Drawn>& now,
                                  glm::ivec2 size_px) {
    const Area all{{0, 0}, size_px};
    const bool same_windows =
        std::equal(before.begin(), before.end(), now.begin(), now.end(),
                   [](const Drawn& a, const Drawn& b) { return a.name == b.name; });
    if (!same_windows) return {all};
    std::vector<Area> areas;
    for (std::size_t i = 0; i < now.size(); ++i) {
        const bool same = before[i].looks == now[i].looks && before[i].area == now[i].area;
        if (same && !now[i].pictures) continue;
        for (const Area& area : {before[i].area, now[i].area}) {
            if (area.empty() || std::find(areas.begin(), areas.end(), area) != areas.end())
                continue;
            areas.push_back(area);
        }
    }
    return areas;
}

void Canvas::show(ImDrawData& data, glm::ivec2 size_px, const glm::vec3& ground) {
    if (size_px.x < 1 || size_px.y < 1) return;
    if (size_px != size_px_ || !texture_) {
        texture_ = renderer::gl::Texture::make(static_cast<GLenum>(GL_TEXTURE_2D));
        glTextureStorage2D(texture_.name(), 1, GL_RGBA8, size_px.x, size_px.y);
        framebuffer_ = renderer::gl::Framebuffer::make();
        glNamedFramebufferTexture(framebuffer_.name(), GL_COLOR_ATTACHMENT0, texture_.name(), 0);
        size_px_ = size_px;
        forget();
    }
    std::vector<Drawn> now;
    for (int i = 0; i < data.CmdListsCount; ++i) {
        now.push_back(drawn_of(*data.CmdLists[i], data.FramebufferScale.x, size_px));
    }
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glViewport(0, 0, size_px.x, size_px.y);
    for (const Area& area : changed(drawn_, now, size_px)) {
        draw_within(data, area, size_px.y, ground);
    }
    drawn_ = std::move(now);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glBlitNamedFramebuffer(framebuffer_.name(), 0, 0, 0, size_px.x, size_px.y, 0, 0, size_px.x,
                           size_px.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

}  // namespace obscura::app::explorer
