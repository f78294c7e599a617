// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/data/page_frame.hpp"

// The assembler copies the file's bytes in, which a compiler given them as an array would take minutes over.
asm(R"(
.section .rodata
.global handhold_page_frame_begin
.global handhold_page_frame_end
handhold_page_frame_begin:
.incbin ")" HANDHOLD_PAGE_FRAME R"("
handhold_page_frame_end:
.previous
)");

extern "C" {
extern const char handhold_page_frame_begin[], handhold_page_frame_end[];
}

namespace handhold::reports {

std::string_view page_frame() {
  return {handhold_page_frame_begin, std::size_t(handhold_page_frame_end - handhold_page_frame_begin)};
}

}  // namespace handhold::reports
