#pragma once
// What SUNDIALS 5 (Ubuntu 22.04), 6 (Debian 12) and 7 write differently.

#include <sundials/sundials_config.h>
#include <sundials/sundials_types.h>
#if SUNDIALS_VERSION_MAJOR >= 6
#include <sundials/sundials_context.h>
#endif

namespace tribolog::simulate {

#if SUNDIALS_VERSION_MAJOR >= 6

using SunReal = sunrealtype;

/// What every constructor of SUNDIALS 6 and newer takes last: `, TRIBOLOG_SUN(context)` there,
/// nothing in SUNDIALS 5.
#define TRIBOLOG_SUN(context) , (context).get()

class SunContext {
 public:
  SunContext() {
#if SUNDIALS_VERSION_MAJOR >= 7
    SUNContext_Create(SUN_COMM_NULL, &context_);
#else
    SUNContext_Create(nullptr, &context_);
#endif
  }
  ~SunContext() { SUNContext_Free(&context_); }
  SunContext(const SunContext&) = delete;
  SunContext& operator=(const SunContext&) = delete;

  [[nodiscard]] SUNContext get() const { return context_; }

 private:
  SUNContext context_{};
};

#else

using SunReal = realtype;
#define TRIBOLOG_SUN(context)
class [[maybe_unused]] SunContext {};

#endif

}  // namespace tribolog::simulate
