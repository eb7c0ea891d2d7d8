// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Preloaded, this library replaces the first calls of the libraries for gamepads, SpaceMouse, pedal and sound. It
// crashes the program as a broken library would. With TACTOOTH_CRASHING_MIXER the sound library cannot even mix.
#include <csignal>

extern "C" {

int SDL_InitSubSystem(unsigned) { return std::raise(SIGSEGV); }
int spnav_open() { return std::raise(SIGSEGV); }
void* alcOpenDevice(const char*) {
    std::raise(SIGSEGV);
    return nullptr;
}
#ifdef TACTOOTH_CRASHING_MIXER
void* alcGetProcAddress(void*, const char*) {
    std::raise(SIGSEGV);
    return nullptr;
}
#endif
}
