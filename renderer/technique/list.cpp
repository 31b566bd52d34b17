// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/technique/list.h"

#include "renderer/technique/technique.h"

namespace obscura::renderer {

const std::vector<Technique>& techniques() {
    static const std::vector<Technique> list = {
        make_none(), make_crytek(), make_blizzard(), make_raymarch(), make_reference(),
    };
    return list;
}

}  // namespace obscura::renderer
