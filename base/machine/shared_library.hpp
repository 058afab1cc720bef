#pragma once

#include <string>

namespace palpate::base {

/// A library that is loaded when something needs it, and stays until the program ends: most commands need none of
/// those that take long to load.
class SharedLibrary {
 public:
  /// @param file     as the system's loader finds it: "libOSMesa.so.8"
  /// @param package  of Debian, that has it
  /// @param without  what cannot be done without it, a sentence: "nothing can be drawn"
  /// Throws std::runtime_error that says all three where it cannot be loaded.
  SharedLibrary(const char* file, const char* package, const char* without);

  /// Sets a pointer to the function of a name. Throws std::runtime_error where the library has none.
  template <class Function>
  void find(const char* name, Function& function) const {
    function = reinterpret_cast<Function>(address(name));
  }

 private:
  void* address(const char* name) const;

  std::string file_, without_;
  void* library_ = nullptr;
};

}  // namespace palpate::base
