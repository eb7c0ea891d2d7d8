// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <exception>
#include <new>
#include <span>
#include <stdexcept>
#include <string>

#include "app/cli/command_line.h"
#include "app/cli/terminal/too_large_message.h"
#include "app/common/exit_code.h"
#include "app/common/messages.h"
#include "app/common/termination.h"

namespace {

using namespace tactooth;

int refuseTooLarge(int argc, char** argv) {
    return reportError(tooLargeMessage(std::span<const char* const>(argv, static_cast<std::size_t>(argc))));
}

int run(int argc, char** argv) {
    try {
        return runCommandLine(argc, argv);
    } catch (const std::bad_alloc&) {
        return refuseTooLarge(argc, argv);
    } catch (const std::length_error&) {  // more than any memory
        return refuseTooLarge(argc, argv);
    } catch (const std::exception& exception) {
        return reportError({msg::kUnforeseen, exception.what()});
    }
}

}  // namespace

int main(int argc, char** argv) {
    installTerminationHandlers();
    return exitAsRequested(run(argc, argv));
}
