// Macro that exports a function from the library, so that Python can call it.
#pragma once

#if defined(_WIN32)
#define BONDEM_EXPORT extern "C" __declspec(dllexport)
#else
#define BONDEM_EXPORT extern "C" __attribute__((visibility("default")))
#endif
