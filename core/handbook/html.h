// SPDX-License-Identifier: GPL-3.0-or-later
// Pages of the handbook as HTML: for the window, and as files for a browser. Any thread.
#pragma once

#include "core/basics/result.h"
#include "core/handbook/handbook_speech.h"
#include "core/handbook/page.h"

namespace surefoot {

/// The page's title and text, well-formed as XML, without head and style. Links to other pages stay their names.
std::string htmlOf(const HandbookPage& page);

/// Every page as NAME.html, index.html with all of them, one style sheet and the pictures that they show, copied from
/// the folder `pictures`, into a folder that does not exist yet. `speech`: that of the handbook.
Status writeHtml(const Handbook& handbook, const std::string& pictures, const std::string& folder,
                 const HandbookSpeech& speech = {});

}  // namespace surefoot
