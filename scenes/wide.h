// SPDX-License-Identifier: Apache-2.0
#pragma once

/// For functions whose loops over lanes the compiler turns into vector instructions: compiled once
/// for the widest registers known here and once for any x86-64, chosen when the program starts.
/// Loops over lanes are marked `GCC ivdep`, since lanes never depend on each other. No
/// fused operations (see CMakeLists.txt): both give the same bits. Clang takes vectors passed
/// between such a function and those that it inlines for an error: it compiles one for any x86-64.
#if defined(__x86_64__) && !defined(__clang__)
#define PLUMBLINE_WIDE [[gnu::target_clones("avx2", "default")]]
#else
#define PLUMBLINE_WIDE
#endif
