// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Preloaded, it takes the place of the first calls of the libraries behind gamepads, SpaceMouse, pedal and sound, and
// takes the program down as a broken one would. With TACTOOTH_CRASHING_MIXER the sound library cannot even mix.
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
