// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/kept_panel.h"

#include <epoxy/gl.h>
#include <imgui.h>
// After epoxy, which brings the OpenGL declarations.
#include <backends/imgui_impl_opengl3.h>

#include <string_view>

#include "app/window/theme.h"

namespace obscura::app::explorer {
namespace {

/// Numbers that change in a panel can be read no faster.
constexpr double kPictureFor_s = 0.25;

}  // namespace

KeptPanel::KeptPanel() = default;
KeptPanel::~KeptPanel() = default;

void KeptPanel::take_picture(const ImDrawData& frame, ImDrawList* list, const PanelPlace& panel) {
    const glm::vec2 size = panel.high - panel.low;
    if (!texture_ || size_px_ != glm::ivec2(size)) {
        size_px_ = glm::ivec2(size);
        texture_ = renderer::gl::Texture::make(static_cast<GLenum>(GL_TEXTURE_2D));
        glTextureStorage2D(texture_.name(), 1, GL_RGBA8, size_px_.x, size_px_.y);
        glTextureParameteri(texture_.name(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTextureParameteri(texture_.name(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        framebuffer_ = renderer::gl::Framebuffer::make();
        glNamedFramebufferTexture(framebuffer_.name(), GL_COLOR_ATTACHMENT0, texture_.name(), 0);
    }
    ImDrawData alone = frame;
    alone.CmdLists = &list;
    alone.CmdListsCount = 1;
    alone.DisplayPos = {panel.low.x, panel.low.y};
    alone.DisplaySize = {size.x, size.y};
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glDisable(GL_SCISSOR_TEST);
    const ImVec4& ground = window::theme::kCard;
    glClearColor(ground.x, ground.y, ground.z, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(&alone);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void KeptPanel::put_picture(ImDrawData& frame, const PanelPlace& panel, double now_s) {
    const glm::vec2 size = panel.high - panel.low;
    const bool one_to_one = frame.FramebufferScale.x == 1.0F && frame.FramebufferScale.y == 1.0F &&
                            size == glm::floor(size) && panel.low == glm::floor(panel.low);
    if (!one_to_one || size.x < 1.0F || size.y < 1.0F) return;
    for (int i = 0; i < frame.CmdListsCount; ++i) {
        ImDrawList*& list = frame.CmdLists[i];
        if (list->_OwnerName == nullptr || panel.name != std::string_view(list->_OwnerName)) {
            continue;
        }
        const bool fresh = made_s_ >= 0.0 && now_s - made_s_ < kPictureFor_s;
        if (!fresh || size_px_ != glm::ivec2(size)) {
            take_picture(frame, list, panel);
            made_s_ = now_s;
        }
        if (!picture_) picture_ = std::make_unique<ImDrawList>(ImGui::GetDrawListSharedData());
        picture_->_ResetForNewFrame();
        picture_->PushClipRect({panel.low.x, panel.low.y}, {panel.high.x, panel.high.y});
        picture_->PushTextureID(ImGui::GetIO().Fonts->TexID);
        picture_->AddCallback([](const ImDrawList*, const ImDrawCmd*) { glDisable(GL_BLEND); },
                              nullptr);
        // Upside down, as OpenGL has what was drawn.
        picture_->AddImage(reinterpret_cast<void*>(static_cast<std::uintptr_t>(texture_.name())),
                           {panel.low.x, panel.low.y}, {panel.high.x, panel.high.y}, {0.0F, 1.0F},
                           {1.0F, 0.0F});
        picture_->AddCallback([](const ImDrawList*, const ImDrawCmd*) { glEnable(GL_BLEND); },
                              nullptr);
        list = picture_.get();
        return;
    }
}

}  // namespace obscura::app::explorer
