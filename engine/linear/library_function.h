// Functions of libraries that this process may or may not have, looked up at run time so that none of them is linked.
#pragma once

#include <dlfcn.h>

namespace dda {

// Null where no loaded library has a function of this name; its type is the caller's to know.
template <typename Function>
Function* library_function(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));
}

}  // namespace dda
